//! An evening by the sea: the radiance of sky, sun and water, for every direction.

use glam::{Vec2, Vec3, vec2, vec3};
use raybook::image::rgb::Rgb;
use raybook::math::dir3::Dir3;
use raybook::scene::noise::{layers, noise, rise};
use std::f32::consts::PI;

/// The sun's radius, in radians: four times the true one, so that its rim can be seen in a picture of a room.
pub const SUN_RADIUS: f32 = 4.0 * 0.004_65;

/// The radiance in the middle of the sun; 1 is white paper in the shade.
pub const SUN: Rgb = Rgb::new(100_000.0, 58_000.0, 24_000.0);

/// u of the sun's limb darkening: the rim is darker than the middle by this fraction, which is largest in blue.
const DARKENING: Rgb = Rgb::new(0.45, 0.60, 0.75);

/// Height of the eye above the water, in metres.
const EYE: f32 = 14.0;

/// Where the sun stands.
pub fn toward_sun() -> Dir3 {
    Dir3::new_or(vec3(-0.42, 0.135, -1.0), Dir3::Z)
}

/// The sun's irradiance on what faces it: L·π·sin²α·(1 − u/3) for a disc of radius α, where 1 − u/3 is the disc's mean.
pub fn sunlight() -> Rgb {
    SUN * DARKENING.map(|u| 1.0 - u / 3.0) * (PI * SUN_RADIUS.sin().powi(2))
}

/// The radiance from a direction.
pub fn radiance(d: Dir3) -> Rgb {
    if d.y <= 0.0 {
        return sea(d);
    }
    let behind = sky(d) + sun(d);
    // A headland to the right of the sun, pale with the air before it.
    let azimuth = d.x.atan2(-d.z);
    let height = 0.085 * layers(vec2(4.0 * azimuth + 3.0, 0.5), 5) * rise(-0.22, 0.16, azimuth);
    let haze = sky(Dir3::new_or(d.with_y(0.02), d)) * 0.45;
    haze.lerp(behind, rise(-0.001, 0.001, d.y - height + 0.012))
}

/// The sun's disc, darker and redder towards its rim: 1 − u·(1 − μ), where μ is the cosine at which its surface is seen.
fn sun(d: Dir3) -> Rgb {
    let off = d.distance(*toward_sun()) / SUN_RADIUS;
    if off >= 1.0 {
        return Rgb::BLACK;
    }
    let mu = (1.0 - off * off).sqrt();
    SUN * DARKENING.map(|u| 1.0 - u * (1.0 - mu))
}

/// Blue above, golden at the horizon, brighter towards the sun, with bands of cloud that are lit from below.
fn sky(d: Dir3) -> Rgb {
    let from_sun = d.distance(*toward_sun());
    let low = (-d.y / 0.13).exp();
    let near = (-from_sun / 0.55).exp();
    let air = Rgb::new(0.9, 2.1, 4.6).lerp(Rgb::new(7.5, 5.2, 3.9), low)
        + Rgb::new(13.0, 5.2, 1.3) * (near * (0.25 + 0.75 * low))
        + Rgb::new(120.0, 70.0, 26.0) * (-from_sun / 0.045).exp();
    let above = vec2(d.x, d.z) / (d.y + 0.16);
    let cloud = rise(
        0.47,
        0.78,
        layers(above * vec2(0.9, 2.6) + vec2(1.7, 4.2), 6),
    );
    let lit = Rgb::new(1.9, 1.5, 2.3).lerp(Rgb::new(26.0, 11.0, 5.0), (-from_sun / 0.33).exp());
    air.lerp(lit, 0.85 * cloud * rise(0.0, 0.06, d.y))
}

/// The water mirrors the sky in its waves, shows a little of its own colour, and glitters under the sun.
///
/// The facets that mirror the sun into the eye have the slopes of the half vector h. Slopes are normally distributed with
/// ⟨|slope|²⟩ = σ²; p is the probability density of these slopes, and the glitter is F·E·p/(4 cos θ · h_y⁴)
/// (Cox and Munk, "Measurement of the roughness of the sea surface", 1954).
fn sea(d: Dir3) -> Rgb {
    /// σ² of the waves that are drawn one by one near the eye, and of the ripples that never are.
    const WAVES: f32 = 0.034;
    const RIPPLES: f32 = 0.006;
    /// How much of a facet the waves before it leave in view, when eye and sun are both low.
    const IN_VIEW: f32 = 0.25;
    let steep = (-d.y).max(0.004);
    let place = vec2(d.x, d.z) * (EYE / steep);
    // Far away a pixel holds many waves: their slopes pass over into the distribution.
    let drawn = rise(0.008, 0.1, steep);
    let slope = drawn * (0.5 * WAVES).sqrt() * waves(place);
    let spread = RIPPLES + (1.0 - drawn * drawn) * WAVES;
    let normal = vec3(-slope.x, 1.0, -slope.y).normalize();
    let mirrored = *d - 2.0 * d.dot(normal) * normal;
    let fresnel = 0.02 + 0.98 * (1.0 - steep).powi(5);
    let sky = sky(Dir3::new_or(
        mirrored.with_y(mirrored.y.abs().max(0.03)),
        Dir3::Y,
    ));
    let own = Rgb::new(0.10, 0.42, 0.55);
    let h = (*toward_sun() - *d).normalize_or(Vec3::Y);
    let off = vec2(-h.x, -h.z) / h.y - slope;
    let p = (-off.length_squared() / spread).exp() / (PI * spread);
    let glitter = sunlight() * (IN_VIEW * fresnel * p / (4.0 * steep.max(0.05) * h.y.powi(4)));
    own.lerp(sky, fresnel) + glitter
}

/// The two slopes of the waves at a place; the mean of their variances is 1.
fn waves(place: Vec2) -> Vec2 {
    /// Measured over a square kilometre: the inverse of the standard deviation of the slopes of `height`.
    const SCALE: f32 = 6.3;
    /// Distance between the two heights whose difference gives a slope, in metres.
    const STEP: f32 = 0.25;
    let height = |p: Vec2| layers(p * vec2(0.10, 0.22), 4) + 0.3 * noise(p * vec2(0.9, 1.6));
    let rises = vec2(
        height(place + STEP * Vec2::X),
        height(place + STEP * Vec2::Y),
    ) - height(place);
    rises * (SCALE / STEP)
}
