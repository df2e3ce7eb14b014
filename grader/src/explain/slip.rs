//! Slips: at one step something else is written down than the right value, and all that follows is calculated with it.

use std::ops::Range;
use std::panic::{Location, resume_unwind};

/// The place of a step in the way to an answer: that of its line in the file of its chapter.
#[derive(Clone, Copy, Debug, Eq)]
pub struct Place(&'static Location<'static>);

impl PartialEq for Place {
    fn eq(&self, other: &Self) -> bool {
        // Lines differ more often than files, and are compared faster.
        let (one, other) = (self.0, other.0);
        one.line() == other.line() && one.column() == other.column() && one.file() == other.file()
    }
}

impl Place {
    /// The place that calls.
    #[track_caller]
    pub(super) fn here() -> Self {
        Self(Location::caller())
    }
}

/// What is made of a right value.
#[derive(Clone, Copy, Debug)]
pub enum Change {
    /// Of each number by itself.
    Each(fn(f64) -> f64),
    /// Of all its numbers together.
    Together(fn(&mut [f64])),
}

impl Change {
    /// Changes the numbers of a value.
    pub(super) fn make(self, value: &mut [f64]) {
        match self {
            Self::Each(of) => value.iter_mut().for_each(|v| *v = of(*v)),
            Self::Together(of) => of(value),
        }
    }
}

/// How another value goes into a step where it does not belong, or once more than it should.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mixed {
    /// The step times a power of the value, and times a number.
    Times {
        /// The power.
        power: f64,
        /// The number.
        by: f64,
    },
    /// The step plus this many times the value.
    Plus(f64),
    /// The value is a factor with this power, 1 or −1, and is added, or subtracted.
    Added(f64),
    /// The value is a summand with this factor, and is multiplied by.
    Multiplied(f64),
    /// The step to the power of the value.
    Raised,
}

impl Mixed {
    /// A number of the step's value with a number of the other.
    pub(super) fn of(self, v: f64, other: f64) -> f64 {
        match self {
            Self::Times { power, by } => by * v * other.powf(power),
            Self::Plus(factor) => v + factor * other,
            Self::Added(power) => v * other.powf(-power) + power * other,
            Self::Multiplied(factor) => (v - factor * other) * other,
            Self::Raised => v.powf(other),
        }
    }
}

/// What a number that fits does with a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fitted {
    /// Multiplies it.
    Times(f64),
    /// Is added to it.
    Plus(f64),
}

impl Fitted {
    /// A number of the value with it.
    pub(super) fn of(self, v: f64) -> f64 {
        match self {
            Self::Times(by) => by * v,
            Self::Plus(more) => v + more,
        }
    }
}

/// A sum of which one summand has a factor: f·x + c.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bracket {
    /// The step of c, as in `Slip::Other`.
    pub summand: Place,
    /// How many times it is added.
    pub times: f64,
    /// The step of f.
    pub factor: Place,
    /// The power with which it goes in: −1 of a divisor.
    pub power: f64,
    /// Whether f·(x + c) is right: then the brackets are forgotten, else there is one pair too many.
    pub belongs: bool,
}

impl Bracket {
    /// A number with the brackets wrong, from the right one and those of the summand and of the factor.
    pub(super) fn of(self, v: f64, summand: f64, factor: f64) -> f64 {
        let more = self.times * summand * (factor.powf(self.power) - 1.0);
        if self.belongs { v - more } else { v + more }
    }
}

/// What is made of a base and an exponent.
pub type Powers = fn(f64, f64) -> f64;

/// Whether a number is less than another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Comparison {
    pub one: f64,
    pub other: f64,
    /// Whether it holds of equal numbers: ≤, not <.
    pub equal_counts: bool,
}

impl Comparison {
    pub fn holds(self) -> bool {
        self.one < self.other || self.equal_counts && self.one == self.other
    }
}

/// What is made of two numbers that are compared.
pub type Sides = fn(f64, f64) -> [f64; 2];

/// What is made of what holds or does not, each by itself, where one that holds is enough.
pub type Among = fn(&[bool]) -> bool;

/// Which of several things is chosen, by a number of each, instead of the one with the least number.
pub type Pick = fn(&[f64]) -> usize;

/// From which round a value is taken, by the number of the round in which it is wanted: that one, or one before it.
pub type Earlier = fn(usize) -> usize;

/// What is made of the rounds of a loop.
pub type Rounds = fn(Range<usize>) -> Range<usize>;

/// Of this number of things, in which order they are gone through.
pub type Order = fn(usize) -> Vec<usize>;

/// What happens at one step, wherever the way comes by it.
#[derive(Clone, Copy, Debug)]
pub enum Slip {
    /// The value is changed.
    Value(Place, Change),
    /// The last value of another step is taken, if it is as long, or a number: that for each of the value's. Of a step that comes later,
    /// its value on the right way.
    Other {
        /// The step that is wrong.
        at: Place,
        /// The step whose value is taken.
        of: Place,
        /// For which of the value's numbers; for all of them if none is given.
        only: Option<usize>,
    },
    /// The last value of another step, as in `Other`, goes into the value.
    Mix {
        /// The step that is wrong.
        at: Place,
        /// The step whose value goes in.
        of: Place,
        /// In what way.
        how: Mixed,
        /// Into which of the value's numbers; into all of them if none is given.
        only: Option<usize>,
    },
    /// Brackets are forgotten, or too many.
    Bracket(Place, Bracket),
    /// Something else is made of a base and an exponent than the power.
    Power(Place, Powers),
    /// A factor of the base stands outside of the power, or one outside stands in the base: the last value of another step, a number.
    Factor {
        /// The power that is wrong.
        at: Place,
        /// The step whose value the factor is.
        of: Place,
        /// Whether it is in the base, and should not be.
        inside: bool,
    },
    /// The value that the step had in a round before, as one that a loop does not renew, or a line that was copied and not changed.
    Earlier(Place, Earlier),
    /// A decision falls in another way.
    Decision(Place, fn(bool) -> bool),
    /// Of several things of which one is enough, others are asked, or more must hold.
    Among(Place, Among),
    /// Of several things another one is chosen.
    Choice(Place, Pick),
    /// Of several things one is chosen by the numbers of another step, if it has one for each.
    ChoiceBy {
        /// The choice that is wrong.
        at: Place,
        /// The step whose numbers are taken.
        of: Place,
    },
    /// Two numbers that differ by less than this are taken for equal.
    Near(Place, f64),
    /// Of two numbers that are compared another is made.
    Sides(Place, Sides),
    /// Equal numbers are compared by < for ≤, or the other way round.
    Tie(Place),
    /// An operation is forgotten.
    Forgotten(Place),
    /// A loop goes through other rounds.
    Rounds(Place, Rounds),
    /// Things are gone through in another order.
    Ordered(Place, Order),
    /// Another number is written into the program.
    Limit(Place, usize),
    /// A number that fits is made part of the value.
    Fitted(Place, Fitted),
}

impl Slip {
    /// Where it is made.
    pub fn place(&self) -> Place {
        match *self {
            Self::Value(at, _)
            | Self::Bracket(at, _)
            | Self::Power(at, _)
            | Self::Earlier(at, _)
            | Self::Other { at, .. }
            | Self::Mix { at, .. }
            | Self::Decision(at, _)
            | Self::Among(at, _)
            | Self::Choice(at, _)
            | Self::ChoiceBy { at, .. }
            | Self::Factor { at, .. }
            | Self::Near(at, _)
            | Self::Sides(at, _)
            | Self::Tie(at)
            | Self::Forgotten(at)
            | Self::Rounds(at, _)
            | Self::Ordered(at, _)
            | Self::Limit(at, _)
            | Self::Fitted(at, _) => at,
        }
    }

    /// Whether it takes the value of another step.
    pub(super) fn looks_back(&self) -> bool {
        matches!(
            self,
            Self::Other { .. }
                | Self::Mix { .. }
                | Self::Bracket(..)
                | Self::ChoiceBy { .. }
                | Self::Factor { .. }
        )
    }

    /// What it makes of the decision at a place, and of what is compared there, if two numbers are.
    pub(super) fn decided(&self, place: Place, holds: bool, of: Option<Comparison>) -> bool {
        if self.place() != place {
            return holds;
        }
        match (*self, of) {
            (Self::Decision(_, decide), _) => decide(holds),
            (Self::Sides(_, make), Some(of)) => {
                let [one, other] = make(of.one, of.other);
                Comparison { one, other, ..of }.holds()
            }
            (Self::Tie(_), Some(of)) if of.one == of.other => !of.equal_counts,
            (Self::Near(_, least), Some(of)) if (of.one - of.other).abs() < least => {
                of.equal_counts
            }
            _ => holds,
        }
    }
}

/// More steps than these no way to a right answer takes: a way with a slip may never end.
const ENDLESS: usize = 200_000;

/// Ends a way that has become endless, or longer than it may be; whoever follows a slip catches that.
pub(super) fn end_if_endless(steps: usize, most: Option<usize>) {
    if steps > most.unwrap_or(ENDLESS) {
        resume_unwind(Box::new("a way with a slip that never ends"));
    }
}
