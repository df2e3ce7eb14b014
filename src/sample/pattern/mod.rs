//! Sampling patterns: ways to place n points in the unit square, which is a pixel.
//!
//! ```
//! use raybook::math::pcg;
//! use raybook::sample::pattern::{PATTERNS, find};
//!
//! // Every pattern places any number of points.
//! for pattern in PATTERNS {
//!     assert_eq!((pattern.points)(5, &mut pcg::stream(0, 0)).len(), 5);
//! }
//! assert_eq!(find("halton").map(|pattern| pattern.name), Some("halton"));
//! ```

pub mod best_candidate;
pub mod dart_throwing;
pub mod halton;
pub mod jittered;
pub mod multi_jittered;
pub mod n_rooks;
pub(crate) mod neighbours;
pub mod owen;
pub mod poisson_disk;
pub mod r2;
pub mod random_pattern;
pub mod regular_grid;
pub mod rotated_grid;
pub mod rows;
pub mod sobol;

use crate::math::pcg::Pcg;
use glam::Vec2;

/// A way to place any number of points in [0, 1)²; 0 and a million are allowed.
///
/// The same random numbers give the same points: a pixel whose stream is `pcg::stream(seed, pixel)` always has the same points.
#[derive(Clone, Copy, Debug)]
pub struct Pattern {
    /// The pattern's name, as a word on the command line.
    pub name: &'static str,
    /// The pattern's name in texts.
    pub title: &'static str,
    /// What the pattern does with 5 points, a number that does not suit all patterns.
    pub five: &'static str,
    /// Returns n points.
    pub points: fn(n: usize, rng: &mut Pcg) -> Vec<Vec2>,
}

/// All patterns, those of the lecture first.
pub const PATTERNS: &[Pattern] = &[
    Pattern {
        name: "regular-grid",
        title: "regular grid",
        five: "rows of two and of three cells, each as high as it has cells",
        points: |n, _| rows::in_rows(n, regular_grid::regular_grid),
    },
    Pattern {
        name: "rotated-grid",
        title: "rotated grid",
        five: "the lattice's middle moves, until five of its points are in the square",
        points: |n, _| rotated_grid::of(n, rotated_grid::rotated_grid),
    },
    Pattern {
        name: "random",
        title: "random",
        five: "any number suits it",
        points: random_pattern::random_pattern,
    },
    Pattern {
        name: "jittered",
        title: "jittered",
        five: "rows of two and of three cells, each as high as it has cells",
        points: |n, rng| rows::in_rows(n, |columns, rows| jittered::jittered(columns, rows, rng)),
    },
    Pattern {
        name: "dart-throwing",
        title: "dart throwing",
        five: "any number suits it: the distance shrinks until that many darts have room",
        points: |n, rng| dart_throwing::fill(Vec::new(), n, neighbours::Space::Torus, rng),
    },
    Pattern {
        name: "poisson-disk",
        title: "Poisson disk",
        five: "any number suits it: Bridson's points, and darts for the last ones",
        points: |n, rng| poisson_disk::of(n, neighbours::Space::Torus, rng),
    },
    Pattern {
        name: "n-rooks",
        title: "n-rooks",
        five: "any number suits it",
        points: n_rooks::n_rooks,
    },
    Pattern {
        name: "multi-jittered",
        title: "multi-jittered",
        five: "for a prime number there is one column: n-rooks, and nothing more",
        points: |n, rng| {
            let columns = multi_jittered::columns(n);
            multi_jittered::multi_jittered(columns, n / columns, rng)
        },
    },
    Pattern {
        name: "halton",
        title: "Halton",
        five: "the first five of the sequence",
        points: halton::halton,
    },
    Pattern {
        name: "r2",
        title: "R₂",
        five: "the first five of the sequence",
        points: r2::r2,
    },
    Pattern {
        name: "sobol-owen",
        title: "Sobol, Owen",
        five: "the first five of the sequence",
        points: owen::sobol_owen,
    },
    Pattern {
        name: "best-candidate",
        title: "best candidate",
        five: "any number suits it",
        points: best_candidate::best_candidate,
    },
];

/// The pattern with this `name`; `None` if there is none.
pub fn find(name: &str) -> Option<&'static Pattern> {
    PATTERNS.iter().find(|pattern| pattern.name == name)
}
