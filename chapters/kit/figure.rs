//! Diagrams and plots, drawn by plotters with the font of this package.

use crate::kit::{palette::INK, paper::Paper, stage::Drawn, vectors::compact};
use plotters::coord::Shift;
use plotters::prelude::{DrawingArea, IntoDrawingArea, IntoFont, RGBColor, Text, TextStyle, WHITE};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use raybook::image::{Image, rgb::Rgb, tone};
use std::error::Error;
use std::sync::Once;

/// What a figure is drawn on.
pub type Canvas<'a> = DrawingArea<Paper<'a>, Shift>;

/// A drawing in both of its forms.
#[derive(Clone, Debug)]
pub struct Diagram {
    /// As pixels.
    pub pixels: Image,
    /// As the text of an SVG file, in which single pixels are missing: where a picture is part of the figure, it is in `pixels` only.
    pub svg: String,
}

/// A figure, or why it could not be drawn.
pub type Figure = Result<Diagram, Box<dyn Error>>;

/// The font family of every figure: `DejaVu` Sans, which knows Greek and mathematics.
const FONT: &str = "sans-serif";

/// Pixels of the canvas per pixel of the figure, in each direction; their mean smooths the edges.
pub const SCALE: u32 = 2;

/// A figure of this width and height in pixels, drawn on white.
///
/// The canvas is [`SCALE`] times as wide and high, and sizes of text and lines are in *its* pixels.
///
/// # Errors
/// What `draw` or plotters reports.
pub fn figure(width: u32, height: u32, mut draw: impl FnMut(&Canvas) -> Drawn) -> Figure {
    let Diagram { pixels, svg } = canvas(width, height, &mut draw)?;
    let pixels = smoothed(&pixels);
    Ok(Diagram { pixels, svg })
}

/// A picture with a pixel for each block of a canvas: the mean of the block.
pub fn smoothed(canvas: &Image) -> Image {
    let scale = SCALE as usize;
    Image::from_fn(canvas.width() / scale, canvas.height() / scale, |x, y| {
        let pixel = |i: usize| canvas.at(scale * x + i % scale, scale * y + i / scale);
        (0..scale * scale).map(pixel).sum::<Rgb>() / (scale * scale) as f32
    })
}

/// As [`figure`], but with every pixel of its canvas: twice the resolution.
///
/// # Errors
/// What `draw` or plotters reports.
pub fn canvas(width: u32, height: u32, draw: &mut dyn FnMut(&Canvas) -> Drawn) -> Figure {
    register_font();
    let (wide, high) = (SCALE * width, SCALE * height);
    let (mut bytes, mut svg) = (vec![0; (wide * high * 3) as usize], String::new());
    {
        let canvas = Paper::new(&mut bytes, &mut svg, (wide, high)).into_drawing_area();
        canvas.fill(&WHITE)?;
        draw(&canvas)?;
        canvas.present()?;
    }
    Ok(diagram((width, height), &bytes, &svg))
}

/// The pixels of a canvas as a picture, and its vectors at the size of the figure.
fn diagram((width, height): (u32, u32), bytes: &[u8], svg: &str) -> Diagram {
    let (wide, high) = ((SCALE * width) as usize, (SCALE * height) as usize);
    let linear: Vec<f32> = (0..=255_u8)
        .map(|code| tone::decode_srgb(f32::from(code) / 255.0))
        .collect();
    let pixels = Image::from_fn(wide, high, |x, y| {
        let channel = |i: usize| linear[usize::from(bytes[3 * (y * wide + x) + i])];
        Rgb::new(channel(0), channel(1), channel(2))
    });
    let svg = compact(svg, (width, height));
    Diagram { pixels, svg }
}

/// Width of the white rim that lifts words off what they cross, in pixels of the canvas.
pub const HALO: f32 = 4.0;

/// How text looks.
pub type Style = TextStyle<'static>;

/// Text is anchored at its middle, at the middle of its left end, or of its right end.
pub const CENTRE: Pos = Pos {
    h_pos: HPos::Center,
    v_pos: VPos::Center,
};
/// As [`CENTRE`].
pub const LEFT: Pos = Pos {
    h_pos: HPos::Left,
    v_pos: VPos::Center,
};
/// As [`CENTRE`].
pub const RIGHT: Pos = Pos {
    h_pos: HPos::Right,
    v_pos: VPos::Center,
};

/// Text in ink, of this height in pixels of the canvas. It is anchored at its top left, unless it is given a
/// [position](TextStyle::pos).
pub fn text(size: impl Into<f64>) -> Style {
    coloured(size, INK)
}

/// As [`text`], in another colour.
pub fn coloured(size: impl Into<f64>, colour: RGBColor) -> Style {
    (FONT, size.into()).into_font().color(&colour)
}

/// Width of words whose letters have this height, both in pixels of the canvas.
///
/// # Errors
/// If plotters cannot read its font.
pub fn text_width(words: &str, size: f64) -> Result<f64, Box<dyn Error>> {
    register_font();
    let (width, _) = text(size).font.box_size(words)?;
    Ok(f64::from(width))
}

/// Writes words at a place of a canvas.
///
/// # Errors
/// If plotters cannot draw.
pub fn write(canvas: &Canvas, words: &str, at: (i32, i32), style: Style) -> Drawn {
    canvas.draw(&Text::new(words, at, style))?;
    Ok(())
}

/// Gives plotters its font, once.
fn register_font() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let font = include_bytes!("fonts/DejaVuSans.ttf");
        let bold = include_bytes!("fonts/DejaVuSans-Bold.ttf");
        for (style, bytes) in [
            (plotters::style::FontStyle::Normal, &font[..]),
            (plotters::style::FontStyle::Bold, &bold[..]),
        ] {
            let known = plotters::style::register_font(FONT, style, bytes);
            assert!(known.is_ok(), "the font that comes along is a font");
        }
    });
}
