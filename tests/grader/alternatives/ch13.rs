//! Chapter 13: mirrors.

use crate::alternatives::student::{Alternative, Answer};
use glam::{DMat3, DQuat, DVec3};

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "reflect",
        method: "by Householder's matrix, in f64",
        answer: |q| {
            let (i, n) = (q.vector(), q.vector());
            let outer = DMat3::from_cols(n.x * n, n.y * n, n.z * n);
            vector((DMat3::IDENTITY - 2.0 * outer) * i)
        },
    },
    Alternative {
        exercise: "reflect",
        method: "the reversed ray turned by half a turn around the normal",
        answer: |q| {
            let (i, n) = (q.vector(), q.vector());
            vector(DQuat::from_axis_angle(n, std::f64::consts::PI) * -i)
        },
    },
    Alternative {
        exercise: "reflect",
        method: "the normal turned to the ray's side first, in f32",
        answer: |q| {
            let (i, n) = (q.vector().as_vec3(), q.vector().as_vec3());
            let n = if i.dot(n) < 0.0 { n } else { -n };
            vector((i - 2.0 * n.dot(i) * n).normalize().as_dvec3())
        },
    },
];

fn vector(v: DVec3) -> Answer {
    Some(v.to_array().to_vec())
}
