//! A night sky: stars, and the Milky Way.

use crate::image::rgb::Rgb;
use crate::light::black_body::black_body;
use crate::math::dir3::Dir3;
use crate::scene::noise;
use glam::{Vec3, vec2, vec3};

/// The night sky in a direction.
pub fn starry_sky(d: Dir3) -> Rgb {
    let bright = stars(d, 26.0, 0.10, 6.0);
    let faint = stars(d, 70.0, 0.14, 1.2);
    bright + faint + milky_way(d)
}

/// Stars in cubic cells, so many of which lie along the radius of the sphere of all directions, each with a share of the
/// cells' width as its radius.
///
/// A star is a ball at a random place in its cell; it is seen where the sphere cuts it, so most are not seen at all and few are
/// seen whole.
fn stars(d: Dir3, cells: f32, radius: f32, brightness: f32) -> Rgb {
    let p = cells * *d;
    let cell = p.floor();
    let random = |salt: i32| {
        let [x, y, z] = cell.to_array().map(|c| c as i32);
        noise::hash(x + 131 * salt, y + 1009 * z)
    };
    let room = 1.0 - 2.0 * radius;
    let star = cell + radius + room * vec3(random(1), random(2), random(3));
    let near = 1.0 - p.distance(star) / radius;
    if near <= 0.0 {
        return Rgb::BLACK;
    }
    // From red to blue stars; most shine faintly.
    let colour = black_body(3000.0 + 12_000.0 * random(4).powi(2));
    let strength = brightness * (0.05 + random(5).powi(6));
    colour * (strength * near * near / colour.luminance())
}

/// A band of light across the sky, with clouds of dust before it.
fn milky_way(d: Dir3) -> Rgb {
    const POLE: Vec3 = Vec3::new(0.36, 0.80, 0.48);
    const CENTRE: Vec3 = Vec3::new(0.8, -0.6, 0.4);
    let height = d.dot(POLE);
    let place = vec2(d.x + 0.7 * d.y, d.z - 0.4 * d.y);
    let clouds = noise::layers(3.0 * place + 30.0, 6);
    let band = (-(height / 0.22).powi(2)).exp();
    let towards_centre = 0.5 + 0.5 * d.dot(CENTRE.normalize());
    let dust = noise::rise(0.42, 0.62, noise::layers(4.0 * place + 80.0, 6))
        * (-(height / 0.10).powi(2)).exp();
    let light = band * (0.3 + 1.4 * clouds) * (0.3 + towards_centre) * (1.0 - 0.8 * dust);
    Rgb::new(0.085, 0.085, 0.10) * light + Rgb::new(0.004, 0.006, 0.012)
}
