//! Environments made of formulas: a clear day, a sunset, an overcast sky, a studio.

use glam::{Vec3, vec2, vec3};
use raybook::image::Image;
use raybook::image::rgb::Rgb;
use raybook::light::environment::latlong;
use raybook::math::dir3::Dir3;
use raybook::scene::noise;

/// Angular radius of the sun, in radians: 0.2665°.
pub const SUN: f32 = 0.2665 * std::f32::consts::PI / 180.0;

/// Radiance by direction.
pub type Sky = fn(Dir3) -> Rgb;

/// The skies of this file.
pub const FOUR: [Sky; 4] = [clear_day, sunset, overcast, studio];

/// A latitude–longitude map of a sky, twice as wide as it is high; each texel is the mean of 2 × 2 points. Around the sun, a
/// texel is the mean of more points, with steps that are small beside the sun, so that the map holds as much light as the
/// formula.
pub fn map(sky: Sky, width: usize) -> Image {
    let height = (width / 2).max(1);
    let texel_height = std::f32::consts::PI / height as f32;
    let fine = (12.0 * texel_height / SUN).clamp(2.0, 256.0) as usize;
    let texel = |x: usize, y: usize, points: usize| {
        let places = (0..points).flat_map(|j| (0..points).map(move |i| vec2(i as f32, j as f32)));
        let sum: Rgb = places
            .map(|p| {
                let place = vec2(x as f32, y as f32) + (p + 0.5) / points as f32;
                sky(latlong::direction(
                    place / vec2(width as f32, height as f32),
                ))
            })
            .sum();
        sum / (points * points) as f32
    };
    Image::from_fn(width, height, |x, y| {
        let middle = (vec2(x as f32, y as f32) + 0.5) / vec2(width as f32, height as f32);
        let to_sun = latlong::direction(middle).dot(*sun_of_day()).acos();
        let near = to_sun < SUN + 1.5 * texel_height;
        texel(x, y, if near { fine } else { 2 })
    })
}

/// Towards the sun of [`clear_day`].
pub fn sun_of_day() -> Dir3 {
    Dir3::new_or(vec3(-0.6, 0.75, -0.35), Dir3::Y)
}

/// A blue sky with a sun of the true size; more than half of the light on level ground comes from the sun, which fills 1/185 000
/// of all directions.
pub fn clear_day(d: Dir3) -> Rgb {
    let to_sun = d.dot(*sun_of_day());
    if to_sun > SUN.cos() {
        return Rgb::new(43_000.0, 38_000.0, 30_000.0);
    }
    let up = d.y.max(0.0);
    let blue = Rgb::new(0.64, 0.69, 0.75).lerp(Rgb::new(0.08, 0.20, 0.50), up.powf(0.45));
    let glow = Rgb::new(1.0, 0.93, 0.8) * (0.4 * to_sun.max(0.0).powf(60.0));
    let clouds = clouds_above(0.02, 0.25, d);
    ground(
        d,
        (blue + glow).lerp(Rgb::gray(0.9), clouds),
        Rgb::new(0.26, 0.24, 0.20),
    )
}

/// A red sun on the horizon, and a sky from orange to violet.
pub fn sunset(d: Dir3) -> Rgb {
    let sun = Dir3::new_or(vec3(0.8, 0.09, -0.6), Dir3::X);
    let to_sun = d.dot(*sun).max(0.0);
    let up = d.y.max(0.0).sqrt();
    let sky = Rgb::new(0.95, 0.50, 0.22).lerp(Rgb::new(0.10, 0.10, 0.28), (1.4 * up).min(1.0));
    let glow = Rgb::new(6.0, 2.6, 0.7) * (0.35 * to_sun.powf(24.0) + 5.0 * to_sun.powf(900.0));
    let away = 0.35 + 0.65 * (0.5 + 0.5 * d.dot(*sun));
    let clouds = clouds_above(0.02, 0.2, d);
    let lit = sky.lerp(Rgb::new(0.80, 0.32, 0.24), 0.7 * clouds);
    ground(d, (lit * away + glow) * 1.8, Rgb::new(0.20, 0.14, 0.12))
}

/// Clouds everywhere, three times as bright at the zenith as at the horizon (Moon and Spencer 1942).
pub fn overcast(d: Dir3) -> Rgb {
    let grey = Rgb::new(0.94, 0.97, 1.0) * (0.55 * (1.0 + 2.0 * d.y.max(0.0)));
    let clouds = clouds_above(-0.01, -0.005, d); // the ground hides those below
    ground(d, grey * (0.9 + 0.2 * clouds), Rgb::new(0.30, 0.31, 0.30))
}

/// A dark room with two softboxes and a strip of light.
pub fn studio(d: Dir3) -> Rgb {
    let softbox = |toward: Vec3, half: f32| {
        let toward = Dir3::new_or(toward, Dir3::Y);
        let right = Dir3::new_or(toward.cross(Vec3::Y), Dir3::X);
        let up = right.cross(*toward);
        let ahead = d.dot(*toward).max(1e-3);
        let p = vec2(d.dot(*right), d.dot(up)) / ahead;
        f32::from(d.dot(*toward) > 0.0 && p.abs().max_element() < half)
    };
    let walls = Rgb::new(0.05, 0.055, 0.065) * (1.0 + d.y);
    let warm = Rgb::new(9.0, 8.0, 6.8) * softbox(vec3(-1.0, 0.8, 0.5), 0.38);
    let cold = Rgb::new(3.2, 4.0, 5.2) * softbox(vec3(1.0, 0.5, 0.2), 0.32);
    let strip = Rgb::gray(2.5) * f32::from((d.y - 0.86).abs() < 0.03 && d.z < 0.4);
    walls + warm + cold + strip
}

/// The ground below the horizon, and the sky above it.
fn ground(d: Dir3, sky: Rgb, ground: Rgb) -> Rgb {
    sky.lerp(ground, noise::rise(0.005, -0.005, d.y))
}

/// Fraction of cloud in a direction: none below the height `none`, all of the clouds above the height `all`.
fn clouds_above(none: f32, all: f32, d: Dir3) -> f32 {
    let share = noise::rise(none, all, d.y);
    // The noise takes longer than everything else, and half of the directions do not need it.
    if share > 0.0 { cloud(d) * share } else { 0.0 }
}

/// Fraction of cloud in a direction, 0 to 1: noise on a ceiling at height 1 above the eye.
fn cloud(d: Dir3) -> f32 {
    let place = vec2(d.x, d.z) / (d.y.abs() + 0.12);
    noise::rise(0.5, 0.8, noise::layers(1.3 * place + 40.0, 5))
}
