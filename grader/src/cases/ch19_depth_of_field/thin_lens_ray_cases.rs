//! `thin_lens_ray`: its cases and its picture.

use crate::{sample};
use raybook::image::rgb::Rgb;
use raybook::math::{basis::Basis, dir3::Dir3, interval::Interval, pcg, pcg::Pcg, ray::Ray};
use raybook::sample::disk::concentric_disk;
use raybook::shape::{Shape, sphere::Sphere};
use raybook_workbook::exercises::ch01_rays::CameraRayAnswer;
use raybook_workbook::exercises::ch19_depth_of_field::ThinLensRay;
use glam::{Vec2, Vec3, vec2, vec3};
use rand::RngExt;

/// A lens of 50 mm before a film of the 35 mm format, whose up is anything square to its view.
fn question(lens_middle: Vec3, forward: Dir3) -> ThinLensRay {
    let Basis {
        x: right, y: up, ..
    } = Basis::around(-forward);
    ThinLensRay {
        lens_middle,
        forward,
        right,
        up,
        focal_length: 0.05,
        f_number: 2.0,
        focus: 2.0,
        plane: vec2(0.036, 0.024),
        film: Vec2::splat(0.5),
        on_lens: Vec2::ZERO,
    }
}

pub(super) fn random(rng: &mut Pcg) -> ThinLensRay {
    let focal_length = sample::number(rng, 0.02, 0.1);
    let unit = |rng: &mut Pcg| vec2(rng.random(), rng.random());
    ThinLensRay {
        focal_length,
        f_number: sample::number(rng, 1.0, 2.8),
        focus: focal_length * sample::number(rng, 4.0, 25.0),
        film: unit(rng),
        on_lens: concentric_disk(unit(rng)),
        ..question(sample::point(rng, 1.0), sample::direction(rng))
    }
}

/// Each pixel has a point of the lens of its own.
pub(super) fn pixel(x: u32, y: u32) -> ThinLensRay {
    let mut rng = pcg::stream(19, u64::from(96 * y + x));
    ThinLensRay {
        f_number: 1.25,
        film: (vec2(x as f32, y as f32) + 0.5) / vec2(96.0, 54.0),
        on_lens: concentric_disk(vec2(rng.random(), rng.random())),
        plane: vec2(0.0427, 0.024),
        right: Dir3::X,
        up: Dir3::Y,
        ..question(Vec3::ZERO, -Dir3::Z)
    }
}

/// A ball near the lens, one in focus and one far away, before a bright wall.
pub(super) fn colour(_: &ThinLensRay, ray: &CameraRayAnswer) -> Rgb {
    let balls = [
        (vec3(-0.19, -0.05, -0.8), 0.1, Rgb::new(0.80, 0.25, 0.05)),
        (vec3(0.0, 0.0, -2.0), 0.3, Rgb::new(0.02, 0.28, 0.42)),
        (vec3(2.5, 0.6, -9.0), 1.1, Rgb::new(0.10, 0.42, 0.25)),
    ];
    let Some(direction) = Dir3::new(ray.direction) else {
        return Rgb::BLACK;
    };
    let ray = Ray::new(ray.origin, direction);
    let seen = |(center, radius, _): &(Vec3, f32, Rgb)| {
        let ball = Sphere::new(*center, *radius);
        ball.hit(&ray, Interval::AHEAD).is_some()
    };
    let ball = balls.iter().find(|ball| seen(ball));
    ball.map_or(Rgb::new(0.85, 0.80, 0.70), |(.., colour)| *colour)
}
