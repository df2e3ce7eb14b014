//! Random scenes and rays for `trace`.

use crate::sample;
use raybook::image::rgb::Rgb;
use raybook::light::point::PointLight;
use raybook::material::phong::Phong;
use raybook::math::{dir3::Dir3, pcg::Pcg};
use raybook::scene::description::{Backdrop, Description, Matter, Object};
use raybook_workbook::exercises::ch25_capstone::Trace;
use glam::{Vec3, vec3};
use rand::RngExt;

/// A number with two digits after the point, as people write it.
fn round(v: f32) -> f32 {
    (100.0 * v).round() / 100.0
}

fn number(rng: &mut Pcg, min: f32, max: f32) -> f32 {
    round(sample::number(rng, min, max))
}

fn colour(rng: &mut Pcg, max: f32) -> Rgb {
    let mut channel = || number(rng, 0.1 * max, max);
    Rgb::new(channel(), channel(), channel())
}

fn matter(rng: &mut Pcg, glassy: bool) -> Matter {
    match rng.random_range(0..10) {
        0 | 1 => Matter::mirror(colour(rng, 1.0)),
        2..5 if glassy => Matter::glass(number(rng, 1.2, 1.8)),
        _ => Matter::Phong(Phong {
            ambient: colour(rng, 0.3),
            diffuse: colour(rng, 0.3),
            specular: colour(rng, 0.3),
            exponent: number(rng, 2.0, 30.0),
        }),
    }
}

/// A floor, up to four balls that do not touch, a triangle behind them; one lamp or two; a ray to a ball.
pub fn random(rng: &mut Pcg) -> Trace {
    let mut objects = vec![Object::plane(Dir3::Y, -1.2, matter(rng, false))];
    let mut places: Vec<_> = [(-1.2, -1.2), (1.2, -1.2), (-1.2, 1.2), (1.2, 1.2)].into();
    let mut target = Vec3::ZERO;
    for _ in 0..rng.random_range(1..=4) {
        let (x, z) = places.swap_remove(rng.random_range(0..places.len()));
        let center = vec3(x, 0.0, z) + sample::point(rng, 0.25);
        let center = center.map(round);
        target = center;
        objects.push(Object::sphere(
            center,
            number(rng, 0.5, 0.9),
            matter(rng, true),
        ));
    }
    let mut corner = |x, y| vec3(x, y, -3.0) + sample::point(rng, 0.8);
    let corners = [corner(-2.5, -1.0), corner(2.5, -1.0), corner(0.0, 3.0)].map(|p| p.map(round));
    objects.push(Object::triangle(corners, matter(rng, false)));
    let first = rng.random_range(0..objects.len());
    objects.rotate_left(first);
    let lamps = (0..rng.random_range(1..=2)).map(|_| PointLight {
        position: vec3(
            number(rng, -4.0, 4.0),
            number(rng, 3.0, 6.0),
            number(rng, 0.0, 5.0),
        ),
        intensity: colour(rng, 90.0),
    });
    let lamps = lamps.collect();
    let eye = vec3(
        number(rng, -2.0, 2.0),
        number(rng, 0.0, 2.5),
        number(rng, 4.5, 6.5),
    );
    Trace {
        depth: rng.random_range(2..=5),
        ray: sample::ray(eye, target + sample::point(rng, 0.6) - eye),
        scene: Description {
            ambient: colour(rng, 0.6),
            backdrop: Backdrop {
                below: colour(rng, 1.0),
                above: colour(rng, 1.0),
            },
            lamps,
            objects,
        },
    }
}
