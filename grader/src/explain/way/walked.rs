//! What a way went through: steps, decisions, choices, operations, loops and limits.

use super::step::Step;
use crate::explain::slip::Place;

/// What is left of a way at its end.
#[derive(Clone, Debug)]
pub struct Walked {
    /// The steps that are told, in order.
    pub steps: Vec<Step>,
    /// Steps that are not told: at each place the first.
    pub untold: Vec<Step>,
    /// The decisions: at each place the first.
    pub decisions: Vec<Decision>,
    /// The choices: at each place the first.
    pub choices: Vec<Choice>,
    /// The operations that may be forgotten: at each place the first.
    pub operations: Vec<Operation>,
    /// The powers: at each place the first.
    pub powers: Vec<Operation>,
    /// The loops: at each place the first.
    pub loops: Vec<Loop>,
    /// What is gone through in an order: at each place the first.
    pub orders: Vec<Loop>,
    /// The numbers that are written into the program: at each place the first.
    pub limits: Vec<Limit>,
    /// The number of steps and decisions, told or not, at all places.
    pub length: usize,
}

/// A decision on the way; a remark tells what comes of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Decision {
    /// What is decided: "the discriminant is negative".
    pub name: &'static str,
    /// Where it is made.
    pub place: Place,
    /// Whether it held at some time.
    pub held: bool,
    /// Whether it did not at some time.
    pub failed: bool,
    /// What it asks.
    pub asks: Asks,
}

/// What a decision asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Asks {
    /// Whether something holds.
    One,
    /// Whether one number is less than another, or equal.
    Compared,
    /// Whether any of several things holds.
    Several,
}

/// A choice among several things, by the least of their numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// What is chosen: "the axis of the nearest plane".
    pub name: &'static str,
    /// Where it is made.
    pub place: Place,
    /// How many things there are.
    pub count: usize,
}

/// An operation on a value, which may be forgotten, or done wrongly.
#[derive(Clone, Debug, PartialEq)]
pub struct Operation {
    /// What is done, after "forgets": "to take the absolute value"; of a power its formula.
    pub name: &'static str,
    /// Where it is done.
    pub place: Place,
}

/// A loop, whose rounds may be too few.
#[derive(Clone, Debug, PartialEq)]
pub struct Loop {
    /// What it goes through: "the axes".
    pub name: &'static str,
    /// Where it begins.
    pub place: Place,
}

/// A whole number that is written into the program.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// What it limits: "the most children of a branch".
    pub name: &'static str,
    /// Where it is taken.
    pub place: Place,
    /// The right one.
    pub number: usize,
}
