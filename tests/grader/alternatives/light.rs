//! Chapters 1 and 2: rays, cameras and colours.

use crate::alternatives::student::{Alternative, Answer, Question};
use glam::{DMat3, DVec3};

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "ray_at",
        method: "in f64",
        answer: |q| {
            let (o, d, t) = (q.vector(), q.vector(), q.number());
            vector(o + t * d)
        },
    },
    Alternative {
        exercise: "ray_at",
        method: "between the points at 0 and 1",
        answer: |q| {
            let (o, d, t) = (q.vector(), q.vector(), q.number());
            vector(o * (1.0 - t) + (o + d) * t)
        },
    },
    Alternative {
        exercise: "camera_ray",
        method: "by two angles",
        answer: |q| {
            let camera = Camera::read(q);
            let across = camera.x.atan2(camera.f);
            let upwards = camera.y.atan2(camera.f.hypot(camera.x));
            let level = across.cos() * camera.forward + across.sin() * camera.right;
            camera.ray(upwards.cos() * level + upwards.sin() * camera.up)
        },
    },
    Alternative {
        exercise: "camera_ray",
        method: "by a matrix of the camera's axes",
        answer: |q| {
            let camera = Camera::read(q);
            let to_world = DMat3::from_cols(camera.right, camera.up, -camera.forward);
            camera.ray((to_world * DVec3::new(camera.x, camera.y, -camera.f)).normalize())
        },
    },
    Alternative {
        exercise: "camera_ray",
        method: "in f32, to a point of the plane in the world",
        answer: |q| {
            let camera = Camera::read(q);
            let eye = camera.eye.as_vec3();
            let middle = eye + camera.f as f32 * camera.forward.as_vec3();
            let place = middle
                + camera.x as f32 * camera.right.as_vec3()
                + camera.y as f32 * camera.up.as_vec3();
            camera.ray((place - eye).normalize().as_dvec3())
        },
    },
    Alternative {
        exercise: "expose",
        method: "whole stops by powi, the rest by powf",
        answer: |q| {
            let (radiance, stops) = (q.vector().as_vec3(), q.number() as f32);
            let whole = 2.0_f32.powi(stops.floor() as i32);
            vector((radiance * whole * 2.0_f32.powf(stops - stops.floor())).as_dvec3())
        },
    },
    Alternative {
        exercise: "expose",
        method: "e to the stops times ln 2, in f64",
        answer: |q| {
            let (radiance, stops) = (q.vector(), q.number());
            vector(radiance * (stops * 2.0_f64.ln()).exp())
        },
    },
    Alternative {
        exercise: "tone_map",
        method: "the new luminance over the old, in f64",
        answer: |q| {
            let radiance = q.vector();
            let old = radiance.dot(DVec3::new(0.2126, 0.7152, 0.0722));
            let new = old / (1.0 + old);
            vector(if old > 0.0 {
                radiance * (new / old)
            } else {
                radiance
            })
        },
    },
    Alternative {
        exercise: "encode_srgb",
        method: "in f64",
        answer: |q| Some(vec![encode(q.number().clamp(0.0, 1.0))]),
    },
    Alternative {
        exercise: "encode_srgb",
        method: "by a table of 4096 steps",
        answer: |q| {
            let place = 4096.0 * q.number().clamp(0.0, 1.0);
            let (below, rest) = (place.floor(), place.fract());
            let [low, high] = [below, below + 1.0].map(|step| encode(step / 4096.0));
            Some(vec![low + rest * (high - low)])
        },
    },
];

fn vector(v: DVec3) -> Answer {
    Some(v.to_array().to_vec())
}

fn encode(v: f64) -> f64 {
    if v <= 0.003_130_8 {
        12.92 * v
    } else {
        1.055 * v.powf(1.0 / 2.4) - 0.055
    }
}

/// A pin-hole camera, and the place on its plane in metres.
struct Camera {
    eye: DVec3,
    forward: DVec3,
    right: DVec3,
    up: DVec3,
    f: f64,
    x: f64,
    y: f64,
}

impl Camera {
    fn read(q: &mut Question) -> Self {
        let [eye, forward, right, up] = [(); 4].map(|()| q.vector());
        let (f, plane, film) = (q.number(), q.pair(), q.pair());
        Self {
            eye,
            forward,
            right,
            up,
            f,
            x: plane.x * film.x - plane.x / 2.0,
            y: plane.y / 2.0 - plane.y * film.y,
        }
    }

    fn ray(&self, direction: DVec3) -> Answer {
        Some([self.eye.to_array(), direction.to_array()].concat())
    }
}
