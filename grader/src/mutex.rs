//! What threads share. A mutex that a thread held when it panicked ("poisoned") is locked like any other: all that is kept in one
//! here is valid after each statement, and the panic itself is told elsewhere.

use std::sync::{Mutex, MutexGuard, PoisonError};

/// Waits for the mutex and locks it.
pub fn lock<T: ?Sized>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What a mutex held that nobody shares any more.
pub fn into_inner<T>(mutex: Mutex<T>) -> T {
    mutex.into_inner().unwrap_or_else(PoisonError::into_inner)
}
