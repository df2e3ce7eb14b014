//! The steps of a calculation, one after the other, as somebody writes them down who does it by hand.

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
}

/// The steps so far. Each method writes a value down and gives it back, so that what is told is what is calculated with.
#[derive(Debug, Default)]
pub struct Way {
    /// The steps, in order.
    pub steps: Vec<Step>,
}

impl Way {
    /// A number.
    pub fn number(
        &mut self,
        name: impl Into<Cow<'static, str>>,
        unit: &'static str,
        v: f64,
    ) -> f64 {
        self.add(name, unit, vec![v]);
        v
    }

    /// A vector.
    pub fn vector(
        &mut self,
        name: impl Into<Cow<'static, str>>,
        unit: &'static str,
        v: DVec3,
    ) -> DVec3 {
        self.add(name, unit, v.to_array().into());
        v
    }

    /// Two numbers that belong together.
    pub fn pair(
        &mut self,
        name: impl Into<Cow<'static, str>>,
        unit: &'static str,
        v: DVec2,
    ) -> DVec2 {
        self.add(name, unit, v.to_array().into());
        v
    }

    /// A sentence, where the calculation branches.
    pub fn remark(&mut self, sentence: impl Into<Cow<'static, str>>) {
        self.add(sentence, "", Vec::new());
    }

    /// Calculates for each of many alike, and writes down the steps of the first only.
    pub fn of_first<T, R>(
        &mut self,
        all: impl IntoIterator<Item = T>,
        mut calculate: impl FnMut(&mut Self, T) -> R,
    ) -> Vec<R> {
        let mut unread = Self::default();
        let mut first = Some(self);
        let each = |one| calculate(first.take().unwrap_or(&mut unread), one);
        all.into_iter().map(each).collect()
    }

    fn add(&mut self, name: impl Into<Cow<'static, str>>, unit: &'static str, value: Vec<f64>) {
        let name = name.into();
        self.steps.push(Step { name, value, unit });
    }
}

impl Step {
    /// The value as people write it: about seven digits.
    pub fn words(&self) -> String {
        let word = |v: &f64| {
            // Seven digits are those of single precision; −0 is 0 to people.
            let v = (*v + 0.0) as f32;
            format!("{v:?}").trim_end_matches(".0").to_lowercase()
        };
        self.value.iter().map(word).collect::<Vec<_>>().join(" ")
    }
}
