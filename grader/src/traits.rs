//! Numbers by which mistakes are told apart where many answers are right: shares of a distribution, means, costs. None of them depends on
//! the order of what is in a list.

use glam::{DVec2, DVec3, Vec2, Vec3};

/// How many equal parts of a range are counted.
const BINS: usize = 8;

/// Which share of the numbers is in each of eight equal parts of [from, to), and which is outside.
pub fn shares(numbers: impl IntoIterator<Item = f64>, from: f64, to: f64) -> Vec<f64> {
    let mut counts = [0.0; BINS + 1];
    let mut all = 0.0_f64;
    for v in numbers {
        let place = (v - from) / (to - from) * BINS as f64;
        let bin = if (-1e-4..BINS as f64 + 1e-4).contains(&place) {
            (place.max(0.0) as usize).min(BINS - 1)
        } else {
            BINS
        };
        counts[bin] += 1.0;
        all += 1.0;
    }
    counts.iter().map(|count| count / all.max(1.0)).collect()
}

/// The share of different values among numbers.
pub fn distinct(numbers: impl IntoIterator<Item = f64>) -> f64 {
    let mut places: Vec<_> = numbers
        .into_iter()
        .map(|v| (1e4 * v).round() as i64)
        .collect();
    let all = places.len().max(1) as f64;
    places.sort_unstable();
    places.dedup();
    places.len() as f64 / all
}

/// How unevenly numbers in [0, 1) are shared among groups, equal parts of this range: 0 if all have as many, about 1 by chance, and never more
/// than 4.
pub fn unevenness(numbers: impl IntoIterator<Item = f64>, groups: u32) -> f64 {
    let groups = groups.max(1);
    let mut counts = vec![0.0_f64; groups as usize];
    for v in numbers {
        let group = (f64::from(groups) * v) as usize; // the nearest, if it is outside of the range
        counts[group.min(groups as usize - 1)] += 1.0;
    }
    let n = counts.iter().sum::<f64>().max(1.0);
    let mean = n / f64::from(groups);
    let squares: f64 = counts.iter().map(|count| (count - mean).powi(2)).sum();
    (squares / n).min(4.0)
}

/// The logarithm of a positive number, within bounds.
pub fn log(v: f64) -> f64 {
    v.abs().clamp(1e-6, 1e6).ln()
}

/// The traits of points of the unit square: how x and y are distributed, how they hang together, and whether they crowd.
pub fn of_square(points: &[DVec2]) -> Vec<f64> {
    let n = points.len().max(1) as f64;
    let mut traits = shares(points.iter().map(|p| p.x), 0.0, 1.0);
    traits.extend(shares(points.iter().map(|p| p.y), 0.0, 1.0));
    let middle = points
        .iter()
        .map(|p| (p.x - 0.5) * (p.y - 0.5))
        .sum::<f64>()
        / n;
    let corners = points
        .iter()
        .filter(|p| p.distance(DVec2::splat(0.5)) > 0.5)
        .count() as f64
        / n;
    traits.extend([6.0 * middle, corners]);
    traits.extend([
        distinct(points.iter().map(|p| p.x)),
        distinct(points.iter().map(|p| p.y)),
    ]);
    traits.push(nearest(points) * n.sqrt());
    // Cells of a lattice of about as many cells as points that have none.
    let side = n.sqrt().floor().max(1.0);
    let mut counts = vec![0_u32; (side * side) as usize];
    for p in points {
        let cell = (side * *p)
            .floor()
            .clamp(DVec2::ZERO, DVec2::splat(side - 1.0));
        counts[(cell.y * side + cell.x) as usize] += 1;
    }
    traits.push(counts.iter().filter(|count| **count == 0).count() as f64 / (side * side));
    traits
}

/// The mean distance to the nearest other point, of at most 500 points; 1 is the most.
pub fn nearest(points: &[DVec2]) -> f64 {
    let mut few = points[..points.len().min(500)].to_vec();
    few.sort_unstable_by(|p, q| p.x.total_cmp(&q.x));
    let near = |(i, p): (usize, &DVec2)| {
        let (before, after) = (few[..i].iter().rev(), few[i + 1..].iter());
        let least = squared(p, before).min(squared(p, after));
        least.sqrt().min(1.0)
    };
    few.iter().enumerate().map(near).sum::<f64>() / few.len().max(1) as f64
}

/// The squared distance to the nearest of points that lie farther and farther away along x; only as many are looked at as may be nearer.
fn squared<'a>(p: &DVec2, others: impl Iterator<Item = &'a DVec2>) -> f64 {
    let mut least = f64::INFINITY;
    for q in others {
        if (p.x - q.x).powi(2) < least {
            least = least.min(p.distance_squared(*q));
        } else {
            break;
        }
    }
    least
}

/// The traits of points of the unit disc: how far out they are, whether they are all around, and whether they are round.
pub fn of_disc(points: &[Vec2]) -> Vec<f64> {
    let points: Vec<_> = points.iter().map(|p| p.as_dvec2()).collect();
    let n = points.len().max(1) as f64;
    let mut traits = shares(points.iter().map(|p| p.length()), 0.0, 1.0);
    traits.push(points.iter().sum::<DVec2>().length() / n);
    let round = |k: f64| {
        let turn = |p: &DVec2| DVec2::from_angle(k * p.to_angle()) * p.length();
        points.iter().map(turn).sum::<DVec2>().length() / n
    };
    traits.extend([round(2.0), round(4.0)]);
    traits.push(points.iter().filter(|p| p.is_nan()).count() as f64 / n);
    traits.push(points.iter().map(|p| p.length()).sum::<f64>() / n);
    traits
}

/// The traits of directions around a normal: how steep they are, whether they are all around, and their length.
pub fn of_directions(directions: &[Vec3], normal: Vec3) -> Vec<f64> {
    let normal = normal.as_dvec3();
    let directions: Vec<_> = directions.iter().map(|d| d.as_dvec3()).collect();
    let n = directions.len().max(1) as f64;
    let mut traits = shares(directions.iter().map(|d| d.dot(normal)), -1.0, 1.0);
    traits.extend(shares(directions.iter().map(|d| d.dot(normal)), 0.0, 1.0));
    let across = |d: &DVec3| *d - d.dot(normal) * normal;
    traits.push(directions.iter().map(across).sum::<DVec3>().length() / n);
    // How much longer than wide the directions are, seen along the normal.
    let (x, y) = normal.any_orthonormal_pair();
    let twice = |d: &DVec3| {
        let p = DVec2::new(d.dot(x), d.dot(y));
        DVec2::new(p.x * p.x - p.y * p.y, 2.0 * p.x * p.y)
    };
    traits.push(directions.iter().map(twice).sum::<DVec2>().length() / n);
    traits.push(directions.iter().map(|d| d.length().min(10.0)).sum::<f64>() / n);
    traits.push(directions.iter().map(|d| d.dot(normal)).sum::<f64>() / n);
    traits
}
