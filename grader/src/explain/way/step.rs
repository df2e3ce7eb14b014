//! A step of a calculation, and what its value can be.

use crate::explain::slip::Place;
use glam::{DVec2, DVec3};
use std::borrow::Cow;

/// A step: a value by name; or a remark, which has no value.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// What it is, with its formula: "A = d·d". Of a remark the sentence.
    pub name: Cow<'static, str>,
    /// The value: a number, or those of a vector; none of a remark.
    pub value: Vec<f64>,
    /// The value's unit; empty where it has none.
    pub unit: &'static str,
    /// What the value's numbers are called; nothing of a single one.
    pub axes: Axes,
    /// Where it is calculated.
    pub place: Place,
    /// Whether it has a line of its own.
    pub(super) is_told: bool,
}

/// What the numbers of a value are called: "x", "red", "the first number".
pub type Axes = &'static [&'static str];

/// What a step's value can be.
pub trait Value: Copy {
    /// What its numbers are called; nothing of a single one.
    const AXES: Axes;

    /// Its numbers.
    fn numbers(self) -> Vec<f64>;

    /// The value with other numbers, as many as it has.
    #[must_use]
    fn with(self, numbers: &[f64]) -> Self;
}

impl Value for f64 {
    const AXES: Axes = &[];

    fn numbers(self) -> Vec<f64> {
        vec![self]
    }

    fn with(self, numbers: &[f64]) -> Self {
        numbers[0]
    }
}

impl Value for DVec2 {
    const AXES: Axes = &["the first number", "the second number"];

    fn numbers(self) -> Vec<f64> {
        self.to_array().into()
    }

    fn with(self, numbers: &[f64]) -> Self {
        Self::from_slice(numbers)
    }
}

impl Value for DVec3 {
    const AXES: Axes = &["x", "y", "z"];

    fn numbers(self) -> Vec<f64> {
        self.to_array().into()
    }

    fn with(self, numbers: &[f64]) -> Self {
        Self::from_slice(numbers)
    }
}

/// A colour, by its parts.
#[derive(Clone, Copy)]
pub(super) struct Colour(pub DVec3);

impl Value for Colour {
    const AXES: Axes = &["red", "green", "blue"];

    fn numbers(self) -> Vec<f64> {
        self.0.numbers()
    }

    fn with(self, numbers: &[f64]) -> Self {
        Self(self.0.with(numbers))
    }
}

/// Numbers as people write them: about seven digits.
pub fn words(numbers: &[f64]) -> String {
    let word = |v: &f64| {
        // Seven digits are those of single precision; −0 is 0 to people.
        let v = (*v + 0.0) as f32;
        format!("{v:?}").trim_end_matches(".0").to_lowercase()
    };
    numbers.iter().map(word).collect::<Vec<_>>().join(" ")
}
