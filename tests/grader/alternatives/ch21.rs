//! Chapter 21: the black hole.

use crate::alternatives::student::{Alternative, Answer};
use glam::{DVec3, Vec3};
use std::f64::consts::PI;

/// 3√3/2.
const CRITICAL: f64 = 2.598_076_211_353_316;

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "geodesic_step",
        method: "the classical fourth-order step, in f32",
        answer: |q| {
            let (x, v, h) = (
                q.vector().as_vec3(),
                q.vector().as_vec3(),
                q.number() as f32,
            );
            let pull =
                |x: Vec3, v: Vec3| -1.5 * x.cross(v).length_squared() * x / x.length().powi(5);
            let (x1, v1) = (v, pull(x, v));
            let (x2, v2) = (v + 0.5 * h * v1, pull(x + 0.5 * h * x1, v + 0.5 * h * v1));
            let (x3, v3) = (v + 0.5 * h * v2, pull(x + 0.5 * h * x2, v + 0.5 * h * v2));
            let (x4, v4) = (v + h * v3, pull(x + h * x3, v + h * v3));
            let x = x + h / 6.0 * (x1 + 2.0 * x2 + 2.0 * x3 + x4);
            let v = v + h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
            photon(x.as_dvec3(), v.as_dvec3())
        },
    },
    Alternative {
        exercise: "geodesic_step",
        method: "velocity Verlet with a constant h²",
        answer: |q| {
            let (mut x, mut v, h) = (q.vector(), q.vector(), q.number());
            let h2 = x.cross(v).length_squared();
            let pull = |x: DVec3| -1.5 * h2 * x / x.length().powi(5);
            let half = v + 0.5 * h * pull(x);
            x += h * half;
            v = half + 0.5 * h * pull(x);
            photon(x, v)
        },
    },
    Alternative {
        exercise: "geodesic_step",
        method: "the midpoint",
        answer: |q| {
            let (x, v, h) = (q.vector(), q.vector(), q.number());
            let pull =
                |x: DVec3, v: DVec3| -1.5 * x.cross(v).length_squared() * x / x.length().powi(5);
            let (middle, velocity) = (x + 0.5 * h * v, v + 0.5 * h * pull(x, v));
            photon(x + h * velocity, v + h * pull(middle, velocity))
        },
    },
    Alternative {
        exercise: "geodesic_step",
        method: "a thousand small steps of Euler's",
        answer: |q| {
            let (mut x, mut v, h) = (q.vector(), q.vector(), q.number() / 1000.0);
            for _ in 0..1000 {
                let pull = -1.5 * x.cross(v).length_squared() * x / x.length().powi(5);
                x += h * v;
                v += h * pull;
            }
            photon(x, v)
        },
    },
    Alternative {
        exercise: "deflection_angle",
        method: "the equation of u = 1/r by the angle, from infinity until u is 0 again",
        answer: |q| {
            let b = q.number();
            let step = 1e-3;
            // u″ = (3/2)u² − u, by Verlet.
            let bend = |u: f64| 1.5 * u * u - u;
            let (mut u, mut slope, mut angle) = (0.0, 1.0 / b, 0.0);
            while u < 1.0 {
                let half = slope + 0.5 * step * bend(u);
                u += step * half;
                slope = half + 0.5 * step * bend(u);
                angle += step;
                if u < 0.0 {
                    return Some(vec![angle - u / slope - PI]);
                }
            }
            None
        },
    },
    Alternative {
        exercise: "deflection_angle",
        method: "the integral over the radius, by the midpoint rule",
        answer: |q| {
            let b = q.number();
            if b < CRITICAL {
                return None;
            }
            // The closest approach, where r³ = b²(r − 1), by halving.
            let (mut low, mut high) = (1.5, b);
            for _ in 0..100 {
                let middle = 0.5 * (low + high);
                if middle * middle * middle < b * b * (middle - 1.0) {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            let nearest = 1.0 / high;
            // u = u₀ sin θ: then the integrand is finite.
            let count = 20_000;
            let width = 0.5 * PI / f64::from(count);
            let integrand = |i: i32| {
                let (sine, cosine) = ((f64::from(i) + 0.5) * width).sin_cos();
                let u = nearest * sine;
                let below = 1.0 / (b * b) - u * u + u * u * u;
                nearest * cosine / below.max(1e-300).sqrt()
            };
            Some(vec![
                2.0 * width * (0..count).map(integrand).sum::<f64>() - PI,
            ])
        },
    },
    Alternative {
        exercise: "deflection_angle",
        method: "the ray itself, step by step from far away",
        answer: |q| {
            let b = q.number();
            let mut x = DVec3::new(-2000.0 * b, b, 0.0);
            let (mut v, mut turned) = (DVec3::X, 0.0);
            let h2 = x.cross(v).length_squared();
            let pull = |x: DVec3| -1.5 * h2 * x / x.length().powi(5);
            while x.x.abs() < 2001.0 * b && x.length() < 2002.0 * b {
                if x.length() < 1.0 {
                    return None;
                }
                let h = 1e-3 * x.length();
                let half = v + 0.5 * h * pull(x);
                x += h * half;
                let after = half + 0.5 * h * pull(x);
                turned += v.cross(after).length().atan2(v.dot(after)); // near 0 an arc cosine has no digits
                v = after;
            }
            Some(vec![turned])
        },
    },
];

fn photon(x: DVec3, v: DVec3) -> Answer {
    Some([x.to_array(), v.to_array()].concat())
}
