//! Chapter 12: highlights by other formulas, and a point light.

use crate::alternatives::student::{Alternative, Answer, Question};
use glam::{DQuat, DVec3};

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "phong",
        method: "R·V = 2 (L·N)(V·N) − L·V, in f64",
        answer: |q| {
            let q = Highlight::read(q);
            q.sum(2.0 * q.l.dot(q.n) * q.v.dot(q.n) - q.l.dot(q.v))
        },
    },
    Alternative {
        exercise: "phong",
        method: "the viewer mirrored, in f32",
        answer: |q| {
            let q = Highlight::read(q);
            let [n, v, l] = [q.n, q.v, q.l].map(DVec3::as_vec3);
            let mirrored = v - 2.0 * (v - v.dot(n) * n);
            q.sum(f64::from(mirrored.dot(l)))
        },
    },
    Alternative {
        exercise: "phong",
        method: "the light turned by half a turn around the normal",
        answer: |q| {
            let q = Highlight::read(q);
            let mirrored = DQuat::from_axis_angle(q.n, std::f64::consts::PI) * q.l;
            q.sum(mirrored.dot(q.v))
        },
    },
    Alternative {
        exercise: "blinn_phong",
        method: "N·H = (N·L + N·V)/√(2 + 2 L·V), in f64",
        answer: |q| {
            let q = Highlight::read(q);
            q.sum((q.n.dot(q.l) + q.n.dot(q.v)) / (2.0 + 2.0 * q.l.dot(q.v)).sqrt())
        },
    },
    Alternative {
        exercise: "blinn_phong",
        method: "L turned by half its angle to V, in f64",
        answer: |q| {
            let q = Highlight::read(q);
            let turn = DQuat::from_rotation_arc(q.l, q.v);
            q.sum((DQuat::IDENTITY.slerp(turn, 0.5) * q.l).dot(q.n))
        },
    },
    Alternative {
        exercise: "blinn_phong",
        method: "L + V normalised, in f32",
        answer: |q| {
            let q = Highlight::read(q);
            let half = (q.l.as_vec3() + q.v.as_vec3()).normalize_or_zero();
            q.sum(f64::from(half.dot(q.n.as_vec3())))
        },
    },
    Alternative {
        exercise: "point_light",
        method: "in f64",
        answer: |q| {
            let (position, intensity, at) = (q.vector(), q.vector(), q.vector());
            let distance = position.distance(at);
            arriving(
                (position - at) / distance,
                distance,
                intensity / distance.powi(2),
            )
        },
    },
    Alternative {
        exercise: "point_light",
        method: "by azimuth and elevation, and the power through the sphere",
        answer: |q| {
            let (position, intensity, at) = (q.vector(), q.vector(), q.vector());
            let v = position - at;
            let (azimuth, elevation) = (v.x.atan2(v.z), v.y.atan2(v.x.hypot(v.z)));
            let level = DVec3::new(azimuth.sin(), 0.0, azimuth.cos());
            let toward = elevation.cos() * level + elevation.sin() * DVec3::Y;
            let distance = v.dot(toward);
            let sphere = 4.0 * std::f64::consts::PI * distance * distance;
            arriving(
                toward,
                distance,
                4.0 * std::f64::consts::PI * intensity / sphere,
            )
        },
    },
];

fn arriving(toward: DVec3, distance: f64, arriving: DVec3) -> Answer {
    let numbers = [&toward.to_array()[..], &[distance], &arriving.to_array()];
    (distance > 0.0).then(|| numbers.concat())
}

/// A point, its viewer, and a light.
struct Highlight {
    n: DVec3,
    v: DVec3,
    l: DVec3,
    arriving: DVec3,
    diffuse: DVec3,
    specular: DVec3,
    exponent: f64,
}

impl Highlight {
    fn read(q: &mut Question) -> Self {
        Self {
            n: q.vector(),
            v: q.vector(),
            l: q.vector(),
            arriving: q.vector(),
            diffuse: q.vector(),
            specular: q.vector(),
            exponent: q.number(),
        }
    }

    /// Both terms, with the cosine of the highlight; its power by logarithms.
    fn sum(&self, cosine: f64) -> Answer {
        let lambert = self.n.dot(self.l);
        if lambert <= 0.0 {
            return Some(vec![0.0; 3]);
        }
        let highlight = if cosine > 0.0 {
            (self.exponent * cosine.ln()).exp()
        } else {
            0.0
        };
        let radiance = (self.diffuse * lambert + self.specular * highlight) * self.arriving;
        Some(radiance.to_array().to_vec())
    }
}
