//! Calls that may panic, for they are given what makes no sense: a question that was misread, a step with a wrong value.

use std::cell::Cell;
use std::panic::{self, AssertUnwindSafe, catch_unwind};
use std::sync::Once;

thread_local! {
    /// Whether a panic on this thread is expected, and nobody's news.
    static IS_EXPECTED: Cell<bool> = const { Cell::new(false) };
}

/// What a call returns; none if it panics, of which nothing is printed.
pub fn attempt<T>(call: impl FnOnce() -> T) -> Option<T> {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let others = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            if !IS_EXPECTED.get() {
                others(info);
            }
        }));
    });
    let before = IS_EXPECTED.replace(true);
    let result = catch_unwind(AssertUnwindSafe(call));
    IS_EXPECTED.set(before);
    result.ok()
}
