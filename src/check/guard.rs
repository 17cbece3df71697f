//! Runs naga where it can do no harm: on a deep stack, and with its panics caught.
//!
//! naga's writers panic on some valid inputs, and several of its passes recurse as deep as expressions nest. Neither may
//! bring the process down. The stack is grown on the thread that asks: on a thread of its own, naga's many small
//! allocations would start from a cold heap every time, which costs a tenth of a large shader's checking.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Address space, not memory: pages are taken as they are touched.
const STACK: usize = 256 << 20;

thread_local! {
    static GUARDING: Cell<bool> = const { Cell::new(false) };
}

/// What went wrong inside.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Panicked(pub String);

/// Whether a panic on this thread would come back as an error: a panic hook may keep quiet about it.
pub fn is_guarded() -> bool {
    GUARDING.get()
}

/// The result of `work`, or what it panicked with. Whatever `work` has changed when it panics must not be used again.
pub(crate) fn guarded<T>(work: impl FnOnce() -> T) -> Result<T, Panicked> {
    let outer = GUARDING.replace(true);
    let outcome = catch_unwind(AssertUnwindSafe(|| stacker::grow(STACK, work)));
    GUARDING.set(outer);
    outcome.map_err(|payload| {
        let text = payload.downcast_ref::<String>().cloned();
        let text = text.or_else(|| payload.downcast_ref::<&str>().map(|text| (*text).to_owned()));
        Panicked(text.unwrap_or_else(|| "no reason given".into()))
    })
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
