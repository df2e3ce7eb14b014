//! The figure of barycentric coordinates: a triangle with lines of equal b₁ and of equal b₂.

use crate::kit::figure::{CENTRE, Canvas, Figure, LEFT, RIGHT, coloured, figure, write};
use crate::kit::palette::{BLUE, GREEN, INK, VERMILION};
use crate::kit::stage::Drawn;
use glam::{Vec2, Vec3, vec2, vec3};
use plotters::prelude::{Circle, Color, PathElement, RGBColor};
use plotters::style::text_anchor::Pos;
use raybook::image::{rgb::Rgb, tone};

/// The corners, in pixels of the canvas.
const CORNERS: [Vec2; 3] = [vec2(350.0, 1010.0), vec2(1610.0, 890.0), vec2(830.0, 130.0)];
/// The distance of two lines in b.
const STEP: f32 = 0.25;

/// The point p₀ + b₁·e₁ + b₂·e₂ of the canvas.
fn at(b1: f32, b2: f32) -> Vec2 {
    let [p0, p1, p2] = CORNERS;
    p0 + b1 * (p1 - p0) + b2 * (p2 - p0)
}

/// A triangle filled with its barycentric coordinates as colours, and lines on which one of them is constant.
///
/// # Errors
/// What plotters reports.
pub(super) fn draw() -> Figure {
    figure(960, 570, |canvas| {
        fill(canvas)?;
        for i in 0..4 {
            let b = STEP * i as f32;
            line(canvas, at(b, 0.0), at(b, 1.0 - b), VERMILION)?;
            line(canvas, at(0.0, b), at(1.0 - b, b), BLUE)?;
            // The sides are named near their far ends: at p₀ two names would meet.
            let (equal_b1, equal_b2) = (format!("b₁ = {b}"), format!("b₂ = {b}"));
            let (below, beside) = match i {
                0 => (
                    (at(0.89, 0.0), equal_b2, BLUE),
                    (at(0.0, 0.89), equal_b1, VERMILION),
                ),
                _ => (
                    (at(b, 0.0), equal_b1, VERMILION),
                    (at(0.0, b), equal_b2, BLUE),
                ),
            };
            label(canvas, &below.1, below.0 + vec2(8.0, 46.0), below.2, CENTRE)?;
            label(
                canvas,
                &beside.1,
                beside.0 - vec2(28.0, 6.0),
                beside.2,
                RIGHT,
            )?;
        }
        line(canvas, at(1.0, 0.0), at(0.0, 1.0), GREEN)?;
        label(
            canvas,
            "b₁ + b₂ = 1",
            at(0.5, 0.5) + vec2(36.0, -26.0),
            GREEN,
            LEFT,
        )?;
        let [p0, p1, p2] = CORNERS;
        label(canvas, "p₀", p0 + vec2(-30.0, 62.0), INK, RIGHT)?;
        label(canvas, "p₁", p1 + vec2(34.0, 10.0), INK, LEFT)?;
        label(canvas, "p₂", p2 - vec2(0.0, 56.0), INK, CENTRE)?;
        let p = at(0.5, 0.25);
        for corner in [p0, p1, p2, p] {
            canvas.draw(&Circle::new(pixel(corner), 11, INK.filled()))?;
        }
        label(canvas, "p", p + vec2(24.0, 34.0), INK, LEFT)?;
        let text = "p = p₀ + ½·e₁ + ¼·e₂";
        label(canvas, text, vec2(1200.0, 150.0), INK, LEFT)?;
        let text = "b₀ = 1 − b₁ − b₂ = ¼";
        label(canvas, text, vec2(1200.0, 220.0), INK, LEFT)
    })
}

/// Fills the triangle with b₀, b₁, b₂ as red, green and blue, paled so that lines and letters stand out.
fn fill(canvas: &Canvas) -> Drawn {
    let [p0, p1, p2] = CORNERS;
    let (e1, e2) = (p1 - p0, p2 - p0);
    let area = e1.perp_dot(e2);
    for y in 0..1140 {
        for x in 0..1920 {
            let q = vec2(x as f32, y as f32) - p0;
            let (b1, b2) = (q.perp_dot(e2) / area, e1.perp_dot(q) / area);
            if b1 < 0.0 || b2 < 0.0 || b1 + b2 > 1.0 {
                continue;
            }
            let b = Vec3::ONE.lerp(vec3(1.0 - b1 - b2, b1, b2), 0.55);
            let [r, g, b] = Rgb::new(b.x, b.y, b.z).channels().map(tone::to_byte);
            canvas.draw_pixel((x, y), &RGBColor(r, g, b))?;
        }
    }
    Ok(())
}

fn line(canvas: &Canvas, from: Vec2, to: Vec2, colour: RGBColor) -> Drawn {
    let ends = vec![pixel(from), pixel(to)];
    canvas.draw(&PathElement::new(ends, colour.stroke_width(5)))?;
    Ok(())
}

fn label(canvas: &Canvas, text: &str, at: Vec2, colour: RGBColor, part: Pos) -> Drawn {
    write(canvas, text, pixel(at), coloured(40, colour).pos(part))
}

fn pixel(p: Vec2) -> (i32, i32) {
    (p.x.round() as i32, p.y.round() as i32)
}
