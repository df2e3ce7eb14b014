//! Chapter 20: the panorama.

use crate::alternatives::student::{Alternative, Answer, Question};
use glam::{DQuat, DVec2, DVec3, Vec3};
use std::f64::consts::PI;

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "panorama_ray",
        method: "by longitude and latitude, in f64",
        answer: |q| {
            let camera = Camera::read(q);
            let (longitude, latitude) = camera.angles();
            let level = longitude.cos() * camera.forward + longitude.sin() * camera.right;
            camera.ray(latitude.cos() * level + latitude.sin() * camera.up)
        },
    },
    Alternative {
        exercise: "panorama_ray",
        method: "turns forward around up, then raises it, by two rotations",
        answer: |q| {
            let camera = Camera::read(q);
            let (longitude, latitude) = camera.angles();
            let around = DQuat::from_axis_angle(camera.up, -longitude);
            let raise = DQuat::from_axis_angle(camera.right, latitude);
            camera.ray(around * (raise * camera.forward))
        },
    },
    Alternative {
        exercise: "panorama_ray",
        method: "from the left edge, with backward and left as axes, in f32",
        answer: |q| {
            let camera = Camera::read(q);
            let axes = [-camera.forward, -camera.right, camera.up].map(DVec3::as_vec3);
            let phi = std::f32::consts::TAU * camera.film.x as f32;
            let theta = std::f32::consts::PI * camera.film.y as f32;
            let d: Vec3 =
                theta.cos() * axes[2] + theta.sin() * (phi.cos() * axes[0] + phi.sin() * axes[1]);
            camera.ray(d.normalize().as_dvec3())
        },
    },
    Alternative {
        exercise: "panorama_ray",
        method: "by the sines and cosines of half of the angles, without another",
        answer: |q| {
            let camera = Camera::read(q);
            // By 1 − 2 sin² and 2 sin cos: first around, then down.
            let double = |half: f64| {
                let (sin, cos) = half.sin_cos();
                (2.0 * sin * cos, 1.0 - 2.0 * sin * sin)
            };
            let (sin_phi, cos_phi) = double(PI * (camera.film.x - 0.5));
            let (sin_theta, cos_theta) = double(0.5 * PI * camera.film.y);
            let d = DVec3::new(sin_theta * sin_phi, cos_theta, sin_theta * cos_phi);
            camera.ray(d.x * camera.right + d.y * camera.up + d.z * camera.forward)
        },
    },
];

/// A camera and a place on its film.
struct Camera {
    eye: DVec3,
    forward: DVec3,
    right: DVec3,
    up: DVec3,
    film: DVec2,
}

impl Camera {
    fn read(q: &mut Question) -> Self {
        let [eye, forward, right, up] = [(); 4].map(|()| q.vector());
        Self {
            eye,
            forward,
            right,
            up,
            film: q.pair(),
        }
    }

    /// To the right of forward, and above the horizon.
    fn angles(&self) -> (f64, f64) {
        (2.0 * PI * self.film.x - PI, PI / 2.0 - PI * self.film.y)
    }

    fn ray(&self, direction: DVec3) -> Answer {
        Some([self.eye.to_array(), direction.to_array()].concat())
    }
}
