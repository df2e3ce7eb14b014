//! Rays of all kinds at many targets, both sides asked, and what came of it.

use crate::embree::{Embree, Mode};
use crate::rays::{KINDS, rays};
use crate::tally::{HEAD, Tally};
use raybook::math::pcg;
use raybook_common::oracle::judge::judge;
use raybook_common::oracle::target::Target;
use std::fmt;

/// Both ways in which Embree can be asked.
const MODES: [Mode; 2] = [Mode::Fast, Mode::Robust];

/// A table: a row for each kind of rays and each mode of Embree.
#[derive(Clone, Debug, Default)]
pub struct Campaign {
    name: String,
    rows: [[Tally; MODES.len()]; KINDS.len()],
}

impl Campaign {
    /// Shoots at each target the given number of rays, as many of each kind.
    ///
    /// # Errors
    /// If Embree fails.
    pub fn run(
        name: &str,
        targets: impl IntoIterator<Item = (Target, usize)>,
    ) -> Result<Self, String> {
        let embree = Embree::new()?;
        let mut campaign = Self {
            name: name.to_owned(),
            ..Self::default()
        };
        for (number, (target, count)) in (0..).zip(targets) {
            let scenes = [
                embree.scene(&target.solid, MODES[0])?,
                embree.scene(&target.solid, MODES[1])?,
            ];
            let mut rng = pcg::stream(count as u64, number);
            for (row, kind) in campaign.rows.iter_mut().zip(KINDS) {
                for (ray, within) in rays(kind, &target, count / KINDS.len(), &mut rng) {
                    let ours = target.ask(&ray, within);
                    for (tally, scene) in row.iter_mut().zip(&scenes) {
                        let theirs = scene.closest(&ray, within);
                        tally.add(judge(&target, &ray, within, [ours, theirs]));
                    }
                }
            }
        }
        Ok(campaign)
    }

    /// The sum of several.
    pub fn sum(name: &str, parts: &[Self]) -> Self {
        let mut sum = Self {
            name: name.to_owned(),
            ..Self::default()
        };
        for part in parts {
            for (sum, row) in sum
                .rows
                .iter_mut()
                .flatten()
                .zip(part.rows.iter().flatten())
            {
                sum.merge(row);
            }
        }
        sum
    }

    /// Demands that nobody was wrong in at least `rays` rays; that of each kind at least a fifth hit;
    /// that the bounds were narrow for at least half of the hits; and that of all answers at most the given part,
    /// of each row at most five times as much, differed where they may.
    ///
    /// # Panics
    /// If not.
    pub fn check(&self, rays: u64, may_differ: f64) {
        println!("{self}");
        let Self { name, rows } = self;
        for (kind, row) in KINDS.iter().zip(rows) {
            for (mode, tally) in MODES.iter().zip(row) {
                let row = format!("{name}, {}, {mode:?}", kind.name());
                assert!(
                    tally.wrong.is_empty(),
                    "{row}: {} of {} rays are answered wrong, such as\n{}",
                    tally.wrong.len(),
                    tally.rays,
                    tally.wrong[..tally.wrong.len().min(3)].join("\n")
                );
                assert!(
                    5 * tally.hits >= tally.rays,
                    "{row}: a fifth of the rays must hit, not {} of {}",
                    tally.hits,
                    tally.rays
                );
                assert!(
                    tally.excused() as f64 <= 5.0 * may_differ * tally.rays as f64,
                    "{row}: {} of {} answers differ",
                    tally.excused(),
                    tally.rays
                );
            }
        }
        for all in self.modes() {
            assert!(all.rays >= rays, "{name}: {} rays are too few", all.rays);
            assert!(
                2 * all.sharp >= all.hits,
                "{name}: of {} hits, only {} have narrow bounds",
                all.hits,
                all.sharp
            );
            assert!(
                all.excused() as f64 <= may_differ * all.rays as f64,
                "{name}: {} of {} answers differ",
                all.excused(),
                all.rays
            );
        }
    }
}

impl Campaign {
    /// The counts of all kinds of rays, in each mode of Embree.
    fn modes(&self) -> [Tally; MODES.len()] {
        std::array::from_fn(|mode| {
            let mut all = Tally::default();
            for row in &self.rows {
                all.merge(&row[mode]);
            }
            all
        })
    }

    /// The rows of the book's table.
    pub fn table(&self) -> String {
        let modes = MODES.iter().zip(self.modes());
        let row =
            |(mode, all): (&Mode, Tally)| all.row(&self.name, &format!("{mode:?}").to_lowercase());
        modes.map(row).collect()
    }
}

impl fmt::Display for Campaign {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{:22} {HEAD}", self.name)?;
        for (kind, row) in KINDS.iter().zip(&self.rows) {
            for (mode, tally) in MODES.iter().zip(row) {
                writeln!(f, "{:13} {:8} {tally}", kind.name(), format!("{mode:?}"))?;
            }
        }
        Ok(())
    }
}
