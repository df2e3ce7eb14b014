//! Chapter 14: refraction.

use crate::alternatives::student::{Alternative, Answer, Question};
use glam::{DVec3, Vec3};

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "refract",
        method: "by the angles, in f64",
        answer: |q| {
            let Surface { i, n, n1, n2 } = Surface::read(q);
            let one = (-i.dot(n)).clamp(-1.0, 1.0).acos();
            let sine = n1 / n2 * one.sin();
            if sine > 1.0 {
                return None;
            }
            let two = sine.asin();
            let along = (i - i.dot(n) * n).normalize_or_zero();
            vector(two.sin() * along - two.cos() * n)
        },
    },
    Alternative {
        exercise: "refract",
        method: "by η and two cosines, in f32",
        answer: |q| {
            let Surface { i, n, n1, n2 } = Surface::read(q);
            let (i, n, eta) = (i.as_vec3(), n.as_vec3(), (n1 / n2) as f32);
            let cos1 = -i.dot(n);
            let k = 1.0 - eta * eta * (1.0 - cos1 * cos1);
            if k < 0.0 {
                return None;
            }
            vector((eta * i + (eta * cos1 - k.sqrt()) * n).as_dvec3())
        },
    },
    Alternative {
        exercise: "refract",
        method: "by what Snell's law leaves of n × i, in f32",
        answer: |q| {
            let Surface { i, n, n1, n2 } = Surface::read(q);
            let (i, n, eta) = (i.as_vec3(), n.as_vec3(), (n1 / n2) as f32);
            let across: Vec3 = eta * n.cross(i);
            let k = 1.0 - across.length_squared();
            if k < 0.0 {
                return None;
            }
            vector((across.cross(n) - k.sqrt() * n).as_dvec3())
        },
    },
    Alternative {
        exercise: "fresnel",
        method: "by sines and tangents of the angles, in f64",
        answer: |q| {
            let (cos1, n1, n2) = (q.number(), q.number(), q.number());
            let (one, sine) = (cos1.acos(), n1 / n2 * cos1.acos().sin());
            if n1 == n2 {
                return Some(vec![0.0; 3]);
            }
            if sine >= 1.0 {
                return Some(vec![1.0; 3]);
            }
            let two = sine.asin();
            if one < 1e-4 {
                let r = ((n1 - n2) / (n1 + n2)).powi(2);
                return Some(vec![r; 3]);
            }
            shares(
                (one - two).sin() / (one + two).sin(),
                (one - two).tan() / (one + two).tan(),
            )
        },
    },
    Alternative {
        exercise: "fresnel",
        method: "by the relative index and its g, in f32",
        answer: |q| {
            let [c, n1, n2] = [(); 3].map(|()| q.number() as f32);
            let m = n2 / n1;
            let g_squared = m * m - 1.0 + c * c;
            if g_squared < 0.0 {
                return Some(vec![1.0; 3]);
            }
            if m == 1.0 {
                return Some(vec![0.0; 3]);
            }
            let g = g_squared.sqrt();
            let s = (g - c) / (g + c);
            let p = s * (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
            shares(f64::from(s), f64::from(p))
        },
    },
];

/// A ray's direction, the normal on its side, and the indices in its order.
struct Surface {
    i: DVec3,
    n: DVec3,
    n1: f64,
    n2: f64,
}

impl Surface {
    fn read(q: &mut Question) -> Self {
        let (i, n) = (q.vector(), q.vector());
        let (outside, inside) = (q.number(), q.number());
        let enters = i.dot(n) < 0.0;
        let (n, n1, n2) = if enters {
            (n, outside, inside)
        } else {
            (-n, inside, outside)
        };
        Self { i, n, n1, n2 }
    }
}

fn vector(v: DVec3) -> Answer {
    Some(v.to_array().to_vec())
}

fn shares(s: f64, p: f64) -> Answer {
    let (s, p) = (s * s, p * p);
    Some(vec![s, p, 0.5 * (s + p)])
}
