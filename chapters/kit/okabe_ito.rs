//! Okabe and Ito's palette (2008), as codes of a display: red, green and blue. Colour-blind people can tell its colours apart.

use raybook::image::{rgb::Rgb, tone};

/// The first colour.
pub const BLUE: [u8; 3] = [0, 114, 178];
/// The second colour.
pub const ORANGE: [u8; 3] = [230, 159, 0];
/// The third colour.
pub const GREEN: [u8; 3] = [0, 158, 115];
/// The fourth colour.
pub const VERMILION: [u8; 3] = [213, 94, 0];
/// The fifth colour.
pub const PURPLE: [u8; 3] = [204, 121, 167];
/// The sixth colour.
pub const SKY: [u8; 3] = [86, 180, 233];

/// A display's colour as linear values.
pub fn linear(code: [u8; 3]) -> Rgb {
    let [r, g, b] = code.map(f32::from);
    Rgb::new(r, g, b).map(|code| tone::decode_srgb(code / 255.0))
}
