//! The letters of the lesson: pixels whose samples agree or differ, and what is known of their mean.

use crate::kit::figure::Figure;
use crate::kit::palette::{BLUE, INK, VERMILION};
use crate::kit::sketch::{Sketch, flat, xy};
use crate::kit::stage::Drawn;
use glam::{Vec2, Vec3, vec2};
use raybook::math::pcg::stream;
use raybook::sample::pattern::jittered::jittered;

/// Where an edge meets the upper and the lower side of a pixel.
const EDGE: [f32; 2] = [0.62, 0.4];

/// Luminances of the samples of one pixel.
const LUMINANCES: [f32; 4] = [0.17, 0.46, 0.69, 0.83];

/// The luminance axis: where it begins, and its length.
const AXIS: (Vec3, f32) = (xy(0.0, -0.85), 3.9);

/// What the diagram shows.
pub(super) const CAPTION: &str = "The letters of this lesson. A pixel has n samples of luminance Yᵢ. The smallest is min and the largest is max. Their mean \
    is Ȳ, and the standard error s/√n tells how well the mean is known.";

/// Draws three pixels and the luminances of one.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    flat((760, 410), xy(2.0, -0.17), 2.6, |sketch| {
        let few = jittered(2, 2, &mut stream(1, 0));
        let more = jittered(4, 4, &mut stream(2, 0));
        pixel(sketch, xy(0.0, 0.0), 1.0, &few, "n = 4: they agree")?;
        pixel(sketch, xy(1.5, 0.0), EDGE[0], &few, "n = 4: they differ")?;
        let words = format!("n = {}: more", few.len() + more.len());
        pixel(sketch, xy(3.0, 0.0), EDGE[0], &[few, more].concat(), &words)?;
        luminances(sketch)
    })
}

/// A pixel with its samples; left of its edge is a wall.
fn pixel(sketch: &Sketch, corner: Vec3, upper: f32, samples: &[Vec2], words: &str) -> Drawn {
    let lower = if upper < 1.0 { EDGE[1] } else { 1.0 };
    let wall = [(0.0, 0.0), (lower, 0.0), (upper, 1.0), (0.0, 1.0)];
    sketch.area(&wall.map(|(x, y)| corner + xy(x, y)), BLUE, 0.3)?;
    let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)];
    sketch.line(&square.map(|(x, y)| corner + xy(x, y)), INK, 4)?;
    for p in samples {
        sketch.dot(corner + p.extend(0.0), 9, VERMILION)?;
    }
    sketch.label(corner + xy(0.5, 0.0), vec2(0.0, 36.0), words, INK)
}

/// Luminances on a line, their mean, and the standard error of the mean.
fn luminances(sketch: &Sketch) -> Drawn {
    let (start, length) = AXIS;
    let at = |y: f32| start + length * y * Vec3::X;
    sketch.arrow(at(0.0), at(1.0), INK, 4)?;
    sketch.label(at(1.0), vec2(30.0, 0.0), "Y", INK)?;
    let n = LUMINANCES.len() as f32;
    let mean = LUMINANCES.iter().sum::<f32>() / n;
    let squares: f32 = LUMINANCES.iter().map(|y| (y - mean).powi(2)).sum();
    let error = (squares / (n - 1.0) / n).sqrt();
    for (y, name) in LUMINANCES.into_iter().zip(["min", "Yᵢ", "", "max"]) {
        sketch.dot(at(y), 11, VERMILION)?;
        sketch.label(at(y), vec2(0.0, 42.0), name, VERMILION)?;
    }
    let high = xy(0.0, 0.13);
    sketch.line(&[at(mean) - high, at(mean) + high], BLUE, 6)?;
    sketch.label(at(mean), vec2(0.0, 70.0), "Ȳ", BLUE)?;
    let above = 1.5 * high;
    sketch.measure(at(mean - error) + above, at(mean + error) + above, BLUE)?;
    sketch.label(at(mean + error) + above, vec2(76.0, 0.0), "± s/√n", BLUE)
}
