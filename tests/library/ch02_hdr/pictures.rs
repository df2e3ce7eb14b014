//! Pictures to compare.

use glam::{Vec3, vec3};
use raybook::camera::{Camera, pinhole::Pinhole};
use raybook::image::{Image, rgb::Rgb};
use raybook::math::interval::Interval;
use raybook::render::film::Film;
use raybook::shape::{Shape, sphere::Sphere};

/// A real picture: a shaded sphere before a sky that changes slowly.
pub(super) fn rendered() -> Image {
    let film = Film {
        seed: 1,
        threads: 1,
        ..Film::new(96, 54, 4)
    };
    let camera = Pinhole::look_at(
        vec3(0.5, 0.8, 4.0),
        Vec3::ZERO,
        Vec3::Y,
        0.035,
        film.aspect(),
    )
    .expect("it can");
    let sphere = Sphere::new(Vec3::ZERO, 1.0);
    film.sample(|place, _| {
        let ray = camera.central_ray(place);
        sphere.hit(&ray, Interval::AHEAD).map_or_else(
            || {
                Rgb::new(0.25, 0.32, 0.45)
                    .lerp(Rgb::new(0.6, 0.62, 0.65), 0.5 + 0.5 * ray.direction.y)
            },
            |hit| {
                let n = sphere.surface(&ray, &hit).normal;
                Rgb::new(0.9, 0.5, 0.2) * (0.08 + n.dot(vec3(0.6, 0.7, 0.4)).max(0.0))
            },
        )
    })
}

/// The picture with one pixel replaced.
pub(super) fn with_pixel(picture: &Image, x: usize, y: usize, colour: Rgb) -> Image {
    let mut changed = picture.clone();
    changed.set(x, y, colour);
    changed
}
