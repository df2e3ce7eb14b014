//! The score of a picture made of answers: by rays, and by image.

use crate::picture::triple::Triple;

/// A picture is passed with this share of its rays right: a speck here and there is forgiven …
const RAYS: f32 = 0.99;

/// … and with at most this error of the image, on a scale from 0 to 1: five steps of a display's 255.
const ERROR: f32 = 0.02;

/// At most so large a share may hang on a last digit: those of a right answer are half of that at the most.
const UNDECIDED: f32 = 0.05;

/// How good a picture is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Score {
    /// How many of its rays are right.
    pub right: usize,
    /// How many count.
    pub of: usize,
    /// How many others are not right, but hang on a last digit: they count for nothing.
    pub undecided: usize,
    /// The root of the mean squared difference from the right picture, over the pixels that count, as a display shows them.
    pub error: f32,
}

impl Score {
    /// How many rays are wrong.
    pub fn wrong(&self) -> usize {
        self.of - self.right
    }

    /// Whether it is good enough.
    pub fn passed(&self) -> bool {
        let all = (self.of + self.undecided) as f32;
        let decided = self.of > 0 && self.undecided as f32 <= UNDECIDED * all;
        decided && self.right as f32 >= RAYS * self.of as f32 && self.error <= ERROR
    }
}

/// A line per picture, under a heading.
pub fn table(pictures: &[Triple]) -> Vec<String> {
    let heading = ["picture", "rays right", "image error", ""].map(str::to_owned);
    let row = |picture: &Triple| {
        let score = &picture.score;
        let passed = if score.passed() {
            "passed"
        } else {
            "not passed"
        };
        [
            picture.name.to_owned(),
            format!("{} of {}", score.right, score.of),
            format!("{:.4}", score.error),
            passed.to_owned(),
        ]
    };
    let rows: Vec<_> = std::iter::once(heading)
        .chain(pictures.iter().map(row))
        .collect();
    let widest = [0, 1, 2].map(|i| {
        let lengths = rows.iter().map(|row| row[i].len());
        lengths.max().unwrap_or(0)
    });
    let [name, rays, error] = widest;
    rows.iter()
        .map(|[a, b, c, d]| {
            format!("{a:<name$}   {b:>rays$}   {c:>error$}   {d}")
                .trim_end()
                .to_owned()
        })
        .collect()
}
