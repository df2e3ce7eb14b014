//! Points of the unit square, drawn as a pixel is: x to the right, y downwards.

use super::diagram::{Diagram, Ink};
use glam::{DVec2, Vec2, dvec2};

/// More points than these nobody can tell apart.
const MOST: usize = 600;

/// Where a point of the picture is drawn.
pub fn down(p: DVec2) -> DVec2 {
    dvec2(p.x, -p.y)
}

/// Draws a square with its top left corner, cut into columns and rows.
pub fn cells(drawing: &mut Diagram, corner: DVec2, [columns, rows]: [u32; 2]) {
    /// More lines than these are a grey area.
    const LINES: u32 = 64;
    for i in (0..=columns).filter(|_| columns <= LINES) {
        let x = corner.x + f64::from(i) / f64::from(columns.max(1));
        let ends = [dvec2(x, corner.y), dvec2(x, corner.y + 1.0)];
        drawing.line(&ends.map(down), Ink::Guide);
    }
    for i in (0..=rows).filter(|_| rows <= LINES) {
        let y = corner.y + f64::from(i) / f64::from(rows.max(1));
        let ends = [dvec2(corner.x, y), dvec2(corner.x + 1.0, y)];
        drawing.line(&ends.map(down), Ink::Guide);
    }
    let side = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y, DVec2::ZERO];
    drawing.line(&side.map(|p| down(corner + p)), Ink::Shape);
    drawing.label(
        down(corner),
        dvec2(0.0, 1.0),
        format!("({}, {})", corner.x, corner.y),
        Ink::Shape,
    );
    let opposite = corner + 1.0;
    let name = format!("({}, {})", opposite.x, opposite.y);
    drawing.label(down(opposite), dvec2(0.0, -1.0), name, Ink::Shape);
}

/// Draws the points of both answers. What is far outside of the square is left out.
pub fn points(drawing: &mut Diagram, corner: DVec2, right: &[Vec2], yours: Option<&Vec<Vec2>>) {
    let yours = yours.map_or(&[][..], Vec::as_slice);
    for (points, ink) in [(right, Ink::Right), (yours, Ink::Yours)] {
        for p in points.iter().take(MOST).map(|p| p.as_dvec2()) {
            if (p - corner - 0.5).abs().max_element() < 1.0 {
                drawing.point(down(p), ink);
            }
        }
    }
}
