//! Colours that colour-blind people can tell apart.

use super::okabe_ito;
use glam::Vec3;
use plotters::style::{
    RGBColor,
    colors::colormaps::{ColorMap, ViridisRGB},
};
use raybook::image::{rgb::Rgb, tone};

/// The first colour of Okabe and Ito's palette, in the order in which a plot takes its colours.
pub const BLUE: RGBColor = plotted(okabe_ito::BLUE);
/// The second colour.
pub const ORANGE: RGBColor = plotted(okabe_ito::ORANGE);
/// The third colour.
pub const GREEN: RGBColor = plotted(okabe_ito::GREEN);
/// The fourth colour.
pub const VERMILION: RGBColor = plotted(okabe_ito::VERMILION);
/// The fifth colour.
pub const PURPLE: RGBColor = plotted(okabe_ito::PURPLE);
/// The sixth colour.
pub const SKY: RGBColor = plotted(okabe_ito::SKY);
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
    okabe_ito::linear([r, g, b])
}

/// A colour for plots.
const fn plotted([r, g, b]: [u8; 3]) -> RGBColor {
    RGBColor(r, g, b)
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
