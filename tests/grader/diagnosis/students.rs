//! Mistakes as students make them, in functions written from the exercises' texts before anyone looked at the lists: each has its name.

use super::mistakes::{Slip, cross, dot, minus, misread, slip};

/// The numbers of an answer that may be none.
fn some(answer: Option<Vec<f64>>) -> Vec<f64> {
    answer.map_or(vec![0.0], |numbers| [&[1.0], &numbers[..]].concat())
}

/// sRGB's curve: the factor, the offset, and what is made of the power's argument.
fn srgb(q: &[f64], factor: f64, offset: f64, inner: f64) -> Vec<f64> {
    let v = q[0].clamp(0.0, 1.0);
    if v <= f64::from(0.003_130_8_f32) {
        return vec![12.92 * v];
    }
    vec![factor * (inner * v).powf(1.0 / 2.4) - offset]
}

/// The roots by the formula of t² + p t + q = 0, with a square of p/2 and a way to the other root.
fn roots(q: &[f64], square: fn(f64) -> f64, other: fn(&[f64], f64) -> f64) -> Vec<f64> {
    if q[0] == 0.0 {
        return vec![0.0];
    }
    let (half, last) = (0.5 * q[1] / q[0], q[2] / q[0]);
    let inside = square(half) - last;
    if inside < 0.0 {
        return vec![0.0];
    }
    let large = -half - inside.sqrt().copysign(half);
    let small = other(q, large);
    vec![1.0, large.min(small), large.max(small)]
}

/// The part of an interval inside a box, with its own distance of the least plane and its own first interval.
fn clipped(q: &[f64], least: fn(f64, f64, f64) -> f64, mut within: [f64; 2]) -> Vec<f64> {
    for axis in 0..3 {
        let (o, d, low, high) = (q[axis], q[3 + axis], q[8 + axis], q[11 + axis]);
        if d == 0.0 {
            if o < low || high < o {
                return vec![0.0];
            }
            continue;
        }
        let [low, high] = [least(low, o, d), (high - o) / d];
        let [near, far] = if d < 0.0 { [high, low] } else { [low, high] };
        within = [within[0].max(near), within[1].min(far)];
    }
    some((within[0] <= within[1]).then(|| within.to_vec()))
}

/// The mistakes.
pub const STUDENTS: &[Slip] = &[
    slip(
        "encode_srgb",
        "adds 0.055",
        &["the offset 0.055”: has the sign"],
        |q, _| srgb(q, 1.055, -0.055, 1.0),
    ),
    slip(
        "encode_srgb",
        "forgets 1.055",
        &["the factor 1.055”: takes 1"],
        |q, _| srgb(q, 1.0, 0.055, 1.0),
    ),
    slip(
        "encode_srgb",
        "takes 1.055 into the power",
        &["takes the factor 1.055 into the power"],
        |q, _| srgb(q, 1.0, 0.055, 1.055),
    ),
    slip(
        "solve_quadratic",
        "does not square p/2",
        &["instead of the square of “p = B/A”", "“(p/2)²”"],
        |q, _| roots(q, |half| 0.5 * half, |q, large| q[2] / q[0] / large),
    ),
    slip(
        "solve_quadratic",
        "divides by 2 and multiplies by a",
        &["writes /2*a"],
        |q, right| {
            let square = q[0] * q[0];
            let times = |(i, v): (usize, f64)| if i == 0 { v } else { square * v };
            right(q).into_iter().enumerate().map(times).collect()
        },
    ),
    slip(
        "sphere_hit",
        "does not square the foot's distance",
        &["“s = (c − o)·d” where that of “s²” belongs"],
        |q, _| {
            let to_center = minus(&q[8..11], &q[..3]);
            let foot = dot(&to_center, &q[3..6]);
            let square = q[11] * q[11] - (dot(&to_center, &to_center) - foot);
            let half = (square >= 0.0).then(|| square.sqrt());
            let counts = |t: &f64| q[6] < *t && *t < q[7];
            let both = half.map(|half| [foot - half, foot + half]);
            let first = both.and_then(|both| both.into_iter().find(counts));
            some(first.map(|t| vec![t]))
        },
    ),
    slip(
        "plane_hit",
        "takes the direction for the normal above the line",
        &["“d” where that of “n in the numerator” belongs"],
        |q, _| {
            let (d, n) = (&q[3..6], &q[8..11]);
            let point: Vec<_> = n.iter().map(|n| q[11] * n).collect();
            let t = dot(&minus(&point, &q[..3]), d) / dot(n, d);
            some((dot(n, d) != 0.0 && q[6] < t && t < q[7]).then(|| vec![t]))
        },
    ),
    slip(
        "box_clip",
        "has the sign of the least plane's distance wrong",
        &["“t of the least plane”: has the sign of the value wrong"],
        |q, _| clipped(q, |low, o, d| (o - low) / d, [q[6], q[7]]),
    ),
    slip(
        "box_clip",
        "begins at 0, whatever the interval is",
        &["takes 0 for within.min"],
        |q, _| clipped(q, |low, o, d| (low - o) / d, [0.0, q[7]]),
    ),
    slip(
        "bounds_of",
        "compares with < for the greatest corner too, which stays at −∞",
        &["ignores the list"],
        |q, right| {
            let mut corners = right(q);
            corners[3..].fill(f64::NEG_INFINITY);
            corners
        },
    ),
    slip(
        "triangle_hit",
        "forgets the origin in the point of the hit",
        &["“o in o + t·d”"],
        |q, _| {
            let (d, p0, p1, p2) = (&q[3..6], &q[8..11], &q[11..14], &q[14..17]);
            let n = cross(&minus(p1, p0), &minus(p2, p0));
            let speed = dot(&n, d);
            let t = dot(&n, &minus(p0, &q[..3])) / speed;
            let p: Vec<_> = d.iter().map(|d| t * d).collect();
            let weight = |a: &[f64], b: &[f64]| dot(&n, &cross(&minus(b, a), &minus(&p, a)));
            let all = [weight(p1, p2), weight(p2, p0), weight(p0, p1)];
            let hit = speed != 0.0 && q[6] < t && t < q[7] && all.iter().all(|w| *w >= 0.0);
            let area = dot(&n, &n);
            some(hit.then(|| vec![t, all[1] / area, all[2] / area]))
        },
    ),
    slip(
        "grid_walk",
        "counts the cells from 1",
        &["counts x, y, z from 1 instead of 0"],
        |q, right| {
            let mut visits = right(q);
            for visit in visits[1..].chunks_mut(4) {
                visit[..3].iter_mut().for_each(|i| *i += 1.0);
            }
            visits
        },
    ),
    slip(
        "octree_walk",
        "ignores the interval",
        &["ignores within and takes all that lies ahead"],
        |q, right| misread(q, right, |q| (q[6], q[7]) = (0.0, f64::INFINITY)),
    ),
    slip(
        "two_level_walk",
        "goes on beyond the interval's end, but not along two planes",
        &["goes on beyond the end of the interval"],
        |q, right| {
            let zeros = q[3..6].iter().filter(|d| **d == 0.0).count();
            let max = if zeros == 2 { q[7] } else { f64::INFINITY };
            misread(q, right, |q| q[7] = max)
        },
    ),
    slip(
        "sah_cost",
        "takes the cost of the left child for the right one's",
        &["left child” where that of “the cost of a branch's right child"],
        |q, _| {
            let rows: Vec<_> = q[3..].chunks(8).collect();
            let area = |row: &[f64]| {
                let [x, y, z] = [0, 1, 2].map(|k| row[3 + k] - row[k]);
                x * y + y * z + z * x
            };
            let mut costs = vec![0.0; rows.len()];
            for (i, row) in rows.iter().enumerate().rev() {
                let (first, count) = (row[6] as usize, row[7]);
                costs[i] = if count > 0.0 {
                    q[1] * count
                } else {
                    let both = area(rows[first]) + area(rows[first + 1]);
                    q[0] + both / area(row) * costs[first]
                };
            }
            vec![costs[0]]
        },
    ),
];
