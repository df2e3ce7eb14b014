//! Eight boxes, one ray, and the sums that tell which of the boxes the ray meets.

use crate::kit::figure::{CENTRE, Canvas, Figure, coloured, figure, write};
use crate::kit::palette::{BLUE, FAINT, GREEN, INK, VERMILION};
use crate::kit::stage::Drawn;
use glam::{Vec2, vec2, vec3};
use plotters::prelude::{Circle, Color, PathElement, RGBColor, Rectangle};
use raybook::inside::wide_bvh::{CHILDREN, meets};
use raybook::math::aabb::Aabb;
use raybook::math::dir3::Dir3;
use raybook::math::interval::Interval;
use raybook::math::ray::Ray;

/// The boxes: least x and y, greatest x and y.
const BOXES: [[f32; 4]; CHILDREN] = [
    [1.2, 0.6, 3.0, 1.9],
    [2.4, 2.6, 4.1, 4.0],
    [4.6, 0.5, 6.3, 1.5],
    [3.7, 1.7, 5.6, 3.2],
    [6.0, 2.4, 7.4, 3.6],
    [6.7, 0.8, 8.3, 2.1],
    [0.9, 3.2, 2.1, 4.3],
    [7.8, 3.3, 9.3, 4.6],
];

/// Pixels of the canvas per metre, and where the origin is.
const SCALE: f32 = 176.0;
const ORIGIN: Vec2 = vec2(110.0, 880.0);

/// The boxes and the ray above, the eight lanes' sums below.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let ray = Ray::new(
        vec3(0.2, 0.5, 0.0),
        Dir3::new_or(vec3(9.0, 3.2, 0.0), Dir3::X),
    );
    let aabb = |[x0, y0, x1, y1]: [f32; 4]| Aabb {
        min: vec3(x0, y0, -1.0),
        max: vec3(x1, y1, 1.0),
    };
    let boxes = BOXES.map(aabb);
    let (met, t) = meets(&boxes, &ray, Interval::AHEAD);
    figure(960, 820, |canvas| {
        let mut order: Vec<_> = (0..CHILDREN).filter(|lane| met >> lane & 1 == 1).collect();
        order.sort_by(|&a, &b| t[a].total_cmp(&t[b]));
        for (lane, [x0, y0, x1, y1]) in BOXES.into_iter().enumerate() {
            let colour = colour(met, lane);
            let corners = [pixel(vec2(x0, y0)), pixel(vec2(x1, y1))];
            canvas.draw(&Rectangle::new(corners, colour.mix(0.16).filled()))?;
            canvas.draw(&Rectangle::new(corners, colour.stroke_width(5)))?;
            let middle = pixel(vec2(0.5 * (x0 + x1), y1 - 0.26));
            centred(canvas, &lane.to_string(), middle, colour)?;
        }
        let end = vec2(0.2, 0.5) + 9.3 * vec2(9.0, 3.2).normalize();
        let line = vec![pixel(vec2(0.2, 0.5)), pixel(end)];
        canvas.draw(&PathElement::new(line, BLUE.stroke_width(7)))?;
        for &lane in &order {
            let at = ray.at(t[lane]);
            let place = pixel(vec2(at.x, at.y));
            canvas.draw(&Circle::new(place, 13, BLUE.filled()))?;
        }
        table(canvas, &boxes, &ray, met, &order)
    })
}

/// A row of the table: its name, and its text for each lane.
type Row<'a> = (&'a str, &'a dyn Fn(usize) -> String);

/// The lanes' sums, a column for each.
fn table(canvas: &Canvas, boxes: &[Aabb], ray: &Ray, met: u32, order: &[usize]) -> Drawn {
    let along = |row: usize, lane: usize| {
        let (axis, Aabb { min, max }) = (row / 2, boxes[lane]);
        let plane = if row.is_multiple_of(2) { min } else { max };
        (plane[axis] - ray.origin[axis]) / ray.direction[axis]
    };
    let enter = |lane: usize| along(0, lane).max(along(2, lane)).max(0.0);
    let leave = |lane: usize| along(1, lane).min(along(3, lane));
    let number = |t: f32| format!("{t:.1}");
    let rows: [Row; 8] = [
        ("lane", &|lane| lane.to_string()),
        ("x: enter", &|lane| number(along(0, lane))),
        ("y: enter", &|lane| number(along(2, lane))),
        ("largest", &|lane| number(enter(lane))),
        ("x: leave", &|lane| number(along(1, lane))),
        ("y: leave", &|lane| number(along(3, lane))),
        ("least", &|lane| number(leave(lane))),
        ("turn", &|lane| {
            let turn = order.iter().position(|&other| other == lane);
            turn.map_or("–".to_owned(), |turn| (turn + 1).to_string())
        }),
    ];
    for (row, (name, cell)) in (0..).zip(rows) {
        let y = 1000 + 80 * row;
        let strong = [3, 6].contains(&row);
        if strong || row == 7 {
            let band = [(60, y - 38), (1860, y + 38)];
            canvas.draw(&Rectangle::new(band, FAINT.mix(0.3).filled()))?;
        }
        centred(canvas, name, (200, y), INK)?;
        for lane in 0..CHILDREN {
            let x = 460 + 180 * lane as i32;
            centred(canvas, &cell(lane), (x, y), colour(met, lane))?;
        }
    }
    Ok(())
}

fn colour(met: u32, lane: usize) -> RGBColor {
    if met >> lane & 1 == 1 {
        GREEN
    } else {
        VERMILION
    }
}

fn pixel(p: Vec2) -> (i32, i32) {
    let at = ORIGIN + SCALE * vec2(p.x, -p.y);
    (at.x as i32, at.y as i32)
}

/// Writes words with their middle at a place.
fn centred(canvas: &Canvas, words: &str, at: (i32, i32), colour: RGBColor) -> Drawn {
    write(canvas, words, at, coloured(48, colour).pos(CENTRE))
}
