//! Counting what comes of many comparisons, for one row of a table.

use raybook_common::grouped;
use raybook_common::oracle::judge::{Excuse, Verdict};
use std::fmt;

/// The counts of one kind of rays at one kind of shape.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// All comparisons.
    pub rays: u64,
    /// Both hit the same.
    pub hits: u64,
    /// Of these, those whose bounds are narrow.
    pub sharp: u64,
    /// They differ at an edge or the silhouette.
    pub edge: u64,
    /// They differ at an end of the interval.
    pub end: u64,
    /// They differ because two triangles are hit at once.
    pub tie: u64,
    /// How much of its bounds the largest difference used.
    pub share: f64,
    /// The comparisons in which somebody is wrong.
    pub wrong: Vec<String>,
}

impl Tally {
    /// Counts one comparison.
    pub fn add(&mut self, verdict: Verdict) {
        self.rays += 1;
        match verdict {
            Verdict::BothMiss => {}
            Verdict::Same { share, sharp } => {
                self.hits += 1;
                self.sharp += u64::from(sharp);
                self.share = self.share.max(share);
            }
            Verdict::Excused(Excuse::Edge) => self.edge += 1,
            Verdict::Excused(Excuse::End) => self.end += 1,
            Verdict::Excused(Excuse::Tie) => self.tie += 1,
            Verdict::Wrong(why) => self.wrong.push(why),
        }
    }

    /// Adds the counts of another.
    pub fn merge(&mut self, other: &Self) {
        self.rays += other.rays;
        self.hits += other.hits;
        self.sharp += other.sharp;
        self.edge += other.edge;
        self.end += other.end;
        self.tie += other.tie;
        self.share = self.share.max(other.share);
        self.wrong.extend_from_slice(&other.wrong);
    }

    /// The row of a shape in the book's table, below [`COLUMNS`].
    pub fn row(&self, shape: &str, mode: &str) -> String {
        let wrong = self.wrong.len() as u64;
        let missed = self.rays - self.hits - self.excused() - wrong;
        let [rays, hits, missed, excused] =
            [self.rays, self.hits, missed, self.excused()].map(grouped);
        format!("| {shape} | {mode} | {rays} | {hits} | {missed} | {excused} | {wrong} |\n")
    }

    /// The comparisons in which the two differ and may.
    pub fn excused(&self) -> u64 {
        self.edge + self.end + self.tie
    }
}

/// The columns of the book's table.
pub const COLUMNS: &str = "| shape | Embree's mode | rays | both hit the same | both miss | differ where rounding decides | wrong |\n|---|---|---|---|---|---|---|\n";

/// The head of the table.
pub const HEAD: &str =
    "      rays       hits   sharp hits    edge     end     tie   largest difference / bound";

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            rays,
            hits,
            sharp,
            edge,
            end,
            tie,
            share,
            ..
        } = self;
        write!(
            f,
            "{rays:10} {hits:10} {sharp:12} {edge:7} {end:7} {tie:7}   {share:.3}"
        )
    }
}
