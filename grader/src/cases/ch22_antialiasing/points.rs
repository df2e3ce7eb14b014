//! What judges ask of points of the unit square.

use crate::together::{self, Bounds};
use crate::{Flaw, Verdict};
use glam::Vec2;

/// Chance makes the largest deviation of a distribution from its law larger than this over √n with a probability of
/// 2 exp(−2·3.5²) = 5e-11 (Kolmogorov; Massart 1990).
const DEVIATION: f64 = 3.5;

/// Chance makes that deviation smaller than this over √n with a probability of √2π/0.2 · exp(−π²/(8 · 0.2²)) = 5e-13 (Kolmogorov 1933).
const EVEN: f32 = 0.2;

/// What is wrong where [`in_square`] complains of the number.
pub const COUNT: Flaw = Flaw {
    complaint: "were asked",
    name: "makes another number of points than asked",
    hint: "Where does your loop begin, and where does it end?",
};

/// What is wrong where [`all_inside`] complains.
pub const OUTSIDE: Flaw = Flaw {
    complaint: "is not in the unit square",
    name: "puts points outside of the unit square",
    hint: "From where to where does your random number go, and by what is it divided?",
};

/// What is wrong where [`crate::judge::scattered`] complains of equal points.
pub const SAME: Flaw = Flaw {
    complaint: "each is to be chosen by itself",
    name: "gives several points the same place, or the same place in their cells",
    hint: "How often is your generator asked, and how often is it started again? How many different numbers can it give?",
};

/// What is wrong where points are on a line.
pub const LINE: Flaw = Flaw {
    complaint: "on one line along an axis",
    name: "chooses one coordinate at random only",
    hint: "Is each of the two coordinates chosen by a random number of its own?",
};

/// What is wrong where [`uniform`] complains.
pub const UNEVEN: Flaw = Flaw {
    complaint: "it is not the same everywhere",
    name: "does not choose all places equally often: some places get more points than others, or none",
    hint: "From where to where does your random number go, and is it changed afterwards: squared, rounded, divided, added to another?",
};

/// What is wrong where [`independent`] complains.
pub const TOGETHER: Flaw = Flaw {
    complaint: "go together",
    name: "chooses coordinates that depend on each other",
    hint: "Is each of the two coordinates chosen by a random number of its own?",
};

/// What is wrong where [`crate::together::seeded`] complains of all seeds.
pub const SEED: Flaw = Flaw {
    complaint: "does your generator start from it?",
    name: "ignores the seed",
    hint: "What does your generator start from? The same seed must give the same points, and another seed others.",
};

/// What is wrong where it complains of some seeds.
pub const PART_OF_SEED: Flaw = Flaw {
    complaint: "does your generator start from all of it?",
    name: "ignores a part of the seed",
    hint: "Does your generator start from all of the seed, or from some of its digits?",
};

/// What is wrong where it can't tell which of the two it is.
pub const SEED_OR_PART: Flaw = Flaw {
    complaint: "does your generator start from it, and from all of it?",
    name: "ignores the seed, or a part of it",
    hint: "What does your generator start from: from all of the seed, or from some of its digits?",
};

/// What is wrong where it complains of one coordinate.
pub const SEED_OF_ONE: Flaw = Flaw {
    complaint: "does each coordinate's generator start from it?",
    name: "ignores the seed in one coordinate",
    hint: "Do all your random numbers come from a generator that starts from the seed?",
};

/// What is wrong where [`crate::together::serial`] complains.
pub const SERIAL: Flaw = Flaw {
    complaint: "that of the next",
    name: "chooses points that depend on the point before",
    hint: "Is a point chosen by random numbers of its own, or by those of another point?",
};

/// What is asked of pairs of independent uniform numbers of all answers together, in whatever order: `names` are those of the first
/// and of the second, `both` that of both.
///
/// # Errors
/// If chance does not explain them.
pub fn together(lists: &[&Vec<Vec2>], names: [&str; 2], both: &str, bounds: Bounds) -> Verdict {
    let all = || lists.iter().copied().flatten();
    for (axis, name) in names.into_iter().enumerate() {
        uniform(name, all().map(|p| p[axis]), bounds)?;
    }
    independent(both, all().copied(), bounds)?;
    for (axis, name) in names.into_iter().enumerate() {
        let along = |list: &&Vec<Vec2>| list.iter().map(|p| p[axis].into()).collect();
        together::fills(name, all().map(|p| p[axis].into()), bounds)?;
        together::balanced(name, lists.iter().map(along), bounds)?;
    }
    Ok(())
}

/// Whether each pair is independent of the next: `names` are those of the first number, of the second and of either, and `next`
/// says what comes next.
///
/// # Errors
/// If chance does not explain how they hang together.
pub fn serial(lists: &[&Vec<Vec2>], names: [&str; 3], next: &str, bounds: Bounds) -> Verdict {
    for (axis, name) in names.into_iter().take(2).enumerate() {
        let along = |list: &&Vec<Vec2>| list.iter().map(|p| p[axis].into()).collect();
        together::serial(name, next, lists.iter().map(along), bounds)?;
    }
    let each = |p: &Vec2| p.to_array().map(f64::from);
    let each = |list: &&Vec<Vec2>| list.iter().flat_map(each).collect();
    together::serial(names[2], next, lists.iter().map(each), bounds)
}

/// `expected` points, each in [0, 1)².
///
/// # Errors
/// If there are more or fewer, or one is outside.
pub fn in_square(expected: usize, points: &[Vec2]) -> Verdict {
    if points.len() != expected {
        return Err(format!(
            "there are {} points; {expected} were asked",
            points.len()
        ));
    }
    all_inside(points)
}

/// All of them in [0, 1)², as far as can be told: what is printed with a few digits may have been rounded up to 1.
///
/// # Errors
/// If one is outside.
pub fn all_inside(points: &[Vec2]) -> Verdict {
    for (p, i) in points.iter().zip(1..) {
        if !(p.cmpge(Vec2::ZERO).all() && p.cmple(Vec2::ONE).all()) {
            return Err(format!(
                "point {i} at ({}, {}) is not in the unit square, 0 ≤ x < 1 and 0 ≤ y < 1",
                p.x, p.y
            ));
        }
    }
    Ok(())
}

/// The same points in any order.
///
/// # Errors
/// If one is missing, or one too many.
pub fn same_places(golden: &[Vec2], got: &[Vec2], tolerance: f32) -> Verdict {
    if got.len() != golden.len() {
        return Err(format!(
            "there are {} points; there should be {}",
            got.len(),
            golden.len()
        ));
    }
    let mut left = got.to_vec();
    for p in golden {
        let near = |q: &Vec2| p.distance(*q) <= tolerance;
        let Some(i) = left.iter().position(near) else {
            return Err(format!(
                "a point should be at ({:.4}, {:.4}), and none is there",
                p.x, p.y
            ));
        };
        left.swap_remove(i);
    }
    Ok(())
}

/// Numbers that are uniform in [0, 1): the largest deviation of their distribution from the diagonal (Kolmogorov and Smirnov).
///
/// # Errors
/// If it is larger than chance makes it; `what` is between 0 and 1, `where_from` says where it counts from.
pub fn uniform(what: &str, numbers: impl Iterator<Item = f32>, bounds: Bounds) -> Verdict {
    let sorted = sorted(numbers);
    let n = sorted.len() as f32;
    let bound = bounds.of(DEVIATION) as f32 / n.sqrt();
    for (x, i) in sorted.iter().zip(0_u32..) {
        let (below, up_to) = (i as f32 / n, (i + 1) as f32 / n);
        if below - x > bound || x - up_to > bound {
            let share = 100.0 * if below > *x { below } else { up_to };
            return Err(format!(
                "{what} is below {x:.3} for {share:.1} % of the points: it is not the same everywhere, and chance does not explain it"
            ));
        }
    }
    Ok(())
}

/// Numbers that are uniform in [0, 1) and independent: the same deviation, which even steps keep below 1/n.
///
/// # Errors
/// If it is smaller than chance makes it.
pub fn by_chance(what: &str, numbers: impl Iterator<Item = f32>) -> Verdict {
    let sorted = sorted(numbers);
    let n = sorted.len() as f32;
    let off = |(x, i): (&f32, u32)| (x - (i as f32 + 0.5) / n).abs() + 0.5 / n;
    let most = sorted.iter().zip(0_u32..).map(off).fold(0.0, f32::max);
    if most < EVEN / n.sqrt() {
        return Err(format!(
            "{what} goes through the points at even steps, which chance does not make"
        ));
    }
    Ok(())
}

fn sorted(numbers: impl Iterator<Item = f32>) -> Vec<f32> {
    let mut sorted: Vec<_> = numbers.collect();
    sorted.sort_by(f32::total_cmp);
    sorted
}

/// Two numbers of each point, uniform in [0, 1), that have nothing to do with each other: their correlation.
///
/// # Errors
/// If it is larger than chance makes it: 6.5 standard deviations, which have a probability of 8e-11.
pub fn independent(what: &str, pairs: impl Iterator<Item = Vec2>, bounds: Bounds) -> Verdict {
    let products: Vec<_> = pairs.map(|p| (p.x - 0.5) * (p.y - 0.5)).collect();
    let n = products.len() as f32;
    // The product's standard deviation is 1/12, and it is never more than three times that: Bernstein's bound.
    let mean = products.iter().sum::<f32>() / n.max(1.0);
    let bound = bounds.of(6.5 / 12.0) as f32 / n.sqrt() * (1.0 + 2.0 / n.sqrt());
    if mean.abs() > bound {
        Err(format!(
            "{what} go together: where one is large, so is the other, or the other way round"
        ))
    } else {
        Ok(())
    }
}
