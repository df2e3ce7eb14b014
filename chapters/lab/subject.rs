//! What the lab looks at: a pattern of the library, or points that were made elsewhere.

use glam::Vec2;
use raybook::math::pcg;
use raybook::sample::pattern::Pattern;
use std::collections::HashMap;

/// Sets of points, a list of realisations for each number of points.
pub type Realisations = HashMap<usize, Vec<Vec<Vec2>>>;

/// A way to place points.
#[derive(Debug)]
pub struct Subject {
    /// The pattern that it is, or is meant to be.
    pub pattern: Pattern,
    /// The points, where they are not the library's.
    given: Option<Realisations>,
}

impl Subject {
    /// A pattern as the library draws it.
    pub fn of(pattern: &Pattern) -> Self {
        Self {
            pattern: *pattern,
            given: None,
        }
    }

    /// Somebody's own: points that are meant to be this pattern.
    pub fn own(pattern: &Pattern, given: Realisations) -> Self {
        Self {
            pattern: *pattern,
            given: Some(given),
        }
    }

    /// Whether it is somebody's own.
    pub fn is_own(&self) -> bool {
        self.given.is_some()
    }

    /// Its name as a word: "my-jittered".
    pub fn key(&self) -> String {
        let my = if self.is_own() { "my-" } else { "" };
        format!("{my}{}", self.pattern.name)
    }

    /// Its name as people write it: "my Poisson disk".
    pub fn title(&self) -> String {
        let my = if self.is_own() { "my " } else { "" };
        format!("{my}{}", self.pattern.title)
    }

    /// How many realisations of n points there are, if so many are wanted: the library can draw as many as anyone wants.
    pub fn realisations(&self, n: usize, wanted: u64) -> u64 {
        let Some(given) = &self.given else {
            return wanted;
        };
        given
            .get(&n)
            .map_or(0, |sets| wanted.min(sets.len() as u64))
    }

    /// n points: of the library's realisations the one of this number; of those that were given too, as long as there are so many, and
    /// then any of them. None if none were given.
    pub fn points(&self, n: usize, number: u64) -> Vec<Vec2> {
        let Some(given) = &self.given else {
            return (self.pattern.points)(n, &mut pcg::stream(22, number));
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
