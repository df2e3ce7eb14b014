//! What the lab looks at: a pattern of the library, or points that were made elsewhere.

use crate::lab::blue_noise::BLUE_NOISE;
use glam::Vec2;
use raybook::math::pcg;
use raybook::sample::pattern::{PATTERNS, Pattern};
use std::collections::HashMap;

/// Sets of points, a list of realisations for each number of points.
pub type Realisations = HashMap<usize, Vec<Vec<Vec2>>>;

/// The seed of the library's realisations, unless another is asked for.
pub const SEED: u64 = 1;

/// A way to place points.
#[derive(Clone, Debug)]
pub struct Subject {
    /// Its name as a word: "my-jittered".
    pub key: String,
    /// Its name as people write it: "my Poisson disk".
    pub title: String,
    /// The pattern that it is, or is meant to be.
    pub pattern: Pattern,
    /// The seed from which the library's realisations follow.
    seed: u64,
    /// The points, if they are not from the library.
    given: Option<Realisations>,
}

/// Points from a file, which are no named pattern.
const FROM_A_FILE: Pattern = Pattern {
    name: "file",
    title: "points of a file",
    five: "the first five of the file",
    points: |_, _| Vec::new(),
};

/// All patterns that the lab knows: the library's and the reference.
pub fn known() -> impl Iterator<Item = &'static Pattern> {
    PATTERNS.iter().chain([&BLUE_NOISE])
}

impl Subject {
    /// A pattern as the library draws it.
    pub fn of(pattern: &Pattern) -> Self {
        Self {
            key: pattern.name.to_owned(),
            title: pattern.title.to_owned(),
            pattern: *pattern,
            seed: SEED,
            given: None,
        }
    }

    /// A user's own points, which are meant to be this pattern.
    pub fn own(pattern: &Pattern, given: Realisations) -> Self {
        Self {
            key: format!("my-{}", pattern.name),
            title: format!("my {}", pattern.title),
            pattern: *pattern,
            seed: SEED,
            given: Some(given),
        }
    }

    /// Points from a file of this name.
    pub fn from_file(name: &str, given: Realisations) -> Self {
        Self {
            key: name.replace(|c: char| !c.is_ascii_alphanumeric(), "-"),
            title: name.to_owned(),
            pattern: FROM_A_FILE,
            seed: SEED,
            given: Some(given),
        }
    }

    /// The same pattern with another seed; the seed is in its name if there are `several` seeds.
    #[must_use]
    pub fn by_seed(&self, seed: u64, several: bool) -> Self {
        let mut other = Self {
            seed,
            ..self.clone()
        };
        if several && !self.is_own() {
            other.key = format!("{}-seed-{seed}", self.key);
            other.title = format!("{}, seed {seed}", self.title);
        }
        other
    }

    /// The same under another name for its files.
    #[must_use]
    pub fn renamed(self) -> Self {
        Self {
            key: format!("{}-again", self.key),
            ..self
        }
    }

    /// Whether the points come from a user: from a program or a file.
    pub fn is_own(&self) -> bool {
        self.given.is_some()
    }

    /// The number of realisations of n points, at most `wanted`: a pattern of the library has all, a program or a file has those
    /// that it gave.
    pub fn realisations(&self, n: usize, wanted: u64) -> u64 {
        let Some(given) = &self.given else {
            return wanted;
        };
        given
            .get(&n)
            .map_or(0, |sets| wanted.min(sets.len() as u64))
    }

    /// n points: the realisation `number`, from the library or from the given ones. Beyond the last given realisation, one of
    /// them is taken again at random; no points if none were given.
    pub fn points(&self, n: usize, number: u64) -> Vec<Vec2> {
        let Some(given) = &self.given else {
            return (self.pattern.points)(n, &mut pcg::stream(self.seed, number));
        };
        let sets = given.get(&n).map_or(&[][..], Vec::as_slice);
        let count = sets.len() as u64;
        let of = if number < count {
            number
        } else {
            pcg::mix(number) % count.max(1)
        };
        sets.get(of as usize).cloned().unwrap_or_default()
    }
}
