//! Chapter 2: exposure, Reinhard's tone mapping, and the code values of sRGB.

use super::Explained;
use super::ch12_phong::{colour, parts};
use super::way::Way;
use glam::dvec3;
use raybook::image::rgb::Rgb;
use raybook_workbook::exercises::ch02_hdr::{EncodeSrgb, Expose, ToneMap};
use std::f64::consts::LN_2;

/// The same by the exponential function: 2^stops is e^(stops · ln 2).
fn by_logarithm(asked: &Expose, way: &mut Way) -> Rgb {
    let stops = way.part("stops", f64::from(asked.stops));
    let log = way.part("ln 2", LN_2);
    let power = way.part("stops · ln 2", stops * log);
    let factor = way.part("e^(stops · ln 2)", power.exp());
    let radiance = way.part("radiance", parts(asked.radiance));
    colour(way.part("radiance · 2^stops", radiance * factor))
}

impl Explained for Expose {
    fn work(&self, way: &mut Way) -> Rgb {
        let stops = way.part("stops", f64::from(self.stops));
        let base = way.part("the base 2", 2.0_f64);
        let factor = way.power("2^stops", base, stops);
        let factor = way.number("2^stops", "", factor);
        let radiance = way.part("radiance", parts(self.radiance));
        let exposed = way.vector("radiance · 2^stops", "W·m⁻²·sr⁻¹", radiance * factor);
        colour(exposed)
    }

    const WAYS: &'static [fn(&Self, &mut Way) -> Rgb] = &[Self::work, by_logarithm];
}

impl Explained for ToneMap {
    fn work(&self, way: &mut Way) -> Rgb {
        let radiance = parts(self.radiance);
        let seen = way.colour_part("radiance in L", radiance);
        let weights = way.colour_part("the weights of R, G and B", dvec3(0.2126, 0.7152, 0.0722));
        let luminance = way.number("L = 0.2126 R + 0.7152 G + 0.0722 B", "", seen.dot(weights));
        let one = way.part("the 1 in 1 + L", 1.0);
        let factor = way.number("every channel is divided by 1 + L =", "", one + luminance);
        let radiance = way.part("radiance", radiance);
        colour(way.vector("radiance/(1 + L)", "", radiance / factor))
    }
}

/// The code value of a linear value from 0 to 1.
fn curve(way: &mut Way, v: f64) -> f64 {
    /// Where the curve's straight beginning ends.
    const STRAIGHT: f32 = 0.003_130_8;
    let end = way.part(
        "0.0031308, where the straight part ends",
        f64::from(STRAIGHT),
    );
    if way.is_at_most("v is in the straight part of the curve", v, end) {
        way.remark("v is at most 0.0031308: the curve is straight.");
        way.number("12.92 v", "", 12.92 * v)
    } else {
        let power = way.part("the exponent 1/2.4", 1.0 / 2.4);
        let root = way.power("v^(1/2.4)", v, power);
        let root = way.number("v^(1/2.4)", "", root);
        let factor = way.part("the factor 1.055", 1.055);
        let offset = way.part("the offset 0.055", 0.055);
        let product = way.part("1.055 v^(1/2.4)", factor * root);
        way.number("1.055 v^(1/2.4) − 0.055", "", product - offset)
    }
}

/// The same, with an answer of its own for what is outside of 0 to 1.
fn by_ends(asked: &EncodeSrgb, way: &mut Way) -> f32 {
    let v = way.part("v", f64::from(asked.v));
    if !way.is_less("v is above 0", 0.0, v) {
        return 0.0;
    }
    if way.is_at_most("v is 1 at least", 1.0, v) {
        return 1.0;
    }
    curve(way, v) as f32
}

impl Explained for EncodeSrgb {
    const WAYS: &'static [fn(&Self, &mut Way) -> f32] = &[Self::work, by_ends];

    fn work(&self, way: &mut Way) -> f32 {
        let v = f64::from(self.v);
        // NaN has no code value; it is shown as black.
        let is_light = way.is_less("v is above 0", 0.0, v);
        let least = if is_light { v } else { 0.0 };
        let most = if way.is_less("v is above 1", 1.0, least) {
            1.0
        } else {
            least
        };
        let v = way.number("v, clamped to [0, 1]", "", most);
        curve(way, v) as f32
    }
}
