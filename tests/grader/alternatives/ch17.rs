//! Chapter 17: the hemisphere, and Phong's BRDF.

use crate::alternatives::student::{Alternative, Answer, Question};
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_PI_4, PI, TAU};

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "cosine_hemisphere",
        method: "the numbers exchanged, counted from elsewhere, by angles",
        answer: |q| {
            images(q, |u, basis| {
                let (theta, phi) = (u.y.sqrt().asin(), 1.0 + TAU * u.x);
                let z = theta.cos();
                basis(DVec3::new(
                    theta.sin() * phi.cos(),
                    theta.sin() * phi.sin(),
                    z,
                ))
            })
        },
    },
    Alternative {
        exercise: "cosine_hemisphere",
        method: "the disc by squares (Shirley and Chiu), a left-handed basis",
        answer: |q| {
            images(q, |u, basis| {
                let p = concentric(u);
                basis(DVec3::new(
                    p.y,
                    p.x,
                    (1.0 - p.length_squared()).max(0.0).sqrt(),
                ))
            })
        },
    },
    Alternative {
        exercise: "cosine_hemisphere",
        method: "a point of the unit sphere added to the normal",
        answer: |q| {
            images(q, |u, basis| {
                let point = on_sphere(1.0 - 2.0 * u.x, TAU * u.y);
                basis((DVec3::Z + point).normalize())
            })
        },
    },
    Alternative {
        exercise: "cosine_hemisphere",
        method: "a point of the unit sphere, whose poles are the world's, added to the normal",
        answer: |q| {
            images(q, |u, basis| {
                let point = on_sphere(1.0 - 2.0 * u.y, TAU * u.x);
                (basis(DVec3::Z) + point).normalize()
            })
        },
    },
    Alternative {
        exercise: "brdf_phong",
        method: "mirrors the viewer, in f64",
        answer: |q| {
            let (n, v, l) = (q.vector(), q.vector(), q.vector());
            let mirrored = 2.0 * n.dot(v) * n - v;
            phong(q, n.dot(l), n.dot(v), mirrored.dot(l))
        },
    },
    Alternative {
        exercise: "brdf_phong",
        method: "by the half vector: R·V is the cosine of a reflection at it",
        answer: |q| {
            let (n, v, l) = (q.vector(), q.vector(), q.vector());
            // 2 (N·L)(N·V) − L·V, with L·V = 2 (H·V)² − 1.
            let h = (l + v).normalize_or_zero();
            let along = 2.0 * h.dot(v).powi(2) - 1.0;
            phong(q, n.dot(l), n.dot(v), 2.0 * n.dot(l) * n.dot(v) - along)
        },
    },
];

/// The point of the unit sphere at this z and this angle around z.
fn on_sphere(z: f64, phi: f64) -> DVec3 {
    let r = (1.0 - z * z).sqrt();
    DVec3::new(r * phi.cos(), r * phi.sin(), z)
}

/// The images of the question's lattice, by a warp that is given a point and what takes the z axis to the normal.
fn images(q: &mut Question, warp: fn(DVec2, &dyn Fn(DVec3) -> DVec3) -> DVec3) -> Answer {
    let (normal, n) = (q.vector(), q.whole());
    let basis = frame(normal);
    let mut answer = vec![n as f64];
    for i in 0..n {
        let i = i as f64 + 0.5;
        let u = DVec2::new(i / n as f64, (0.618_034 * i).fract());
        answer.extend(warp(u, &basis).to_array());
    }
    Some(answer)
}

/// What takes the z axis to a normal.
pub fn frame(normal: DVec3) -> impl Fn(DVec3) -> DVec3 {
    let (x, y) = normal.normalize().any_orthonormal_pair();
    move |v| v.x * x + v.y * y + v.z * normal.normalize()
}

/// Squares around the middle become circles (Shirley and Chiu 1997).
pub fn concentric(u: DVec2) -> DVec2 {
    let p = 2.0 * u - 1.0;
    if p == DVec2::ZERO {
        return p;
    }
    let (r, phi) = if p.x.abs() > p.y.abs() {
        (p.x, FRAC_PI_4 * p.y / p.x)
    } else {
        (p.y, 2.0 * FRAC_PI_4 - FRAC_PI_4 * p.x / p.y)
    };
    r * DVec2::new(phi.cos(), phi.sin())
}

/// f, with the rest of the question.
fn phong(q: &mut Question, light: f64, view: f64, cos_alpha: f64) -> Answer {
    let (diffuse, specular, n) = (q.vector(), q.vector(), q.number());
    if light <= 0.0 || view <= 0.0 {
        return Some(vec![0.0; 3]);
    }
    let highlight = if cos_alpha > 0.0 {
        (n + 2.0) / TAU * cos_alpha.powf(n)
    } else {
        0.0
    };
    Some((diffuse / PI + specular * highlight).to_array().to_vec())
}
