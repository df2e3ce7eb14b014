//! A mountain range in the evening: what a tree of a million triangles looks like, with shadows.

use crate::shared::{outdoors::haze, outdoors::sky};
use glam::{Vec2, Vec3, vec3};
use raybook::accel::Accel;
use raybook::camera::pinhole::Pinhole;
use raybook::image::{Image, rgb::Rgb};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::render::film::Film;
use raybook::shape::{Surface, mesh::Facet, mesh::Mesh};

/// A metre of the model is so many metres of mountains, as far as the air is concerned.
const METRES: f32 = 1.8;

/// The camera's ray through a place on the film.
pub fn ray(film: Vec2, aspect: f32) -> Ray {
    let eye = vec3(-3.9, 2.0, 4.3);
    let camera = Pinhole::look_at(eye, vec3(0.3, 0.62, -0.7), Vec3::Y, 0.044, aspect)
        .unwrap_or_else(|error| unreachable!("the direction is fixed: {error}"));
    camera.ray_through(film)
}

/// The picture: sun, sky light, and air; a shadow ray from each point that faces the sun.
pub fn picture(film: &Film, mesh: &Mesh, tree: &impl Accel<Facet>) -> Image {
    let sun = Dir3::new_or(vec3(0.80, 0.42, 0.10), Dir3::Y);
    film.render(|place, _| {
        let ray = ray(place, film.aspect());
        let Some((_, hit)) = tree.closest(&ray, Interval::AHEAD) else {
            return sky(ray.direction);
        };
        let at = mesh.surface(&ray, &hit);
        let toward = at.shading_normal.dot(*sun).max(0.0);
        let lit = toward > 0.0 && !tree.any(&at.leave(sun), Interval::AHEAD);
        let sunlight = Rgb::new(2.3, 1.75, 1.15) * if lit { toward } else { 0.0 };
        let skylight = Rgb::new(0.20, 0.29, 0.44) * (0.5 + 0.5 * at.shading_normal.y);
        haze(ground(&at) * (sunlight + skylight), METRES * hit.t)
    })
}

/// Grass in the valleys, rock where it is steep, snow on top.
fn ground(at: &Surface) -> Rgb {
    let smooth = |from: f32, to: f32, x: f32| {
        let x = ((x - from) / (to - from)).clamp(0.0, 1.0);
        x * x * (3.0 - 2.0 * x)
    };
    let (height, level) = (at.position.y, at.shading_normal.y);
    let rock = Rgb::new(0.36, 0.31, 0.27);
    let grass = Rgb::new(0.20, 0.30, 0.09);
    let snow = Rgb::new(0.92, 0.94, 0.98);
    let low = rock.lerp(grass, smooth(0.62, 0.8, level) * smooth(0.9, 0.35, height));
    low.lerp(snow, smooth(0.62, 0.95, height + 0.35 * (level - 0.7)))
}
