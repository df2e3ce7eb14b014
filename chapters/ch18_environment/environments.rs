//! Pictures of environment maps.

use crate::kit::palette::{INK, ORANGE, linear};
use crate::kit::sheet::{Sheet, sheet};
use glam::{Vec2, vec2};
use raybook::image::rgb::Rgb;
use raybook::image::{Image, tone};
use raybook::light::environment::angular::Angular;
use raybook::light::environment::convert::{LatLong, convert};
use raybook::light::environment::cube::Cross;
use raybook::light::environment::{Environment, latlong};
use raybook::math::dir3::Dir3;
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
pub(super) fn layouts(map: &Image) -> Sheet {
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
        ("latitude and longitude", shown(map.resized(400, 200), 400)),
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

/// Number of directions that are chosen in each of the two ways.
pub(super) const DIRECTIONS: u16 = 256;

/// A map twice, for a display, with the same number of directions as dots: chosen uniformly, and by their light. Also returns how
/// many of the directions by their light see more than half of the greatest radiance.
///
/// # Errors
/// If a caption cannot be drawn.
pub(super) fn chosen(map: &Image) -> Result<(Image, usize), Box<dyn Error>> {
    let environment = Environment::new(map.clone());
    let brightest = map.pixels().iter().map(|p| p.luminance());
    let brightest = brightest.fold(0.0, f32::max);
    let by_light: Vec<_> = spread().filter_map(|u| environment.choose(u)).collect();
    let uniform = spread().map(|u| latlong::toward(u.y, f64::from(1.0 - 2.0 * u.x)));
    let bright =
        |direction: &&Dir3| environment.radiance(**direction).luminance() > 0.5 * brightest;
    let in_the_sun = by_light.iter().filter(bright).count();
    let shown = map.resized(480, 240).map(tone::aces);
    let dotted = |directions: &[Dir3]| {
        let mut dotted = shown.clone();
        for &direction in directions {
            dot(&mut dotted, latlong::place(direction));
        }
        dotted
    };
    let tiles = [
        ("uniform directions", dotted(&uniform.collect::<Vec<_>>())),
        ("directions by their light", dotted(&by_light)),
    ];
    Ok((sheet(2, &tiles)?, in_the_sun))
}

/// Points that are spread evenly over the unit square.
fn spread() -> impl Iterator<Item = Vec2> {
    (0..DIRECTIONS).map(|i| {
        let i = f32::from(i) + 0.5;
        vec2(i / f32::from(DIRECTIONS), (0.618_034 * i).fract())
    })
}

/// A dot with a dark rim at a place of a map.
fn dot(map: &mut Image, place: Vec2) {
    /// Radii of the dot and of its rim, in pixels.
    const DOT: f32 = 2.2;
    const RIM: f32 = 3.4;
    let middle = place * vec2(map.width() as f32, map.height() as f32);
    let [from, to] = [middle - RIM, middle + RIM].map(|corner| corner.max(Vec2::ZERO).as_uvec2());
    for y in from.y as usize..=(to.y as usize).min(map.height() - 1) {
        for x in from.x as usize..=(to.x as usize).min(map.width() - 1) {
            let distance = middle.distance(vec2(x as f32 + 0.5, y as f32 + 0.5));
            if distance < RIM {
                let colour = if distance < DOT { ORANGE } else { INK };
                map.set(x, y, linear(colour));
            }
        }
    }
}
