//! What a way went through: its steps, and what it met beside them.

use super::step::Step;
use crate::explain::slip::Place;
use std::cmp::Reverse;

/// What is left of a way at its end.
#[derive(Clone, Debug)]
pub struct Walked {
    /// The steps that are told, in order.
    pub steps: Vec<Step>,
    /// Steps that are not told: at each place the first.
    pub untold: Vec<Step>,
    /// What else it came by.
    pub met: Met,
    /// The number of steps and decisions, told or not, at all places.
    pub length: usize,
}

impl Walked {
    /// How well a question serves to try slips, the best first: it comes by most places, and is short.
    pub fn serves(&self) -> (Reverse<usize>, usize) {
        let mut places: Vec<Place> = Vec::new();
        for step in self.steps.iter().chain(&self.untold) {
            if !places.contains(&step.place) {
                places.push(step.place);
            }
        }
        let met = &self.met;
        let beside = met.decisions.len() + met.operations.len() + met.loops.len();
        (Reverse(places.len() + beside), self.length)
    }
}

/// What a way met beside its steps, in which people go wrong too.
#[derive(Clone, Debug, Default)]
pub struct Met {
    /// The decisions: at each place the first.
    pub decisions: Vec<Decision>,
    /// The choices: at each place the first.
    pub choices: Vec<Choice>,
    /// The operations that may be forgotten, after "forgets", "to take the absolute value": at each place the first.
    pub operations: Vec<Spot>,
    /// The powers, each by its formula: at each place the first.
    pub powers: Vec<Spot>,
    /// The loops, by what they go through, "the axes": at each place the first.
    pub loops: Vec<Spot>,
    /// What is gone through in an order: at each place the first.
    pub orders: Vec<Spot>,
    /// The numbers that are written into the program: at each place the first.
    pub limits: Vec<Limit>,
}

impl Met {
    /// Adds what another way met, where it is not among this.
    pub fn add(&mut self, more: Self) {
        // A decision that held on one way and did not on the other is one decision.
        for decision in more.decisions {
            let mut known = self.decisions.iter();
            if !known.any(|one| one.place == decision.place) {
                self.decisions.push(decision);
            }
        }
        add_new(&mut self.choices, more.choices);
        add_new(&mut self.operations, more.operations);
        add_new(&mut self.powers, more.powers);
        add_new(&mut self.loops, more.loops);
        add_new(&mut self.orders, more.orders);
        add_new(&mut self.limits, more.limits);
    }
}

/// Adds those that are not among them.
fn add_new<T: PartialEq>(all: &mut Vec<T>, more: Vec<T>) {
    for one in more {
        if !all.contains(&one) {
            all.push(one);
        }
    }
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

impl Decision {
    /// A decision that holds, or does not.
    pub(super) fn of(name: &'static str, place: Place, holds: bool, asks: Asks) -> Self {
        Self {
            name,
            place,
            held: holds,
            failed: !holds,
            asks,
        }
    }

    /// Adds it to those that are known: one at the same place is the same, and asks what it asked last of more than one thing.
    pub(super) fn add_to(self, all: &mut Vec<Self>) {
        let mut known = all.iter_mut();
        match known.find(|one| one.place == self.place) {
            Some(known) => {
                known.held |= self.held;
                known.failed |= self.failed;
                if self.asks != Asks::One {
                    known.asks = self.asks;
                }
            }
            None => all.push(self),
        }
    }
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

/// A spot on the way where something is done.
#[derive(Clone, Debug, PartialEq)]
pub struct Spot {
    /// What is done there, in words.
    pub name: &'static str,
    /// Where it is done.
    pub place: Place,
}

impl Spot {
    /// Adds it to those that are known, if it is none of them.
    pub(super) fn add_to(self, all: &mut Vec<Self>) {
        if !all.iter().any(|one| one.place == self.place) {
            all.push(self);
        }
    }
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
