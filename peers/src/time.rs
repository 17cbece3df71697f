//! Contestants that take turns → medians and quartiles of their times.
//!
//! A busy machine slows all of them, run by run; CPU time of the process is the steadier number, wall time stands beside it.

use std::hint::black_box;
use std::time::{Duration, Instant};

use cpu_time::ProcessTime;

use crate::Outcome;

/// How long one run took (ms).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spent {
    pub(crate) cpu: f64,
    pub(crate) wall: f64,
}

/// The middle half of some numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Quartiles {
    pub(crate) low: f64,
    pub(crate) median: f64,
    pub(crate) high: f64,
}

/// All runs of one contestant.
#[derive(Clone, Debug, Default)]
pub(crate) struct Runs(Vec<Spent>);

/// What one contestant does in its turn, given the number of the round.
pub(crate) type Turn<'a> = Box<dyn FnMut(usize) -> Outcome<Spent> + 'a>;

impl Runs {
    pub(crate) fn cpu(&self) -> Quartiles {
        quartiles(self.0.iter().map(|spent| spent.cpu))
    }

    pub(crate) fn wall(&self) -> Quartiles {
        quartiles(self.0.iter().map(|spent| spent.wall))
    }
}

/// Times `work`; what it makes is dropped after the clock has stopped.
pub(crate) fn timed<T>(work: impl FnOnce() -> Outcome<T>) -> Outcome<Spent> {
    let (cpu, wall) = (ProcessTime::now(), Instant::now());
    let made = work();
    let spent = Spent { cpu: ms(cpu.elapsed()), wall: ms(wall.elapsed()) };
    black_box(made?);
    Ok(spent)
}

/// Lets all of `turns` run `most` times in turn, fewer where that would take longer than `budget`, but `least` times. A first
/// round that is short is not counted: it fills caches that later ones find full.
pub(crate) fn interleaved(
    turns: &mut [Turn<'_>],
    (least, most): (usize, usize),
    budget: Duration,
) -> Outcome<Vec<Runs>> {
    const SHORT: Duration = Duration::from_secs(2);
    let start = Instant::now();
    let mut runs = vec![Runs::default(); turns.len()];
    for round in 0..=most {
        let enough = runs.iter().all(|runs| runs.0.len() >= least);
        if enough && start.elapsed() > budget {
            break;
        }
        for (turn, runs) in turns.iter_mut().zip(&mut runs) {
            runs.0.push(turn(round)?);
        }
        if round == 0 && start.elapsed() < SHORT {
            runs.iter_mut().for_each(|runs| runs.0.clear());
        }
    }
    Ok(runs)
}

/// The quartiles of `values`, interpolated between neighbours.
pub(crate) fn quartiles(values: impl Iterator<Item = f64>) -> Quartiles {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    let at = |part: f64| {
        let place = part * values.len().saturating_sub(1) as f64;
        let value = |index: usize| values.get(index).copied().unwrap_or(f64::NAN);
        let (below, above) = (value(place.floor() as usize), value(place.ceil() as usize));
        below + (above - below) * place.fract()
    };
    Quartiles { low: at(0.25), median: at(0.5), high: at(0.75) }
}

fn ms(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quartiles_lie_between_neighbours() {
        let of = |values: &[f64]| quartiles(values.iter().copied());
        assert_eq!(of(&[4.0, 1.0, 3.0, 2.0, 5.0]), Quartiles { low: 2.0, median: 3.0, high: 4.0 });
        assert_eq!(of(&[1.0, 2.0]), Quartiles { low: 1.25, median: 1.5, high: 1.75 });
        assert!(of(&[]).median.is_nan());
    }
}
