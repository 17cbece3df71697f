//! Light is a number: no NaN, no infinity and nothing below zero, wherever a camera stands and looks, for every
//! built-in preset. Each preset is a test of its own; a new preset is counted by being there.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]
#![allow(clippy::print_stdout, reason = "these tests show their numbers")]

#[path = "accuracy/harness.rs"]
#[allow(dead_code, reason = "shared with the tests of functions")]
mod harness;

use std::process::ExitCode;

use harness::{Report, Scope, values};
use libtest_mimic::{Arguments, Trial};
use orogen::source::preset_names;
use orogen::{Bake, Compose, Library, Preset};
use truth::points::Random;

/// Cameras from 12 km below the sea to 100 km above and away.
const CAMERAS: usize = 1000;
/// And from there to 20,000 km, up and around the planet.
const FAR_CAMERAS: usize = 400;
/// Looks of each camera: the exact directions in which formulas break, and some by chance.
const LOOKS: usize = 9;

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let trial = |name: &'static str| {
        Trial::test(format!("the_light_of_{name}_is_a_number_from_everywhere"), move || {
            count(name);
            Ok(())
        })
    };
    libtest_mimic::run(&arguments, preset_names().into_iter().map(trial).collect()).exit_code()
}

/// What a camera's height is counted from.
#[derive(Clone, Copy, PartialEq)]
enum Above {
    Ground,
    Sea,
}

/// Where a camera stands.
fn camera(random: &mut Random, index: usize) -> ([f32; 3], Above) {
    use Above::{Ground, Sea};
    let [x, z] = random.point::<2>([30.0, 3e3, 3e4][index / 12 % 3]);
    let (above, from) = match index % 12 {
        0 => (0.0, Ground),                           // on it, exactly
        1 | 2 => (random.within(0.001, 3.0), Ground), // as people stand
        3 => (random.within(3.0, 3e3), Ground),       // as birds fly
        4 => (random.within(-3.0, 0.0), Ground),
        5 => (random.within(-2e3, -3.0), Ground), // inside of a hill
        6 => (random.within(-60.0, 0.0), Sea),    // under water, where there is any
        7 => (random.within(0.0, 60.0), Sea),
        8 => (random.within(-1.2e4, -60.0), Sea), // below everything
        9 => (1e5, Sea),
        10 => {
            // 100 km away, in any direction.
            let turn = random.within(0.0, std::f32::consts::TAU);
            let place = [1e5 * turn.cos(), random.within(-100.0, 3e3), 1e5 * turn.sin()];
            return (place, if index % 24 == 10 { Ground } else { Sea });
        }
        _ => return ([0.0, random.within(-2.0, 2.0), 0.0], Ground), // in the middle of the world
    };
    ([x, above, z], from)
}

/// Radius of the planet that far cameras are put around (m): Earth's, near enough for all that have another one.
const PLANET: f32 = 6.36e6;

/// Where a far camera stands.
fn far_camera(random: &mut Random, index: usize) -> [f32; 3] {
    // As likely between 1 and 2 km as between 10,000 and 20,000.
    let mut height = |low: f32, high: f32| low * (high / low).powf(random.within(0.0, 1.0));
    let (up, near, away) = (height(1e5, 2e7), height(9e4, 1.1e5), height(100.0, 2e7));
    let [x, z] = random.point::<2>(3e4);
    match index % 5 {
        0 => [x, up, z],
        1 => [0.0, [1e5, 1e6, 2e7][index / 5 % 3], 0.0],
        2 => [x, near, z], // where the air ends
        3 => {
            let turn = random.within(0.0, std::f32::consts::TAU);
            [up * turn.cos(), random.within(-100.0, 1e6), up * turn.sin()]
        }
        _ => {
            let from_center = unit(random.point::<3>(1.0)).map(|part| (PLANET + away) * part);
            [from_center[0], from_center[1] - PLANET, from_center[2]]
        }
    }
}

/// Where a far camera looks: at the planet and past it.
fn far_direction(random: &mut Random, look: usize, position: [f32; 3], sun: [f32; 3]) -> [f32; 3] {
    if look < 5 {
        return direction(random, look, sun);
    }
    let center = [-position[0], -PLANET - position[1], -position[2]];
    let aside = unit(random.point::<3>(1.0));
    let [ahead, beside] = [unit(center), aside];
    let along: f32 = (0..3).map(|i| ahead[i] * beside[i]).sum();
    let across = unit([0, 1, 2].map(|i| beside[i] - along * ahead[i]));
    let off = PLANET
        * match look {
            5 => 0.0,
            6 => random.within(0.98, 1.0),   // its edge
            7 => random.within(1.0, 1.0201), // its air
            _ => random.within(0.0, 2.0),
        };
    unit([0, 1, 2].map(|i| center[i] + off * across[i]))
}

/// Where it looks.
fn direction(random: &mut Random, look: usize, sun: [f32; 3]) -> [f32; 3] {
    match look {
        0 => [0.0, 1.0, 0.0],
        1 => [0.0, -1.0, 0.0],
        2 => sun,
        3 => sun.map(|part| -part),
        4 => {
            const LEVEL: [[f32; 3]; 4] =
                [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
            LEVEL[random.bits() as usize % 4]
        }
        5 => unit([random.within(-1.0, 1.0), 0.0, random.within(-1.0, 1.0)]),
        6 => unit([random.within(-1.0, 1.0), random.within(-0.02, 0.02), random.within(-1.0, 1.0)]),
        _ => unit(random.point::<3>(1.0)),
    }
}

fn unit(v: [f32; 3]) -> [f32; 3] {
    let length = v.iter().map(|part| f64::from(*part).powi(2)).sum::<f64>().sqrt();
    if length < 1e-6 { [0.0, 0.0, -1.0] } else { v.map(|part| (f64::from(part) / length) as f32) }
}

/// Counts what is no light.
fn count(name: &'static str) {
    let preset = Preset::named(name).unwrap();
    let scope = Scope { preset: Some(&preset), ..Scope::default() };
    let mut compose = Compose::default();
    compose.keep_unused = true;
    let shader = compose.run(&Library::standard(), &preset, &Bake::constants()).unwrap();
    let has = |function: &str| shader.wgsl().contains(&format!("fn {function}("));
    let sun =
        if has("sun_direction") { harness::value("sun_direction()", &scope) } else { vec![0.6, 0.0, 0.8] };
    let sun = [0, 1, 2].map(|axis| sun[axis] as f32);

    let mut random = Random::new(name.bytes().fold(7, |seed, byte| seed * 31 % 65_521 + u32::from(byte)));
    let mut points = Vec::with_capacity(CAMERAS * LOOKS);
    for index in 0..CAMERAS {
        let ([x, y, z], from) = camera(&mut random, index);
        for look in 0..LOOKS {
            let [dx, dy, dz] = direction(&mut random, look, sun);
            let above_ground = if from == Above::Ground { 1.0 } else { 0.0 };
            points.push([x, y, z, dx, dy, dz, above_ground]);
        }
    }
    for index in 0..FAR_CAMERAS {
        let position = far_camera(&mut random, index);
        for look in 0..LOOKS {
            let [dx, dy, dz] = far_direction(&mut random, look, position, sun);
            points.push([position[0], position[1], position[2], dx, dy, dz, 0.0]);
        }
    }
    // Heights are counted from the ground, where there is any.
    let origin = if has("terrain_height") {
        "vec3f(x, y + above_ground * terrain_height(vec2f(x, z)), z)"
    } else {
        "vec3f(x, y, z)"
    };
    let call = format!("scene_trace({origin}, vec3f(dx, dy, dz))");
    let rows = values(&call, &scope, ["x", "y", "z", "dx", "dy", "dz", "above_ground"], &points);
    assert_eq!(rows.len(), (CAMERAS + FAR_CAMERAS) * LOOKS);

    let wrong = |bad: fn(&f64) -> bool| {
        let all = rows.iter().zip(&points).filter(|(row, _)| row.iter().any(bad));
        for (row, point) in all.clone().take(5) {
            println!("{name}: {point:?} gives {row:?}");
        }
        all.count() as f64
    };
    let test: &'static str = format!("the_light_of_{name}_is_a_number_from_everywhere").leak();
    let mut report = Report::new("Light from everywhere", test);
    let rays = rows.len();
    report.at_most(
        &format!("`{name}`: NaN, of {rays} rays of {} cameras", CAMERAS + FAR_CAMERAS),
        wrong(|v| v.is_nan()),
        0.0,
    );
    report.at_most(&format!("`{name}`: infinite"), wrong(|v| v.is_infinite()), 0.0);
    report.at_most(&format!("`{name}`: negative radiance or distance"), wrong(|v| *v < 0.0), 0.0);
    // That nothing is counted must not be because nothing was there to count. From far away, it is mostly space.
    let is_lit = |row: &&Vec<f64>| row.iter().take(3).sum::<f64>() > 0.0;
    let near = &rows[..CAMERAS * LOOKS];
    let lit = near.iter().filter(is_lit).count() as f64 / near.len() as f64;
    report.at_least(&format!("`{name}`: part of the rays below 100 km that see light"), lit, 0.25);
    report.finish();
}
