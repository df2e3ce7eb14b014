//! An axis of a chart: its range, its scale (linear or logarithmic), and what is written beside it.

use plotters::coord::combinators::{IntoLogRange, LogCoord};
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::coord::types::RangedCoordf64;
use std::fmt;
use std::ops::Range;

/// Maximum number of labels of an axis, unless a chart sets another number.
const LABELS: usize = 10;

/// An axis of a [`Chart`](crate::kit::chart::Chart).
pub struct Axis {
    pub(super) name: String,
    pub(super) scale: Scale,
    pub(super) labels: usize,
    pub(super) format: Box<dyn Fn(f64) -> String>,
    pub(super) is_drawn: bool,
}

impl fmt::Debug for Axis {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Axis")
            .field("name", &self.name)
            .field("labels", &self.labels)
            .finish_non_exhaustive()
    }
}

impl Axis {
    /// An axis on which equal differences have equal length.
    pub fn linear<T: Into<f64>>(range: Range<T>) -> Self {
        let range = range.start.into()..range.end.into();
        Self::on(Spacing::Linear(range.into()))
    }

    /// An axis on which equal ratios have equal length, with a label at each power of 10.
    pub fn log<T: Into<f64>>(range: Range<T>) -> Self {
        Self::powers(range, 10.0)
    }

    /// As [`Axis::log`], with a label at each power of 2.
    pub fn log2<T: Into<f64>>(range: Range<T>) -> Self {
        Self::powers(range, 2.0)
    }

    fn powers<T: Into<f64>>(range: Range<T>, base: f64) -> Self {
        let range = range.start.into()..range.end.into();
        Self::on(Spacing::Log(range.log_scale().base(base).into()))
    }

    fn on(spacing: Spacing) -> Self {
        Self {
            name: String::new(),
            scale: Scale {
                spacing,
                marks: Vec::new(),
            },
            labels: LABELS,
            // As f32: a number that is computed as 0.30000000000000004 is written as 0.3.
            format: Box::new(|v| (v as f32).to_string()),
            is_drawn: true,
        }
    }

    /// With the name of what is measured along it.
    #[must_use]
    pub fn named(mut self, name: &str) -> Self {
        name.clone_into(&mut self.name);
        self
    }

    /// With at most this number of labels, where plotters finds round numbers.
    #[must_use]
    pub fn labels(mut self, at_most: usize) -> Self {
        self.labels = at_most;
        self
    }

    /// With labels at these numbers and no others.
    #[must_use]
    pub fn marks(mut self, at: &[f64]) -> Self {
        self.scale.marks = at.to_vec();
        self
    }

    /// With its numbers written by `format`.
    #[must_use]
    pub fn format(mut self, format: impl Fn(f64) -> String + 'static) -> Self {
        self.format = Box::new(format);
        self
    }

    /// Without a line, labels or a grid.
    #[must_use]
    pub fn hidden(mut self) -> Self {
        self.is_drawn = false;
        self
    }

    /// What is written beside it.
    pub(super) fn texts(&self) -> impl Iterator<Item = String> + '_ {
        let numbers = (&self.scale).key_points(self.labels);
        numbers.into_iter().map(|v| (self.format)(v))
    }
}

/// The place of a number on an axis.
pub(super) struct Scale {
    spacing: Spacing,
    /// Where the labels are; if empty, plotters chooses.
    marks: Vec<f64>,
}

enum Spacing {
    Linear(RangedCoordf64),
    Log(LogCoord<f64>),
}

impl Ranged for &Scale {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        match &self.spacing {
            Spacing::Linear(axis) => axis.map(value, limit),
            Spacing::Log(axis) => axis.map(value, limit),
        }
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        match &self.spacing {
            _ if !self.marks.is_empty() => self.marks.clone(),
            Spacing::Linear(axis) => axis.key_points(hint),
            Spacing::Log(axis) => axis.key_points(hint),
        }
    }

    fn range(&self) -> Range<f64> {
        match &self.spacing {
            Spacing::Linear(axis) => axis.range(),
            Spacing::Log(axis) => axis.range(),
        }
    }
}

impl ValueFormatter<f64> for &Scale {}
