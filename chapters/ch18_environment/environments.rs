//! Pictures of environment maps.

use crate::kit::sheet::sheet;
use raybook::image::rgb::Rgb;
use raybook::image::{Image, tone};
use raybook::light::environment::angular::Angular;
use raybook::light::environment::convert::{LatLong, convert};
use raybook::light::environment::cube::Cross;
use std::error::Error;

/// The layouts by name, as on a command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Layouts {
    /// Latitude and longitude
    Latlong,
    /// Six faces of a cube, unfolded to a cross
    Cross,
    /// The angular map, a disc
    Angular,
}

impl Layouts {
    /// A map in this layout as a latitude–longitude map.
    pub(super) fn unfold(self, map: &Image) -> Image {
        let (width, height) = (2 * map.height(), map.height());
        match self {
            Self::Latlong => map.clone(),
            Self::Cross => convert(map, &Cross, &LatLong, width, height),
            Self::Angular => convert(map, &Angular, &LatLong, width, height),
        }
    }
}

/// A map, its cross and its angular map side by side, on white, for a display.
///
/// # Errors
/// If a caption cannot be drawn.
pub(super) fn layouts(map: &Image) -> Result<Image, Box<dyn Error>> {
    const HEIGHT: usize = 300;
    let shown = |image: Image, width: usize| {
        let (left, top) = ((width - image.width()) / 2, (HEIGHT - image.height()) / 2);
        Image::from_fn(width, HEIGHT, |x, y| {
            let inside =
                x.wrapping_sub(left) < image.width() && y.wrapping_sub(top) < image.height();
            let light = if inside {
                image.at(x - left, y - top)
            } else {
                Rgb::BLACK
            };
            if light == Rgb::BLACK {
                Rgb::WHITE
            } else {
                tone::aces(light)
            }
        })
    };
    let tiles = [
        (
            "latitude and longitude",
            shown(convert(map, &LatLong, &LatLong, 400, 200), 400),
        ),
        (
            "a cube, unfolded",
            shown(convert(map, &LatLong, &Cross, 400, 300), 400),
        ),
        (
            "by the angle to the middle",
            shown(convert(map, &LatLong, &Angular, 300, 300), 400),
        ),
    ];
    sheet(3, &tiles)
}

/// Four pictures of one size in one, two by two, with a line between them.
pub(super) fn quarters(four: &[Image; 4]) -> Image {
    let (width, height) = (four[0].width(), four[0].height());
    let line = (width / 160).max(1);
    Image::from_fn(2 * width + line, 2 * height + line, |x, y| {
        let (right, below) = (x > width, y > height);
        let on_line = (width..width + line).contains(&x) || (height..height + line).contains(&y);
        if on_line {
            return Rgb::WHITE;
        }
        let quarter = &four[usize::from(right) + 2 * usize::from(below)];
        let along = |v: usize, after: bool, n: usize| if after { v - n - line } else { v };
        quarter.at(along(x, right, width), along(y, below, height))
    })
}
