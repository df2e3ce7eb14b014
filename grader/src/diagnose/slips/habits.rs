//! What people make of a step's value, of a power, of several things and of the rounds of a loop.

use crate::explain::slip::{Among, Change, Earlier, Order, Pick, Powers, Rounds, Sides};
use crate::explain::way::{Axes, least};
use std::f64::consts::{LN_2, LN_10, PI, TAU};

/// What is often made of a value of a certain size.
pub struct Common {
    /// How many numbers the value has; none stands for any number of them.
    sizes: &'static [usize],
    /// In words; {0}, {1} and {2} stand for what the numbers are called.
    name: &'static str,
    /// How common it is.
    pub rank: u32,
    /// What is made.
    pub change: Change,
}

impl Common {
    /// Whether it is made of values of this size.
    pub fn suits(&self, size: usize) -> bool {
        self.sizes.is_empty() || self.sizes.contains(&size)
    }

    /// In words, of a value whose numbers have these names.
    pub fn called(&self, axes: Axes) -> String {
        let called =
            |name: String, (i, axis): (usize, &&str)| name.replace(&format!("{{{i}}}"), axis);
        axes.iter().enumerate().fold(self.name.to_owned(), called)
    }
}

/// Gives a vector this length.
fn lengthen(v: &mut [f64], length: f64) {
    let own = v.iter().map(|v| v * v).sum::<f64>().sqrt();
    for v in v {
        *v *= length / own;
    }
}

/// Turns a vector round that goes down along an axis.
fn turn_up(v: &mut [f64], axis: usize) {
    if v[axis] < 0.0 {
        for v in v {
            *v = -*v;
        }
    }
}

macro_rules! common {
    ($([$($size:literal)*] $rank:literal $name:literal: $how:ident $of:expr;)+) => {
        /// What is often made of values.
        pub const COMMON: &[Common] = &[$(Common { sizes: &[$($size),*], name: $name, rank: $rank, change: Change::$how($of) }),+];
    };
}

common! {
    [] 9 "takes 1, as if the value were not there": Each |_| 1.0;
    [] 9 "takes 0": Each |_| 0.0;
    [] 9 "takes twice the value": Each |v| 2.0 * v;
    [] 9 "takes half of the value": Each |v| 0.5 * v;
    [] 9 "takes 4 times the value": Each |v| 4.0 * v;
    [] 9 "takes a quarter of the value": Each |v| 0.25 * v;
    [] 10 "takes 3 times the value": Each |v| 3.0 * v;
    [] 10 "takes a third of the value": Each |v| v / 3.0;
    [] 12 "takes 1½ times the value": Each |v| 1.5 * v;
    [] 12 "takes 10 times the value": Each |v| 10.0 * v;
    [] 12 "takes a tenth of the value": Each |v| 0.1 * v;
    [] 12 "takes 8 times the value": Each |v| 8.0 * v;
    [] 12 "takes an eighth of the value": Each |v| 0.125 * v;
    [] 10 "takes π times the value": Each |v| PI * v;
    [] 10 "takes the value divided by π": Each |v| v / PI;
    [] 10 "takes 2π times the value": Each |v| TAU * v;
    [] 10 "takes the value divided by 2π": Each |v| v / TAU;
    [] 12 "takes π² times the value, as if it were multiplied by π instead of divided": Each |v| PI * PI * v;
    [] 12 "takes the value divided by π², as if it were divided by π instead of multiplied": Each |v| v / (PI * PI);
    [1 2] 11 "takes the value plus 1": Each |v| v + 1.0;
    [1 2] 11 "takes the value minus 1": Each |v| v - 1.0;
    [1 2] 12 "takes the value plus ½": Each |v| v + 0.5;
    [1 2] 12 "takes the value minus ½": Each |v| v - 0.5;
    [1 2] 12 "takes the value plus 2": Each |v| v + 2.0;
    [1 2] 12 "takes the value minus 2": Each |v| v - 2.0;
    [] 13 "takes the value divided by ln 10, as of a logarithm to base 10 for one to base e": Each |v| v / LN_10;
    [] 13 "takes the value divided by ln 2, as of a logarithm to base 2 for one to base e": Each |v| v / LN_2;
    [1] 12 "takes at least 0.1, against numbers that are too small": Each |v| v.max(0.1);
    [1] 12 "takes at least 0.01, against numbers that are too small": Each |v| v.max(0.01);
    [1] 12 "takes at least 0.001, against numbers that are too small": Each |v| v.max(0.001);
    [1] 12 "takes at least 0.0001, against numbers that are too small": Each |v| v.max(1e-4);
    [2] 10 "exchanges both numbers": Together |v| v.swap(0, 1);
    [2] 11 "has the sign of {0} wrong": Together |v| v[0] = -v[0];
    [2] 11 "has the sign of {1} wrong": Together |v| v[1] = -v[1];
    [2] 12 "takes {0} twice": Together |v| v[1] = v[0];
    [2] 12 "takes {1} twice": Together |v| v[0] = v[1];
    [2] 12 "takes 0 for {0}": Together |v| v[0] = 0.0;
    [2] 12 "takes 0 for {1}": Together |v| v[1] = 0.0;
    [2] 11 "takes one more for {0}": Together |v| v[0] += 1.0;
    [2] 11 "takes one less for {0}": Together |v| v[0] -= 1.0;
    [2] 11 "takes one more for {1}": Together |v| v[1] += 1.0;
    [2] 11 "takes one less for {1}": Together |v| v[1] -= 1.0;
    [2] 12 "counts {0} from the other end: 1 minus it": Together |v| v[0] = 1.0 - v[0];
    [2] 12 "counts {1} from the other end: 1 minus it": Together |v| v[1] = 1.0 - v[1];
    [3] 11 "has the sign of {0} wrong": Together |v| v[0] = -v[0];
    [3] 11 "has the sign of {1} wrong": Together |v| v[1] = -v[1];
    [3] 11 "has the sign of {2} wrong": Together |v| v[2] = -v[2];
    [3] 11 "exchanges {0} and {1}": Together |v| v.swap(0, 1);
    [3] 11 "exchanges {0} and {2}": Together |v| v.swap(0, 2);
    [3] 11 "exchanges {1} and {2}": Together |v| v.swap(1, 2);
    [3] 12 "takes ({1}, {2}, {0}) for ({0}, {1}, {2})": Together |v| v.rotate_left(1);
    [3] 12 "takes ({2}, {0}, {1}) for ({0}, {1}, {2})": Together |v| v.rotate_right(1);
    [3] 12 "takes {0} for all three": Together |v| v.fill(v[0]);
    [3] 12 "takes {1} for all three": Together |v| v.fill(v[1]);
    [3] 12 "takes {2} for all three": Together |v| v.fill(v[2]);
    [3] 13 "takes twice {0}": Together |v| v[0] *= 2.0;
    [3] 13 "takes twice {1}": Together |v| v[1] *= 2.0;
    [3] 13 "takes twice {2}": Together |v| v[2] *= 2.0;
    [3] 13 "takes {1} for {0}": Together |v| v[0] = v[1];
    [3] 13 "takes {2} for {0}": Together |v| v[0] = v[2];
    [3] 13 "takes {0} for {1}": Together |v| v[1] = v[0];
    [3] 13 "takes {2} for {1}": Together |v| v[1] = v[2];
    [3] 13 "takes {0} for {2}": Together |v| v[2] = v[0];
    [3] 13 "takes {1} for {2}": Together |v| v[2] = v[1];
    [3] 12 "takes 0 for {0}": Together |v| v[0] = 0.0;
    [3] 12 "takes 0 for {1}": Together |v| v[1] = 0.0;
    [3] 12 "takes 0 for {2}": Together |v| v[2] = 0.0;
    [3] 13 "takes 0 for all but {0}": Together |v| v[1..].fill(0.0);
    [3] 13 "takes 0 for all but {1}": Together |v| (v[0], v[2]) = (0.0, 0.0);
    [3] 13 "takes 0 for all but {2}": Together |v| v[..2].fill(0.0);
    [3] 12 "takes 1 for {0}": Together |v| v[0] = 1.0;
    [3] 12 "takes 1 for {1}": Together |v| v[1] = 1.0;
    [3] 12 "takes 1 for {2}": Together |v| v[2] = 1.0;
    [3] 12 "takes the absolute value of {0}": Together |v| v[0] = v[0].abs();
    [3] 12 "takes the absolute value of {1}": Together |v| v[1] = v[1].abs();
    [3] 12 "takes the absolute value of {2}": Together |v| v[2] = v[2].abs();
    [3] 12 "turns it round where {0} is negative": Together |v| turn_up(v, 0);
    [3] 12 "turns it round where {1} is negative": Together |v| turn_up(v, 1);
    [3] 12 "turns it round where {2} is negative": Together |v| turn_up(v, 2);
    [3] 12 "takes the sum of the absolute values for its length": Together |v| {
        let sum = v.iter().map(|v| v.abs()).sum();
        lengthen(v, sum);
    };
    [3] 13 "takes the largest of the absolute values for its length": Together |v| {
        let largest = v.iter().map(|v| v.abs()).fold(0.0, f64::max);
        lengthen(v, largest);
    };
    [3] 13 "divides by the sum of the absolute values instead of the length": Together |v| {
        let sum: f64 = v.iter().map(|v| v.abs()).sum();
        for v in v { *v /= sum; }
    };
    [3] 13 "divides by the largest of the absolute values instead of the length": Together |v| {
        let largest = v.iter().map(|v| v.abs()).fold(0.0, f64::max);
        for v in v { *v /= largest; }
    };
    [3] 10 "normalises the value": Together |v| lengthen(v, 1.0);
}

/// What people make of a base and an exponent: how common it is, in words, and the number.
pub const POWERS: &[(u32, &str, Powers)] = &[
    (
        9,
        "multiplies by the exponent instead of raising to the power",
        |base, exponent| base * exponent,
    ),
    (
        9,
        "exchanges the base and the exponent",
        |base, exponent| exponent.powf(base),
    ),
    (
        10,
        "divides by the exponent instead of raising to the power",
        |base, exponent| base / exponent,
    ),
    (
        12,
        "adds the exponent instead of raising to the power",
        |base, exponent| base + exponent,
    ),
    (
        12,
        "divides by the base times the exponent where that is negative",
        |base, exponent| divided(base, exponent).unwrap_or(base.powf(exponent)),
    ),
    (
        12,
        "multiplies by the exponent instead of raising to the power, and divides where that is negative",
        |base, exponent| divided(base, exponent).unwrap_or(base * exponent),
    ),
];

/// 1 over the base times the exponent's size, where the exponent is negative.
fn divided(base: f64, exponent: f64) -> Option<f64> {
    (exponent < 0.0).then(|| -1.0 / (base * exponent))
}

/// What people make of several things of which one is enough: how common it is, in words before what is decided, and what they decide.
pub const AMONG: &[(u32, &str, Among)] = &[
    (2, "lets the last alone count", |all| {
        all.last() == Some(&true)
    }),
    (2, "lets the first alone count", |all| {
        all.first() == Some(&true)
    }),
    (2, "leaves out the first", |all| {
        all.iter().skip(1).any(|one| *one)
    }),
    (2, "leaves out the last", |all| {
        all.iter().rev().skip(1).any(|one| *one)
    }),
    (2, "wants all, where one is enough,", |all| {
        all.iter().all(|one| *one)
    }),
];

/// Where the least number is, if one of them does not count.
fn least_without(of: &[f64], out: usize) -> usize {
    let mut left = of.to_vec();
    if let Some(one) = left.get_mut(out) {
        *one = f64::INFINITY;
    }
    least(&left)
}

/// Which of several things people choose instead of the one with the least number: how common it is, and in words before what is chosen.
pub const CHOICES: &[(u32, &str, Pick)] = &[
    (9, "takes the wrong end, < for > or min for max,", |of| {
        least(&of.iter().map(|v| -v).collect::<Vec<_>>())
    }),
    (9, "takes the first of all", |_| 0),
    (9, "takes the last of all", |of| of.len() - 1),
    (10, "leaves out the first of all", |of| least_without(of, 0)),
    (10, "leaves out the second of all", |of| {
        least_without(of, 1)
    }),
    (10, "leaves out the last of all", |of| {
        least_without(of, of.len() - 1)
    }),
    (11, "takes the second best", |of| {
        least_without(of, least(of))
    }),
    (11, "takes the last of those that are equal", |of| {
        let all = of.iter().enumerate();
        all.rev()
            .min_by(|a, b| a.1.total_cmp(b.1))
            .map_or(0, |(i, _)| i)
    }),
    (12, "goes by the absolute values", |of| {
        least(&of.iter().map(|v| v.abs()).collect::<Vec<_>>())
    }),
];

/// From which round people take a value that each has anew: how common it is, what is done, and the round. Rounds are often those of
/// x, y and z, and are counted by threes.
pub const EARLIER: &[(u32, &str, Earlier)] = &[
    (12, "the value of the round before", |round| {
        round.max(1) - 1
    }),
    (
        12,
        "the value of the first round in every round, as that along x for y and z too",
        |round| round - round % 3,
    ),
    (
        13,
        "the value of the first round in the second too, as that along x for y",
        |round| round - usize::from(round % 3 == 1),
    ),
    (
        13,
        "the value of the first round in the third too, as that along x for z",
        |round| if round % 3 == 2 { round - 2 } else { round },
    ),
    (
        13,
        "the value of the second round in the third too, as that along y for z",
        |round| round - usize::from(round % 3 == 2),
    ),
];

/// What people make of the rounds of a loop: how common it is, in words before what it goes through, and the rounds.
pub const ROUNDS: &[(u32, &str, Rounds)] = &[
    (9, "leaves out the last of", |all| {
        all.start..all.end.max(1) - 1
    }),
    (9, "leaves out the first of", |all| {
        (all.start + 1).min(all.end)..all.end
    }),
    (10, "ends after the first of", |all| {
        all.start..all.end.min(1)
    }),
    (11, "ends after the second of", |all| {
        all.start..all.end.min(2)
    }),
    (12, "ends after the third of", |all| {
        all.start..all.end.min(3)
    }),
    (12, "ends after the fourth of", |all| {
        all.start..all.end.min(4)
    }),
];

/// In which order people go through things: how common it is, in words, and the order.
pub const ORDERS: &[(u32, &str, Order)] = &[
    (9, "goes through {} backwards", |n| (0..n).rev().collect()),
    (12, "takes the first of {} last", |n| {
        (1..n).chain(0..n.min(1)).collect()
    }),
    (12, "takes the last of {} first", |n| {
        (n.saturating_sub(1)..n)
            .chain(0..n.saturating_sub(1))
            .collect()
    }),
];

/// What people write for a number: how common it is, and the number. One more and one less first, twice and half of it, and all small ones.
pub fn limits(right: usize) -> Vec<(u32, usize)> {
    /// The largest of the small ones.
    const SMALL: usize = 16;
    let near = [right + 1, right.saturating_sub(1)].map(|other| (9, other));
    let multiples = [right / 2, 2 * right].map(|other| (10, other));
    let small = (0..=SMALL).map(|other| (11, other));
    let mut all: Vec<_> = near.into_iter().chain(multiples).chain(small).collect();
    all.sort_by_key(|(rank, other)| (*other, *rank));
    all.dedup_by_key(|(_, other)| *other);
    all.retain(|(_, other)| *other != right);
    all
}

/// What people make of two numbers that they compare: how common it is, in words before what is decided, and the numbers.
pub const SIDES: &[(u32, &str, Sides)] = &[
    (10, "compares a square with what is no square", |a, b| {
        [a * a, b]
    }),
    (10, "compares a root with what is no root", |a, b| {
        [a.max(0.0).sqrt(), b]
    }),
    (10, "compares what is no square with a square", |a, b| {
        [a, b * b]
    }),
    (11, "compares the absolute value", |a, b| [a.abs(), b]),
    (11, "compares with twice the number", |a, b| [a, 2.0 * b]),
    (11, "compares with half of the number", |a, b| [a, 0.5 * b]),
    (11, "compares with the negative number", |a, b| [a, -b]),
    (12, "compares with 1 more", |a, b| [a, b + 1.0]),
    (12, "compares with 1 less", |a, b| [a, b - 1.0]),
    (12, "compares with ½ more", |a, b| [a, b + 0.5]),
    (12, "compares with ½ less", |a, b| [a, b - 0.5]),
];

/// Thresholds that people write for 0; of those that explain the answers the largest is told.
pub const NEAR: [f64; 6] = [1e-2, 1e-3, 1e-4, 1e-6, 2e-2, 0.1];
