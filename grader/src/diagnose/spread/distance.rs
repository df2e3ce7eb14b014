//! How far the traits of answers are from those of the student's.

use crate::diagnose::evidence::{Evidence, Item};

/// What is not explained by a mistake may be this share of what it explains …
const REST: f64 = 0.35;

/// … or this many standard errors of it.
const ERRORS: f64 = 3.0;

/// Traits this close are the same.
const CLOSE: f64 = 2e-3;

/// The number of wrong answers that any explanation is tried on, where there are twice as many.
const FEW: usize = 8;

/// What of the distance may be left in the probe.
pub(super) const PROMISING: f64 = 0.6;

/// How far the traits of answers are from the student's: the mean difference of each, and its standard error.
pub(super) struct Distance {
    mean: Vec<f64>,
    error: Vec<f64>,
}

impl Distance {
    pub(super) fn norm(&self) -> f64 {
        self.mean.iter().map(|v| v * v).sum::<f64>().sqrt()
    }

    /// The same without what chance adds: to the square of each mean, that of its error, on average.
    pub(super) fn beyond_chance(&self) -> f64 {
        let beyond = self.norm().powi(2) - self.chance().powi(2);
        beyond.max(0.0).sqrt()
    }

    /// What chance makes of a distance of which nothing is left.
    pub(super) fn chance(&self) -> f64 {
        self.error.iter().map(|e| e * e).sum::<f64>().sqrt()
    }

    /// Whether this may be what a good explanation leaves of the distance `whole`, where few answers tell, and chance much.
    pub(super) fn promises(&self, whole: &Self) -> bool {
        self.norm() <= PROMISING * whole.norm() + 2.0 * self.chance()
    }

    /// Whether nothing is left of a distance but chance.
    pub(super) fn explains(&self, whole: &Self) -> bool {
        let errors = self
            .error
            .iter()
            .map(|e| (ERRORS * e + CLOSE).powi(2))
            .sum::<f64>()
            .sqrt();
        self.norm() <= REST * whole.norm() && self.norm() <= (REST * 0.5 * whole.norm()).max(errors)
    }
}

/// The traits of a student's answers.
pub(super) struct Traits<'a, 'e> {
    pub(super) evidence: &'a Evidence<'e>,
    pub(super) got: Vec<Vec<f64>>,
}

impl<'a, 'e> Traits<'a, 'e> {
    /// None if the exercise has none.
    pub(super) fn of(evidence: &'a Evidence<'e>) -> Option<Self> {
        let traits = |item: &Item| evidence.examiner.traits(&item.question, &item.got);
        let got: Vec<_> = evidence.items.iter().map(traits).collect();
        got.iter()
            .any(|got| !got.is_empty())
            .then_some(Self { evidence, got })
    }

    /// A few wrong answers, on which an explanation is tried before it is tried on all: traits of many points take long. None if there
    /// are not many more.
    pub(super) fn few(&self) -> Option<Vec<usize>> {
        let wrong = self.evidence.wrong;
        (wrong >= 2 * FEW).then(|| (0..FEW).map(|k| k * wrong / FEW).collect())
    }

    /// How far other answers to the same questions are from them; none if there are too few.
    pub(super) fn distance(&self, answers: &dyn Fn(usize) -> Option<Vec<f64>>) -> Option<Distance> {
        let all: Vec<_> = (0..self.got.len()).collect();
        self.distance_among(&all, answers)
    }

    /// The same of some of the questions.
    pub(super) fn distance_among(
        &self,
        some: &[usize],
        answers: &dyn Fn(usize) -> Option<Vec<f64>>,
    ) -> Option<Distance> {
        let mut off: Vec<Vec<f64>> = Vec::new();
        for &i in some {
            let Some(answer) = answers(i) else { continue };
            let (item, got) = (&self.evidence.items[i], &self.got[i]);
            let theirs = self.evidence.examiner.traits(&item.question, &answer);
            if theirs.len() == got.len() && !got.is_empty() {
                off.push(theirs.iter().zip(got).map(|(a, b)| a - b).collect());
            }
        }
        let n = off.len() as f64;
        let len = off.first()?.len();
        if off.iter().any(|off| off.len() != len) || 3 * off.len() < some.len() {
            return None;
        }
        let mean: Vec<f64> = (0..len)
            .map(|k| off.iter().map(|off| off[k]).sum::<f64>() / n)
            .collect();
        let variance = |k: usize| {
            off.iter()
                .map(|off| (off[k] - mean[k]).powi(2))
                .sum::<f64>()
                / (n - 1.0).max(1.0)
        };
        let error = (0..len).map(|k| (variance(k) / n).sqrt()).collect();
        Some(Distance { mean, error })
    }
}
