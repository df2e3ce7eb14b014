//! A flat disc of hot gas that circles a black hole.
//!
//! ```
//! use raybook::scene::accretion_disc::AccretionDisc;
//!
//! let disc = AccretionDisc::new(12.0, 6000.0);
//! assert!(!disc.holds(2.9) && disc.holds(3.1)); // no orbit below 3 radii is stable
//! // The hottest place is a little farther out than the inner edge, at 3 · 49/36 = 4.1 radii.
//! assert!(disc.temperature(4.1) > disc.temperature(3.5) && disc.temperature(4.1) > disc.temperature(5.0));
//! ```

use crate::image::rgb::Rgb;
use crate::light::black_body::black_body;
use crate::scene::noise;
use glam::{Vec2, Vec3, vec2};

/// A disc of gas in the plane y = 0 that rotates about +y; lengths are in radii of the hole.
#[derive(Clone, Debug)]
pub struct AccretionDisc {
    inner: f64,
    outer: f64,
    hottest: f32,
    /// Colours of black bodies, every [`SPACING`] from 0 K.
    colours: Vec<Rgb>,
}

/// Step between two entries of the table of colours, in kelvin.
const SPACING: f32 = 50.0;

/// Maximum factor by which a blueshift makes the gas look hotter.
const BLUEST: f32 = 3.0;

impl AccretionDisc {
    /// A disc from the last stable orbit, at 3 radii, to the radius `outer`; `hottest` is the highest temperature, in kelvin.
    pub fn new(outer: f64, hottest: f32) -> Self {
        let count = (BLUEST * hottest / SPACING) as u32 + 2;
        Self {
            inner: 3.0,
            outer,
            hottest,
            colours: (0..count)
                .map(|i| black_body((SPACING * i as f32).max(500.0)))
                .collect(),
        }
    }

    /// Whether there is gas at a radius.
    pub fn holds(&self, r: f64) -> bool {
        (self.inner..self.outer).contains(&r)
    }

    /// The temperature of the gas in kelvin: T ∝ (x³(1 − √x))^¼ with x = inner/r (Shakura and Sunyaev 1973), which is largest
    /// at x = 36/49.
    pub fn temperature(&self, r: f32) -> f32 {
        let profile = |x: f32| (x * x * x * (1.0 - x.sqrt()).max(0.0)).powf(0.25);
        self.hottest * profile(self.inner as f32 / r) / profile(36.0 / 49.0)
    }

    /// The radiance and the opacity of the gas at a place, with all frequencies multiplied by g = `shift`.
    ///
    /// A black body of the temperature T whose frequencies are all multiplied by g has the colour and the radiance of a black
    /// body of the temperature g·T. So gas that moves towards the eye is bluer, and brighter by about g⁴.
    pub fn glow(&self, at: Vec3, shift: f32) -> (Rgb, f32) {
        let (r, p) = (at.length(), vec2(at.x, at.z));
        let strand = strands(p);
        let (inner, outer) = (self.inner as f32, self.outer as f32);
        let fade = noise::rise(inner, inner + 0.4, r) * noise::rise(outer, 0.6 * outer, r);
        let opacity = fade * (0.35 + 0.65 * strand);
        let kelvin = shift * self.temperature(r);
        (self.colour(kelvin) * (0.3 + 1.4 * strand), opacity)
    }

    fn colour(&self, kelvin: f32) -> Rgb {
        let place = (kelvin / SPACING).clamp(0.0, (self.colours.len() - 2) as f32);
        let i = place as usize;
        self.colours[i].lerp(self.colours[i + 1], place - i as f32)
    }
}

/// A pattern of clouds that are drawn out to strands, because the inner gas circles faster; from 0 to 1.
fn strands(p: Vec2) -> f32 {
    let turned = Vec2::from_angle(40.0 / p.length()).rotate(p);
    noise::rise(0.25, 0.75, noise::layers(1.5 * turned + 60.0, 5))
}
