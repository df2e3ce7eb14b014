//! Changes of a right program that look like mistakes and are none: their answers are right, so that nobody can tell them from a solution.

use super::ASKED;
use glam::DVec3;
use raybook_common::{STALE, measured};
use raybook_grader::cases;
use raybook_workbook::row;
use std::fmt::Write;

/// A change that changes no answer.
pub struct Equivalent {
    pub exercise: &'static str,
    /// What it does, as a verb.
    name: &'static str,
    /// Why its answers are right.
    why: &'static str,
    answer: fn(&[f64]) -> Vec<f64>,
}

pub const EQUIVALENT: &[Equivalent] = &[
    Equivalent {
        exercise: "expose",
        name: "takes e^(stops · ln 2) for 2^stops",
        why: "2 is e^(ln 2)",
        answer: |q| {
            let factor = (q[3] * std::f64::consts::LN_2).exp();
            q[..3].iter().map(|v| v * factor).collect()
        },
    },
    Equivalent {
        exercise: "sphere_normal",
        name: "divides by the radius and does not normalise",
        why: "a point of the sphere is one radius from its centre",
        answer: |q| {
            let [center, p] = [0, 4].map(|at| vector(q, at));
            ((p - center) / q[3]).to_array().to_vec()
        },
    },
    Equivalent {
        exercise: "plane_hit",
        name: "divides by n·d without asking whether it is 0",
        why: "the quotient is infinite or no number, and neither is below max",
        answer: |q| {
            let [o, d, n] = [0, 3, 8].map(|at| vector(q, at));
            let t = (q[11] - n.dot(o)) / n.dot(d);
            if q[6] < t && t < q[7] {
                vec![1.0, t]
            } else {
                vec![0.0]
            }
        },
    },
    Equivalent {
        exercise: "plane_hit",
        name: "turns the plane round where the ray comes from behind",
        why: "−n and −offset describe the same plane",
        answer: |q| {
            let [o, d, n] = [0, 3, 8].map(|at| vector(q, at));
            let side = n.dot(d).signum();
            let (n, offset) = (side * n, side * q[11]);
            let t = (offset - n.dot(o)) / n.dot(d);
            if q[6] < t && t < q[7] {
                vec![1.0, t]
            } else {
                vec![0.0]
            }
        },
    },
    Equivalent {
        exercise: "triangle_normal",
        name: "crosses the edges p1p2 and p1p0 in the place of p0p1 and p0p2",
        why: "the corners run round in the same sense, from whichever one begins",
        answer: |q| {
            let [p0, p1, p2] = [0, 3, 6].map(|at| vector(q, at));
            let normal = (p2 - p1).cross(p0 - p1).normalize_or_zero();
            if normal == DVec3::ZERO {
                vec![0.0]
            } else {
                [&[1.0], &normal.to_array()[..]].concat()
            }
        },
    },
    Equivalent {
        exercise: "octree_child",
        name: "compares twice the point with the sum of both corners",
        why: "the middle is half of that sum",
        answer: |q| {
            let [min, max, p] = [0, 3, 6].map(|at| vector(q, at));
            let upper = (2.0 * p).cmpge(min + max);
            vec![f64::from(upper.bitmask())]
        },
    },
    Equivalent {
        exercise: "phong",
        name: "mirrors the viewer at N in the place of the light",
        why: "R·V = 2 (N·L)(N·V) − L·V is the same for both",
        answer: |q| {
            let [n, v, l] = [0, 3, 6].map(|at| vector(q, at));
            highlighted(q, (2.0 * n.dot(v) * n - v).dot(l))
        },
    },
    Equivalent {
        exercise: "blinn_phong",
        name: "halves L + V before normalising it",
        why: "a vector's length does not matter to its direction",
        answer: |q| {
            let [n, v, l] = [0, 3, 6].map(|at| vector(q, at));
            highlighted(q, n.dot((0.5 * (l + v)).normalize_or_zero()))
        },
    },
    Equivalent {
        exercise: "reflect",
        name: "turns the normal to the side from which the ray arrives",
        why: "2 (i·n) n holds n twice, so that its sign cancels",
        answer: |q| {
            let [i, n] = [0, 3].map(|at| vector(q, at));
            let n = if i.dot(n) > 0.0 { -n } else { n };
            (i - 2.0 * i.dot(n) * n).normalize().to_array().to_vec()
        },
    },
    Equivalent {
        exercise: "refract",
        name: "normalises the refracted direction once more",
        why: "its parts along the surface and the normal are a sine and a cosine: its length is 1",
        answer: |q| {
            let [i, n] = [0, 3].map(|at| vector(q, at));
            let (n, eta) = if i.dot(n) > 0.0 {
                (-n, q[7] / q[6])
            } else {
                (n, q[6] / q[7])
            };
            let along = eta * (i - i.dot(n) * n);
            let square = 1.0 - along.length_squared();
            if square < 0.0 {
                return vec![0.0];
            }
            let refracted = (along - square.sqrt() * n).normalize();
            [&[1.0], &refracted.to_array()[..]].concat()
        },
    },
    Equivalent {
        exercise: "direction_to_latlong",
        name: "normalises the direction first",
        why: "both angles are the same for any length",
        answer: |q| {
            let d = vector(q, 0).normalize();
            let u = 0.5 + d.x.atan2(-d.z) / std::f64::consts::TAU;
            vec![u, d.y.clamp(-1.0, 1.0).acos() / std::f64::consts::PI]
        },
    },
    Equivalent {
        exercise: "sample_rect",
        name: "exchanges the two uniform numbers",
        why: "the n·n pairs are the same ones in another order, and no sample comes before another",
        answer: |q| {
            let examiner = cases::find("sample_rect").expect("an exercise");
            let right = (examiner.asked().call)(q);
            let [is_there, count, samples @ ..] = right.as_slice() else {
                return right; // the light turns its back
            };
            let samples: Vec<_> = samples.chunks(samples.len() / *count as usize).collect();
            let n = count.sqrt() as usize;
            let other_order = (0..n * n).flat_map(|k| samples[k % n * n + k / n]);
            let all = [is_there, count].into_iter().chain(other_order);
            all.copied().collect()
        },
    },
];

/// The light of a lamp that a surface reflects, whose highlight is a power of this cosine.
fn highlighted(q: &[f64], cosine: f64) -> Vec<f64> {
    let [n, l, i, k_d, k_s] = [0, 6, 9, 12, 15].map(|at| vector(q, at));
    let shine = if cosine > 0.0 {
        cosine.powf(q[18])
    } else {
        0.0
    };
    let height = n.dot(l);
    let light = if height > 0.0 {
        (k_d * height + k_s * shine) * i
    } else {
        DVec3::ZERO
    };
    light.to_array().to_vec()
}

fn vector(q: &[f64], at: usize) -> DVec3 {
    DVec3::from_slice(&q[at..])
}

#[test]
fn equivalent_changes_are_right_in_every_case() {
    for Equivalent {
        exercise,
        name,
        answer,
        ..
    } in EQUIVALENT
    {
        let asked = ASKED
            .iter()
            .find(|asked| asked.examiner.name() == *exercise);
        let asked = asked.expect("an exercise");
        for case in asked.visible.iter().chain(asked.hidden.iter().flatten()) {
            let kinds = asked.examiner.asked();
            let question = kinds.read_question(&case.question).expect("a question");
            let got = row::format(kinds.answer.kind, &answer(&question));
            let verdict = asked.examiner.judge(&case.question, &case.answers, &got);
            assert_eq!(verdict, Ok(()), "{exercise}, who {name}: {}", case.question);
        }
    }
}

#[test]
fn the_table_of_equivalent_changes_is_that_of_today() {
    let mut table = String::from("| exercise | who … | is right, because … |\n|---|---|---|\n");
    for Equivalent {
        exercise,
        name,
        why,
        ..
    } in EQUIVALENT
    {
        let _ = writeln!(table, "| `{exercise}` | {name} | {why} |");
    }
    assert_eq!(measured("equivalent", &table), table, "{STALE}");
}
