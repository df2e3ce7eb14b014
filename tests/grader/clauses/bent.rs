//! Answers that are right but for one clause of a sentence.

use glam::DVec3;
use std::f64::consts::PI;

/// The right answer to a question, in numbers.
pub type Right = fn(&[f64]) -> Vec<f64>;

/// An answer that breaks a clause.
pub struct Bent {
    pub exercise: &'static str,
    /// What it does, as a verb.
    pub name: &'static str,
    pub answer: fn(Right, &[f64]) -> Vec<f64>,
}

const fn bent(
    exercise: &'static str,
    name: &'static str,
    answer: fn(Right, &[f64]) -> Vec<f64>,
) -> Bent {
    Bent {
        exercise,
        name,
        answer,
    }
}

/// Where the interval stands in a question that begins with a ray.
const MIN: usize = 6;
const MAX: usize = 7;

const AT_MIN: &str = "lets t = min count";
const AT_MAX: &str = "lets t = max count";
const NO_POSITIVE: &str = "takes 0 for a positive min";

pub const BENT: &[Bent] = &[
    bent("encode_srgb", "does not clamp below 0", |right, q| {
        if q[0] < 0.0 {
            vec![12.92 * q[0]]
        } else {
            right(q)
        }
    }),
    bent("encode_srgb", "does not clamp above 1", |right, q| {
        if q[0] > 1.0 {
            vec![1.055 * q[0].powf(1.0 / 2.4) - 0.055]
        } else {
            right(q)
        }
    }),
    bent("encode_srgb", "clamps from 1.1 on only", |right, q| {
        if (1.0..1.1).contains(&q[0]) {
            vec![1.055 * q[0].powf(1.0 / 2.4) - 0.055]
        } else {
            right(q)
        }
    }),
    bent("encode_srgb", "clamps from −0.1 down only", |right, q| {
        if (-0.1..0.0).contains(&q[0]) {
            vec![12.92 * q[0]]
        } else {
            right(q)
        }
    }),
    bent(
        "solve_quadratic",
        "calls the equation with a = 0 one of a small a",
        |right, q| {
            if q[0] == 0.0 {
                right(&with(q, 0, 1e-9))
            } else {
                right(q)
            }
        },
    ),
    bent("sphere_hit", AT_MIN, at_min),
    bent("sphere_hit", AT_MAX, at_max),
    bent("sphere_hit", NO_POSITIVE, no_positive),
    bent("sphere_hit", "misses spheres that it grazes", |right, q| {
        let [o, d, c] = [0, 3, 8].map(|at| DVec3::from_slice(&q[at..]));
        let beside = (c - o).cross(d).length() / d.length();
        none_if(beside > 0.998 * q[11], right(q))
    }),
    bent("plane_hit", AT_MIN, at_min),
    bent("plane_hit", AT_MAX, at_max),
    bent("plane_hit", NO_POSITIVE, no_positive),
    bent(
        "plane_hit",
        "calls a ray a miss that is parallel to within 10⁻⁴",
        |right, q| {
            let [d, n] = [3, 8].map(|at| DVec3::from_slice(&q[at..]));
            none_if(d.dot(n).abs() < 1e-4, right(q))
        },
    ),
    bent("box_clip", NO_POSITIVE, no_positive),
    bent(
        "box_clip",
        "answers with the whole interval where the ray misses",
        |right, q| for_none(right(q), &[1.0, q[MIN], q[MAX]]),
    ),
    bent(
        "box_clip",
        "counts a parallel ray as inside that is up to 1 m outside",
        |right, q| {
            let mut wider = q.to_vec();
            for axis in (0..3).filter(|axis| q[3 + axis] == 0.0) {
                wider[8 + axis] -= 1.0;
                wider[11 + axis] += 1.0;
            }
            right(&wider)
        },
    ),
    bent("triangle_hit", AT_MIN, at_min),
    bent("triangle_hit", AT_MAX, at_max),
    bent("triangle_hit", NO_POSITIVE, no_positive),
    bent(
        "triangle_hit",
        "takes a determinant below 10⁻⁷ for 0",
        |right, q| {
            let [d, p0, p1, p2] = [3, 8, 11, 14].map(|at| DVec3::from_slice(&q[at..]));
            none_if((p1 - p0).dot(d.cross(p2 - p0)).abs() < 1e-7, right(q))
        },
    ),
    bent(
        "triangle_normal",
        "takes +z for the normal of a triangle without area",
        |right, q| for_none(right(q), &[1.0, 0.0, 0.0, 1.0]),
    ),
    bent("mesh_hit", AT_MIN, at_min),
    bent("mesh_hit", AT_MAX, at_max),
    bent("mesh_hit", NO_POSITIVE, no_positive),
    bent(
        "mesh_hit",
        "answers with triangle 0 at max where all are missed",
        |right, q| for_none(right(q), &[1.0, q[MAX], 0.0]),
    ),
    bent(
        "grid_resolution",
        "counts one cell more along each axis",
        |right, q| right(q).iter().map(|cells| cells + 1.0).collect(),
    ),
    bent(
        "grid_walk",
        "ends the last distance where the ray leaves the cell",
        |right, q| {
            let (mut answer, whole) = (right(q), right(&with(q, 16, f64::INFINITY)));
            if let Some(last) = answer.len().checked_sub(1).filter(|&last| last > 0) {
                answer[last] = whole[last];
            }
            answer
        },
    ),
    bent("bvh_closest", AT_MIN, at_min),
    bent("bvh_closest", AT_MAX, at_max),
    bent("wide_closest", AT_MIN, at_min),
    bent("wide_closest", AT_MAX, at_max),
    bent(
        "lit",
        "never asks a sphere that the light is inside of",
        |right, q| {
            let light = DVec3::from_slice(q) + q[10] * DVec3::from_slice(&q[7..]);
            let around = |s: &&[f64]| DVec3::from_slice(s).distance(light) < s[3];
            let others: Vec<_> = q[12..].chunks(4).filter(|s| !around(s)).collect();
            let question = [&q[..11], &[others.len() as f64], &others.concat()].concat();
            right(&question)
        },
    ),
    bent(
        "environment_pdf",
        "spreads the density evenly for a black map",
        |right, q| {
            let is_black = q[6..].iter().all(|&radiance| radiance == 0.0);
            if is_black { vec![0.25 / PI] } else { right(q) }
        },
    ),
    bent(
        "sample_environment",
        "answers with one direction less",
        |right, q| {
            let mut answer = right(q);
            answer[0] -= 1.0;
            answer.truncate(answer.len() - 3);
            answer
        },
    ),
    bent("deflection_angle", "is off by 1 part in 200", |right, q| {
        let mut answer = right(q);
        if let Some(angle) = answer.get_mut(1) {
            *angle *= 1.005;
        }
        answer
    }),
    bent(
        "geodesic_step",
        "moves straight on, and turns the velocity only",
        |right, q| {
            let after = DVec3::from_slice(q) + q[6] * DVec3::from_slice(&q[3..]);
            [&after.to_array(), &right(q)[3..]].concat()
        },
    ),
    bent(
        "brdf_phong",
        "shows the matte part to a viewer up to 30° below the surface",
        |right, q| shown_from_below(right, q, 3, 6),
    ),
    bent(
        "brdf_phong",
        "lights the matte part from up to 30° below the surface",
        |right, q| shown_from_below(right, q, 6, 3),
    ),
    bent(
        "pixel_average",
        "returns black where the weights sum up to less than 0.3",
        |right, q| {
            let tent = |s: &[f64]| -> f64 {
                let factors = s[..2].iter().map(|x| (1.0 - x.abs() / q[0]).max(0.0));
                factors.product()
            };
            let sum: f64 = q[2..].chunks(5).map(tent).sum();
            if sum < 0.3 { vec![0.0; 3] } else { right(q) }
        },
    ),
    bent(
        "pixel_average",
        "answers with the first sample where the weights sum up to 0",
        |right, q| {
            let answer = right(q);
            match q.get(4..7) {
                Some(first) if answer == [0.0; 3] => first.to_vec(),
                _ => answer,
            }
        },
    ),
    bent(
        "spend_budget",
        "moves half of the largest share to the next pixel",
        |right, q| {
            let mut answer = right(q);
            let shares = &mut answer[1..];
            let largest = (0..shares.len()).max_by(|&a, &b| shares[a].total_cmp(&shares[b]));
            let Some(largest) = largest else {
                return answer;
            };
            let moved = (0.5 * shares[largest]).floor();
            shares[largest] -= moved;
            shares[(largest + 1) % shares.len()] += moved;
            answer
        },
    ),
];

/// A question with another number at a place.
fn with(q: &[f64], at: usize, number: f64) -> Vec<f64> {
    let mut q = q.to_vec();
    q[at] = number;
    q
}

/// The interval's ends count: they lie just inside a slightly larger interval.
fn at_min(right: Right, q: &[f64]) -> Vec<f64> {
    right(&with(q, MIN, (q[MIN] as f32).next_down().into()))
}

fn at_max(right: Right, q: &[f64]) -> Vec<f64> {
    right(&with(q, MAX, (q[MAX] as f32).next_up().into()))
}

fn no_positive(right: Right, q: &[f64]) -> Vec<f64> {
    right(&with(q, MIN, q[MIN].min(0.0)))
}

fn none_if(is_none: bool, answer: Vec<f64>) -> Vec<f64> {
    if is_none { vec![0.0] } else { answer }
}

fn for_none(answer: Vec<f64>, other: &[f64]) -> Vec<f64> {
    if answer == [0.0] {
        other.to_vec()
    } else {
        answer
    }
}

/// The answer of `brdf_phong`, or the matte part of it where the first of these two directions is up to 30° below the surface, and the
/// other one above.
fn shown_from_below(right: Right, q: &[f64], below: usize, above: usize) -> Vec<f64> {
    let normal = DVec3::from_slice(q);
    let [below, above] = [below, above].map(|at| normal.dot(DVec3::from_slice(&q[at..])));
    if (-0.5..=0.0).contains(&below) && above > 0.0 {
        q[9..12].iter().map(|diffuse| diffuse / PI).collect()
    } else {
        right(q)
    }
}
