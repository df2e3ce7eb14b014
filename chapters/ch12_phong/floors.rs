//! Small scenes that try a light: a floor, and what stands on it.

use super::bench::{CLAY, glossy, matte};
use glam::{Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::light::{Light, directional::DirectionalLight, point::PointLight};
use raybook::material::{Material, phong::Phong, texture::Texture};
use raybook::math::{dir3::Dir3, ray::Ray};
use raybook::scene::world::{Scene, Thing};
use raybook::shape::{Surface, plane::Plane, sphere::Sphere};
use std::f32::consts::PI;

/// The light of a lamp, before its strength.
const WARM: Rgb = Rgb::new(1.0, 0.93, 0.8);

/// A lamp between balls on tiles, `height` metres above the tiles.
pub(super) fn under_lamp(height: f32) -> Scene {
    let position = vec3(0.0, height, 0.3);
    let lamp = PointLight {
        position,
        intensity: WARM * 6.0,
    };
    on_tiles(Box::new(lamp), vec![bulb(position, WARM)])
}

/// The same in the sun.
pub(super) fn under_sun() -> Scene {
    let sun = DirectionalLight {
        toward: Dir3::new_or(vec3(-0.5, 1.0, 0.6), Dir3::Y),
        irradiance: WARM * PI,
    };
    on_tiles(Box::new(sun), Vec::new())
}

/// Balls on tiles under a light, and further things.
fn on_tiles(light: Box<dyn Light>, mut things: Vec<Thing>) -> Scene {
    things.push(floor(Tiles));
    for (x, z) in [(-1.9, 0.0), (1.2, -1.6), (1.5, 1.4)] {
        let ball = Sphere::new(vec3(x, 0.5, z), 0.5);
        things.push(Thing::new(ball, glossy(CLAY, 64.0)));
    }
    Scene::new(things, vec![light]).surrounded_by(Rgb::gray(0.05), dusk)
}

/// A dark, shining floor before three low lamps, of the material that `model` makes of these numbers.
pub(super) fn wet<M: Material + 'static>(exponent: f32, model: impl FnOnce(Phong) -> M) -> Scene {
    let asphalt = Phong {
        specular: Rgb::gray(1.6),
        ..glossy(Rgb::new(0.16, 0.18, 0.21), exponent)
    };
    let lamps = [
        (-3.2, Rgb::new(1.0, 0.55, 0.15)),
        (0.0, Rgb::new(1.0, 0.95, 0.85)),
        (3.2, Rgb::new(0.25, 0.60, 1.0)),
    ];
    let lamps = lamps.map(|(x, colour)| (vec3(x, 0.9, -4.5), colour));
    let lights = lamps.map(|(position, colour)| -> Box<dyn Light> {
        let intensity = colour * 12.0;
        Box::new(PointLight {
            position,
            intensity,
        })
    });
    let mut things = vec![floor(model(asphalt))];
    things.extend(lamps.map(|(position, colour)| bulb(position, colour)));
    Scene::new(things, lights.into()).surrounded_by(Rgb::gray(0.12), dusk)
}

/// Minimum of the width of a tile's edge, in tiles, where a sample covers next to nothing.
const SHARPEST: f32 = 1e-3;

/// The width of a pixel, in widths of one of its 16 samples.
const PIXEL: f32 = 4.0;

/// Number of tiles that a pixel covers, from where on the tiles have melted into one colour: they are finer than pixels can show, and
/// would make a false pattern.
const MELTED: f32 = 1.5;

/// Light and dark tiles. Their colour is the mean over the width that a sample covers, and far tiles melt into one colour.
struct Tiles;

impl Texture for Tiles {
    type Material = Phong;

    fn at(&self, surface: &Surface) -> Phong {
        let wave = |x| square_wave(x, surface.texture_width.max(SHARPEST));
        let contrast = (MELTED - PIXEL * surface.texture_width).clamp(0.0, 1.0);
        let light = contrast * wave(surface.texture.x) * wave(surface.texture.y);
        matte(Rgb::gray(0.75).lerp(Rgb::new(0.10, 0.32, 0.42), 0.5 - 0.5 * light))
    }
}

/// The mean, over a width around x, of the wave that is 1 from 0 to 1, −1 from 1 to 2, and so on.
fn square_wave(x: f32, width: f32) -> f32 {
    let integral = |x: f32| 1.0 - (2.0 * (0.5 * x).rem_euclid(1.0) - 1.0).abs();
    (integral(x + 0.5 * width) - integral(x - 0.5 * width)) / width
}

fn floor(material: impl Material + 'static) -> Thing {
    Thing::new(Plane::through(Vec3::ZERO, Dir3::Y), material)
}

/// A ball around a point light, which has no extent and cannot be seen. The ball sends out ambient light alone.
fn bulb(position: Vec3, colour: Rgb) -> Thing {
    let material = Phong {
        ambient: colour * 20.0,
        ..matte(Rgb::BLACK)
    };
    Thing::new(Sphere::new(position, 0.12), material)
}

/// A pale sky after sunset.
fn dusk(ray: &Ray) -> Rgb {
    let high = (3.0 * ray.direction.y).clamp(0.0, 1.0);
    Rgb::new(0.62, 0.55, 0.52).lerp(Rgb::new(0.20, 0.32, 0.50), high)
}
