//! What is wanted of a student's patterns, and what came.

use glam::Vec2;
use raybook_chapters::lab::subject::Realisations;
use std::time::Duration;

/// What is wanted of each pattern.
pub struct Wanted {
    /// Numbers of points without which it cannot be shown.
    pub needed: Vec<usize>,
    /// Further numbers of points.
    pub further: Vec<usize>,
    /// How often, each time with another seed: 0, 1, 2 …
    pub realisations: u64,
    /// How long a program is asked for one pattern: no further batch is begun that would, at the pace so far, last beyond it. What is
    /// needed at least is asked in any case.
    pub patience: Duration,
}

/// What came of it.
pub struct Got {
    /// The points by their number; none where they cannot be shown.
    pub points: Realisations,
    /// What was wrong: points that were asked for are missing.
    pub wrong: Option<String>,
    /// What else there is to say.
    pub remarks: Vec<String>,
}

/// Fewer realisations than these tell nothing of an error.
pub const FEWEST: usize = 4;

impl Got {
    /// What can be shown of these points, of which there should be a number of realisations, and what there is to say of them.
    pub fn of(
        points: Realisations,
        wrong: Option<String>,
        realisations: usize,
        wanted: &Wanted,
    ) -> Self {
        let mut got = Self {
            points,
            wrong,
            remarks: Vec::new(),
        };
        if got.ignores_the_seed() {
            got.points.values_mut().for_each(|sets| sets.truncate(1));
            got.remarks.push("the same points whatever the seed, so every pixel has the same ones, and one realisation is all there is; let your generator follow from the seed".to_owned());
        } else {
            let enough = FEWEST.min(realisations);
            got.points.retain(|_, sets| sets.len() >= enough);
            got.remarks.extend(got.shortage(realisations, wanted));
        }
        let missing = |n: &&usize| !got.points.contains_key(n);
        if let Some(n) = wanted.needed.iter().find(missing) {
            got.points.clear();
            got.remarks.clear();
            got.wrong
                .get_or_insert_with(|| format!("too slow for {n} points"));
        }
        got
    }

    /// Whether all realisations are the same, where there are several.
    fn ignores_the_seed(&self) -> bool {
        let several = || self.points.values().filter(|sets| sets.len() > 1);
        let same = |sets: &Vec<Vec<Vec2>>| sets.iter().all(|set| *set == sets[0]);
        several().next().is_some() && several().all(same)
    }

    /// What a slow program has left undone.
    fn shortage(&self, realisations: usize, wanted: &Wanted) -> Option<String> {
        if self.wrong.is_some() {
            return None;
        }
        let most = *self.points.keys().max()?;
        let count = self.points[&most].len();
        let asked = wanted.needed.iter().chain(&wanted.further).max()?;
        let seconds = wanted.patience.as_secs_f32();
        (most < *asked || count < realisations).then(|| {
            format!("in {seconds} s there were only {count} of {realisations} realisations of {most} points: where there are few, bands are wide")
        })
    }
}
