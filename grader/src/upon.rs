//! One mistake made upon another: a program that has both.
//!
//! Most mistakes are made of something right: of the right answer ([`Graded::right`]), or of the settings of a function that goes right
//! ([`changed`]). While the first of two is tried, both give what the second makes. They are for mistakes only, and never for a judge.

use crate::{Graded, Mistake};
use std::any::Any;
use std::cell::{Cell, RefCell};

thread_local! {
    /// The mistake whose answer is given for the right one.
    static OTHER: Cell<Option<&'static dyn Any>> = const { Cell::new(None) };
    /// The settings that are given for the right ones.
    static GIVEN: RefCell<Option<Box<dyn Any>>> = const { RefCell::new(None) };
    /// The settings that were made last.
    static MADE: RefCell<Option<Box<dyn Any>>> = const { RefCell::new(None) };
    /// Whether anybody has asked for the other's answer, or for its settings.
    static IS_ASKED: Cell<bool> = const { Cell::new(false) };
}

/// While it lives, another mistake is given for what is right; a panic ends it, too.
struct Giving;

impl Drop for Giving {
    fn drop(&mut self) {
        OTHER.set(None);
        GIVEN.set(None);
        MADE.set(None);
    }
}

/// What is answered by one who makes the mistake `first` upon the mistake `second`, and whether `first` is made of anything that
/// `second` changes.
pub fn upon<E: Graded>(
    first: &'static Mistake<E>,
    second: &'static Mistake<E>,
    question: &E,
) -> (E::Answer, bool) {
    let _giving = Giving;
    (second.answer)(question);
    GIVEN.set(MADE.take());
    IS_ASKED.set(false);
    OTHER.set(Some(second));
    let answer = (first.answer)(question);
    (answer, IS_ASKED.get())
}

/// The answer of the mistake that is given for the right one, if there is one.
pub(crate) fn answer<E: Graded>(question: &E) -> Option<E::Answer> {
    let other = OTHER.take()?;
    // What the other is made of itself is right.
    let given = GIVEN.take();
    let mistake = other.downcast_ref::<Mistake<E>>();
    let answer = mistake.map(|mistake| (mistake.answer)(question));
    if answer.is_some() {
        IS_ASKED.set(true);
    }
    OTHER.set(Some(other));
    GIVEN.set(given);
    answer
}

/// The right settings with a change, which makes a mistake.
pub fn changed<S: Copy + 'static>(right: S, change: impl FnOnce(&mut S)) -> S {
    let mut settings = given().unwrap_or(right);
    change(&mut settings);
    made(settings);
    settings
}

/// The settings that are given for the right ones, if they are of this kind. This and the next stand apart from [`changed`], which is
/// compiled anew for each mistake.
fn given<S: Copy + 'static>() -> Option<S> {
    let given = GIVEN.with_borrow(|given| given.as_ref()?.downcast_ref::<S>().copied());
    if given.is_some() {
        IS_ASKED.set(true);
    }
    given
}

fn made<S: 'static>(settings: S) {
    MADE.set(Some(Box::new(settings)));
}
