//! What a figure is drawn on: pixels and vectors at the same time, so that it is drawn once.

use plotters::prelude::{BitMapBackend, DrawingBackend, SVGBackend};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingErrorKind,
};
use std::error::Error;
use std::{fmt, io};

/// A picture of pixels and an SVG text of the same size; each line, area and word goes to both.
pub struct Paper<'a> {
    pixels: BitMapBackend<'a>,
    vectors: SVGBackend<'a>,
}

impl fmt::Debug for Paper<'_> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Paper").finish_non_exhaustive()
    }
}

impl<'a> Paper<'a> {
    /// Draws into the bytes of red, green, blue of each pixel, and into the text.
    pub(super) fn new(bytes: &'a mut [u8], svg: &'a mut String, size: (u32, u32)) -> Self {
        Self {
            pixels: BitMapBackend::with_buffer(bytes, size),
            vectors: SVGBackend::with_string(svg, size),
        }
    }
}

/// By how much plotters' text of pixels stands higher than that of vectors, as a multiple of the size of the text.
const LEVEL: f64 = 0.12;

/// By how much plotters' text of vectors stands too high, likewise: the middle of digits and small letters is above the middle of
/// their line, and the numbers of an x axis touch those of the y axis.
const LOWER: f64 = 0.05;

/// What both backends report.
type Done = Result<(), DrawingErrorKind<io::Error>>;

/// A backend's error as one that both can have.
fn known<E: Error + Send + Sync + 'static>(
    error: DrawingErrorKind<E>,
) -> DrawingErrorKind<io::Error> {
    match error {
        DrawingErrorKind::DrawingError(error) => {
            DrawingErrorKind::DrawingError(io::Error::other(error.to_string()))
        }
        DrawingErrorKind::FontError(error) => DrawingErrorKind::FontError(error),
    }
}

impl DrawingBackend for Paper<'_> {
    type ErrorType = io::Error;

    fn get_size(&self) -> (u32, u32) {
        self.pixels.get_size()
    }

    fn ensure_prepared(&mut self) -> Done {
        self.pixels.ensure_prepared().map_err(known)?;
        self.vectors.ensure_prepared()
    }

    fn present(&mut self) -> Done {
        self.pixels.present().map_err(known)?;
        self.vectors.present()
    }

    /// A single pixel is a part of a picture, and no vector: it is not in the SVG.
    fn draw_pixel(&mut self, at: BackendCoord, colour: BackendColor) -> Done {
        self.pixels.draw_pixel(at, colour).map_err(known)
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Done {
        self.pixels.draw_line(from, to, style).map_err(known)?;
        self.vectors.draw_line(from, to, style)
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        upper_left: BackendCoord,
        bottom_right: BackendCoord,
        style: &S,
        fill: bool,
    ) -> Done {
        let drawn = self.pixels.draw_rect(upper_left, bottom_right, style, fill);
        drawn.map_err(known)?;
        self.vectors
            .draw_rect(upper_left, bottom_right, style, fill)
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Done {
        let path: Vec<_> = path.into_iter().collect();
        let drawn = self.pixels.draw_path(path.iter().copied(), style);
        drawn.map_err(known)?;
        self.vectors.draw_path(path, style)
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        centre: BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Done {
        let drawn = self.pixels.draw_circle(centre, radius, style, fill);
        drawn.map_err(known)?;
        self.vectors.draw_circle(centre, radius, style, fill)
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        corners: I,
        style: &S,
    ) -> Done {
        let corners: Vec<_> = corners.into_iter().collect();
        let drawn = self.pixels.fill_polygon(corners.iter().copied(), style);
        drawn.map_err(known)?;
        self.vectors.fill_polygon(corners, style)
    }

    fn draw_text<S: BackendTextStyle>(&mut self, words: &str, style: &S, at: BackendCoord) -> Done {
        let below = |sizes: f64| {
            let (x, y) = style
                .transform()
                .transform(0, (sizes * style.size()).round() as i32);
            (at.0 + x, at.1 + y)
        };
        let pixels = self.pixels.draw_text(words, style, below(LEVEL + LOWER));
        pixels.map_err(known)?;
        self.vectors.draw_text(words, style, below(LOWER))
    }
}
