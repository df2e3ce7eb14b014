//! Beams through a flat surface at several angles: where each part of the light goes.

use crate::kit::figure::{CENTRE, Canvas, Figure, RIGHT, coloured, figure, write};
use crate::kit::palette::{BLUE, FAINT, INK, SKY, VERMILION};
use crate::kit::stage::Drawn;
use glam::{Vec2, Vec3, vec2, vec3};
use plotters::element::{PathElement, Polygon, Rectangle};
use plotters::prelude::{Color, RGBColor};
use plotters::style::text_anchor::Pos;
use raybook::material::fresnel::fresnel;
use raybook::material::refract::refract;
use raybook::math::dir3::Dir3;

/// The index of air, above; glass is below.
const AIR: f32 = 1.0;

/// Angles to the normal, in degrees: into glass, and out of it.
const ANGLES: [[f32; 4]; 2] = [[0.0, 35.0, 60.0, 80.0], [0.0, 25.0, 40.0, 55.0]];

/// Size of a panel, its middle, and the length of a beam, in pixels of the canvas. The longest label, 100 %, begins 138 pixels beside the
/// middle, where no beam ends.
const PANEL: [i32; 2] = [500, 440];
const MIDDLE: Vec2 = Vec2::new(250.0, 240.0);
const LENGTH: f32 = 130.0;

/// The width of a beam that holds all the light, in pixels of the canvas.
const WIDEST: f32 = 26.0;

/// Beams from above into glass of an index, and from below out of it; the width of a beam is its share of the light.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn diagram(glass: f32) -> Figure {
    let (width, height) = (2 * PANEL[0] as u32, PANEL[1] as u32);
    figure(width, height, |canvas| {
        let panels = canvas.split_evenly((2, 4));
        for (i, panel) in panels.iter().enumerate() {
            draw(panel, glass, ANGLES[i / 4][i % 4], i >= 4)?;
        }
        Ok(())
    })
}

/// One beam; `out` if it comes from below.
fn draw(canvas: &Canvas, glass: f32, degrees: f32, out: bool) -> Drawn {
    let (up, n1, n2) = if out {
        (1.0, glass, AIR)
    } else {
        (-1.0, AIR, glass)
    };
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let share = fresnel(cosine, n1, n2).unpolarised;
    let surface = MIDDLE.y as i32;
    let below = [(10, surface), (PANEL[0] - 10, PANEL[1] - 14)];
    canvas.draw(&Rectangle::new(below, SKY.mix(0.3).filled()))?;
    let normal = vec![
        (MIDDLE.x as i32, surface - 175),
        (MIDDLE.x as i32, surface + 175),
    ];
    canvas.draw(&PathElement::new(normal, FAINT.stroke_width(3)))?;
    let incoming = Dir3::new_or(vec3(sine, up * cosine, 0.0), Dir3::Y);
    let refracted = refract(incoming, Dir3::Y, AIR, glass);
    beam(canvas, -*incoming, 1.0, INK)?;
    if let Some(refracted) = refracted {
        beam(canvas, *refracted, 1.0 - share, BLUE)?;
    }
    let mirrored = vec3(sine, -up * cosine, 0.0);
    beam(canvas, mirrored, share, VERMILION)?;
    let way = if out { "out of glass" } else { "into glass" };
    label(
        canvas,
        &format!("{way}, {degrees:.0}°"),
        (MIDDLE.x, 26.0),
        INK,
        CENTRE,
    )?;
    let beside = |side: f32| (MIDDLE.x + 238.0, MIDDLE.y + side * 26.0);
    let percent = |share: f32| format!("{:.0} %", 100.0 * share);
    label(canvas, &percent(share), beside(up), VERMILION, RIGHT)?;
    label(canvas, &percent(1.0 - share), beside(-up), BLUE, RIGHT)
}

/// A beam from the middle, as wide as its share of the light.
fn beam(canvas: &Canvas, toward: Vec3, share: f32, colour: RGBColor) -> Drawn {
    let toward = vec2(toward.x, -toward.y);
    let side = 0.5 * WIDEST * share * toward.perp();
    let end = MIDDLE + LENGTH * toward;
    let corners = [MIDDLE + side, end + side, end - side, MIDDLE - side];
    let corners = corners.map(|p| (p.x.round() as i32, p.y.round() as i32));
    canvas.draw(&Polygon::new(corners, colour.filled()))?;
    Ok(())
}

fn label(canvas: &Canvas, words: &str, at: (f32, f32), colour: RGBColor, end: Pos) -> Drawn {
    let at = (at.0 as i32, at.1 as i32);
    write(canvas, words, at, coloured(34, colour).pos(end))
}
