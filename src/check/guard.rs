//! Runs naga where it can do no harm: on a thread of its own, with a deep stack, and with its panics caught.
//!
//! naga's writers panic on some valid inputs, and several of its passes recurse as deep as expressions nest. Neither may
//! bring the process down.

/// The name of the threads that a panic hook may keep quiet about: what happened there comes back as an error.
pub const GUARDED: &str = "orogen-naga";

/// Address space, not memory: pages are taken as they are touched.
const STACK: usize = 256 << 20;

/// What went wrong inside.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Panicked(pub String);

/// The result of `work`, or what it panicked with.
pub(crate) fn guarded<T: Send>(work: impl FnOnce() -> T + Send) -> Result<T, Panicked> {
    let outcome = std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().name(GUARDED.into()).stack_size(STACK);
        match thread.spawn_scoped(scope, work) {
            Ok(handle) => handle.join().map_err(|payload| {
                let text = payload.downcast_ref::<String>().cloned();
                let text = text.or_else(|| payload.downcast_ref::<&str>().map(|text| (*text).to_owned()));
                text.unwrap_or_else(|| "no reason given".into())
            }),
            Err(error) => Err(format!("no thread could be started: {error}")),
        }
    });
    outcome.map_err(Panicked)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_comes_back_as_a_value() {
        assert_eq!(guarded(|| 7), Ok(7));
        let caught = guarded(|| -> i32 { panic!("index {}", 3) });
        assert_eq!(caught, Err(Panicked("index 3".into())));
    }
}
