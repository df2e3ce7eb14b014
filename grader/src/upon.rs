//! One mistake made upon another: a program that has both.
//!
//! Most mistakes are made of something right: of the right answer, or of the settings of a function that goes right. While one of them is made
//! upon another, both are the other's.

use crate::{Graded, Mistake};
use std::any::Any;
use std::cell::{Cell, RefCell};

thread_local! {
    /// The mistake whose answer is given for the right one, and whether anybody has asked for it, or for its settings.
    static OTHER: Cell<Option<&'static dyn Any>> = const { Cell::new(None) };
    static IS_ASKED: Cell<bool> = const { Cell::new(false) };
    /// The settings that were made last, and those that are taken for the right ones.
    static MADE: RefCell<Option<Box<dyn Any>>> = const { RefCell::new(None) };
    static GIVEN: RefCell<Option<Box<dyn Any>>> = const { RefCell::new(None) };
}

/// What is answered by one who makes the first mistake upon the second; none if the first is made of nothing that the second changes.
pub fn upon<E: Graded>(
    first: &'static Mistake<E>,
    second: &'static Mistake<E>,
    question: &E,
) -> Option<E::Answer> {
    // Whatever a call that panicked has left.
    OTHER.set(None);
    GIVEN.set(None);
    MADE.set(None);
    (second.answer)(question);
    GIVEN.set(MADE.take());
    IS_ASKED.set(false);
    OTHER.set(Some(second));
    let answer = (first.answer)(question);
    OTHER.set(None);
    GIVEN.set(None);
    IS_ASKED.get().then_some(answer)
}

/// The answer of the mistake that is given for the right one, if there is one.
pub(crate) fn answer<E: Graded>(question: &E) -> Option<E::Answer> {
    // What it is made of itself is right.
    let other = OTHER.take()?;
    let mistake = other.downcast_ref::<Mistake<E>>();
    let answer = mistake.map(|mistake| (mistake.answer)(question));
    if answer.is_some() {
        IS_ASKED.set(true);
    }
    OTHER.set(Some(other));
    answer
}

/// The right settings with a change, which makes a mistake.
pub fn changed<S: Copy + 'static>(right: S, change: impl FnOnce(&mut S)) -> S {
    let given = GIVEN.with_borrow(|given| given.as_ref()?.downcast_ref::<S>().copied());
    if given.is_some() {
        IS_ASKED.set(true);
    }
    let mut settings = given.unwrap_or(right);
    change(&mut settings);
    MADE.set(Some(Box::new(settings)));
    settings
}
