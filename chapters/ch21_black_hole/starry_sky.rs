//! A night sky: stars, and the Milky Way.

use glam::{Vec3, vec2, vec3};
use raybook::image::rgb::Rgb;
use raybook::light::black_body::black_body;
use raybook::math::dir3::Dir3;
use raybook::scene::noise;

/// The night sky in a direction.
pub fn starry_sky(d: Dir3) -> Rgb {
    let bright = stars(d, 26.0, 0.10, 6.0);
    let faint = stars(d, 70.0, 0.14, 1.2);
    bright + faint + milky_way(d)
}

/// Stars in cubic cells: `cells` cells lie along the radius of the sphere of all directions, and `radius` is the radius of a
/// star, as a share of the width of a cell.
///
/// A star is a ball at a random place in its cell. A star is seen where the sphere of directions cuts the ball, so most stars are
/// not seen at all, and few are seen whole.
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
    const POLE: Vec3 = Vec3::new(0.48, 0.80, 0.36);
    const CENTRE: Vec3 = Vec3::new(-0.6, 0.53, -0.6);
    let height = d.dot(POLE);
    let place = vec2(d.x + 0.7 * d.y, d.z - 0.4 * d.y);
    let wisps = noise::rise(0.25, 0.8, noise::layers(7.0 * place + 30.0, 6));
    let band = (-(height / 0.16).powi(2)).exp();
    let towards_centre = noise::rise(-0.6, 1.0, d.dot(CENTRE));
    let dust = noise::rise(0.40, 0.60, noise::layers(6.0 * place + 80.0, 6))
        * (-(height / 0.09).powi(2)).exp();
    let light = band * (0.15 + wisps) * (0.3 + towards_centre) * (1.0 - 0.85 * dust);
    let warm = Rgb::new(0.13, 0.10, 0.085).lerp(Rgb::new(0.07, 0.085, 0.13), band);
    warm * light + Rgb::new(0.003, 0.004, 0.009)
}
