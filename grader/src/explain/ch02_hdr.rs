//! Chapter 2: exposure, Reinhard's tone mapping, and the code values of sRGB.

use super::Explained;
use super::ch12_phong::{colour, parts};
use super::way::Way;
use glam::dvec3;
use raybook::image::rgb::Rgb;
use raybook_workbook::exercises::ch02_hdr::{EncodeSrgb, Expose, ToneMap};

impl Explained for Expose {
    fn work(&self, way: &mut Way) -> Rgb {
        let factor = way.number("2^stops", "", f64::from(self.stops).exp2());
        colour(way.vector(
            "radiance · 2^stops",
            "W·m⁻²·sr⁻¹",
            parts(self.radiance) * factor,
        ))
    }
}

impl Explained for ToneMap {
    fn work(&self, way: &mut Way) -> Rgb {
        let radiance = parts(self.radiance);
        let luminance = way.number(
            "L = 0.2126 R + 0.7152 G + 0.0722 B",
            "",
            radiance.dot(dvec3(0.2126, 0.7152, 0.0722)),
        );
        way.number(
            "the luminance that is wanted: L/(1 + L)",
            "",
            luminance / (1.0 + luminance),
        );
        let factor = way.number("every channel is divided by 1 + L =", "", 1.0 + luminance);
        colour(way.vector("radiance/(1 + L)", "", radiance / factor))
    }
}

impl Explained for EncodeSrgb {
    fn work(&self, way: &mut Way) -> f32 {
        /// Where the curve's straight beginning ends.
        const STRAIGHT: f64 = 0.003_130_8;
        let v = f64::from(self.v);
        // NaN has no code value; it is shown as black.
        let v = way.number(
            "v, clamped to [0, 1]",
            "",
            if v > 0.0 { v.min(1.0) } else { 0.0 },
        );
        let code = if v <= STRAIGHT {
            way.remark("v is at most 0.0031308: the curve is straight.");
            way.number("12.92 v", "", 12.92 * v)
        } else {
            let root = way.number("v^(1/2.4)", "", v.powf(1.0 / 2.4));
            way.number("1.055 v^(1/2.4) − 0.055", "", 1.055 * root - 0.055)
        };
        code as f32
    }
}
