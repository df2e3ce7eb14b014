//! Colours that colour-blind people can tell apart.

use glam::Vec3;
use plotters::style::{
    RGBColor,
    colors::colormaps::{ColorMap, ViridisRGB},
};
use raybook::image::{rgb::Rgb, tone};

/// Okabe and Ito's palette (2008), in the order in which a plot takes its colours.
pub const BLUE: RGBColor = RGBColor(0, 114, 178);
/// The second colour.
pub const ORANGE: RGBColor = RGBColor(230, 159, 0);
/// The third colour.
pub const GREEN: RGBColor = RGBColor(0, 158, 115);
/// The fourth colour.
pub const VERMILION: RGBColor = RGBColor(213, 94, 0);
/// The fifth colour.
pub const PURPLE: RGBColor = RGBColor(204, 121, 167);
/// The sixth colour.
pub const SKY: RGBColor = RGBColor(86, 180, 233);
/// Text and axes.
pub const INK: RGBColor = RGBColor(40, 40, 40);
/// Guides, and lines of little importance.
pub const FAINT: RGBColor = RGBColor(190, 190, 190);

/// The colour of a number from 0 to 1, from dark blue to yellow: viridis, whose lightness rises evenly.
pub fn viridis(x: f32) -> Rgb {
    let x = if x.is_nan() { 0.0 } else { x.clamp(0.0, 1.0) };
    linear(ViridisRGB.get_color(x))
}

/// A display's colour as linear values.
pub fn linear(colour: RGBColor) -> Rgb {
    let RGBColor(r, g, b) = colour;
    Rgb::new(f32::from(r), f32::from(g), f32::from(b)).map(|code| tone::decode_srgb(code / 255.0))
}

/// The colour of a direction: −1 … 1 along x, y, z is 0 … 1 of the display's red, green, blue.
pub fn direction(d: Vec3) -> Rgb {
    Rgb::new(d.x, d.y, d.z).map(|v| tone::decode_srgb(0.5 + 0.5 * v))
}

/// The backdrop: a soft gradient, from y = 0 at the top of a picture to y = 1 at its bottom.
pub fn backdrop(y: f32) -> Rgb {
    Rgb::new(0.80, 0.86, 0.95).lerp(Rgb::new(0.98, 0.95, 0.90), y)
}

/// A difference: white for 0, towards orange above, towards blue below; full colour from a difference of 0.25 on.
pub fn signed(difference: f32) -> Rgb {
    let amount = (4.0 * difference.abs()).clamp(0.0, 1.0).sqrt();
    let full = if difference > 0.0 {
        Rgb::new(0.79, 0.35, 0.0)
    } else {
        Rgb::new(0.0, 0.17, 0.45)
    };
    Rgb::WHITE.lerp(full, if difference.is_nan() { 1.0 } else { amount })
}
