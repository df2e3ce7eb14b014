//! Choosing at random among cells with weights.
//!
//! ```
//! use raybook::math::piecewise::Piecewise;
//!
//! let cells = Piecewise::new([1.0, 0.0, 3.0]);
//! assert_eq!(cells.probability(2), 0.75);
//! assert_eq!(cells.choose(0.2).map(|choice| choice.cell), Some(0));
//! assert_eq!(cells.choose(0.3).map(|choice| choice.cell), Some(2)); // never cell 1, which has the weight 0
//! ```

/// A piecewise-constant density: each of n cells has a probability that is proportional to its weight.
#[derive(Clone, Debug, PartialEq)]
pub struct Piecewise {
    /// n + 1 sums: of the weights before each cell, and of all weights; in `f64`, because a map has millions of texels.
    sums: Vec<f64>,
    /// The guide table: the number of sums that are at most 0, 1/m, 2/m, … of the total, for m parts of it. It makes the search in
    /// `sums` short (Chen and Asau, "On generating random variates from an empirical distribution", 1974).
    guide: Vec<u32>,
}

/// Number of cells for each part of the guide table: so few parts that the tables of all rows of a map stay in a processor's cache,
/// where the sums themselves have no room.
const CELLS: usize = 16;

/// The result of a choice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice {
    /// The number of the cell.
    pub cell: usize,
    /// What is left of the random number, in [0, 1): uniform again within the cell.
    pub within: f32,
}

impl Piecewise {
    /// The density for these weights; a weight that is negative or not finite counts as 0.
    pub fn new(weights: impl IntoIterator<Item = f64>) -> Self {
        let mut sums = vec![0.0];
        let mut sum = 0.0;
        for weight in weights {
            if weight.is_finite() {
                sum += weight.max(0.0);
            }
            sums.push(sum);
        }
        let (n, mut reached) = (sums.len() - 1, 0);
        let parts = n.div_ceil(CELLS);
        let guide = (0..=parts).map(|i| {
            let share = sum * i as f64 / parts.max(1) as f64;
            while reached <= n && sums[reached] <= share {
                reached += 1;
            }
            reached as u32
        });
        let guide = guide.collect();
        Self { sums, guide }
    }

    /// The sum of the weights.
    pub fn total(&self) -> f64 {
        self.sums.last().copied().unwrap_or(0.0)
    }

    // ANCHOR: choose
    /// The cell in which the running sum of the weights reaches u times the total, u in [0, 1) (inversion of the cumulative
    /// distribution).
    ///
    /// A cell with weight 0 is never chosen. `None` if all weights are 0.
    pub fn choose(&self, u: f32) -> Option<Choice> {
        let target = f64::from(u) * self.total();
        // The first sum above the target ends the cell; so cells with weight 0, where two sums are equal, are skipped.
        let end = self.above(target, u);
        let cell = end.checked_sub(1).filter(|_| end < self.sums.len())?;
        let weight = self.sums[end] - self.sums[cell];
        let within = ((target - self.sums[cell]) / weight) as f32;
        Some(Choice {
            cell,
            within: within.min(1.0 - f32::EPSILON / 2.0), // the conversion may have rounded up to 1
        })
    }
    // ANCHOR_END: choose

    /// The number of sums that are at most `target`, which is u times the total.
    fn above(&self, target: f64, u: f32) -> usize {
        let part = (f64::from(u) * (self.guide.len() - 1) as f64) as usize;
        let guide = |part: usize| {
            self.guide
                .get(part)
                .map_or(self.sums.len(), |&i| i as usize)
        };
        let begin = guide(part).saturating_sub(1).min(self.sums.len());
        let near = &self.sums[begin..(guide(part + 1) + 1).min(self.sums.len())];
        match near.partition_point(|&sum| sum <= target) {
            // By rounding, the answer may be in the part before or after.
            0 => self.sums.partition_point(|&sum| sum <= target),
            found if found == near.len() => self.sums.partition_point(|&sum| sum <= target),
            found => begin + found,
        }
    }

    /// The probability of a cell; 0 if the cell does not exist, or if all weights are 0.
    pub fn probability(&self, cell: usize) -> f64 {
        match (self.sums.get(cell), self.sums.get(cell + 1)) {
            (Some(before), Some(after)) if self.total() > 0.0 => (after - before) / self.total(),
            _ => 0.0,
        }
    }
}
