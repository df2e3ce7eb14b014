//! An area light as points, one in each of its cells, and the shadow rays to them.

use crate::kit::figure::{Figure, LEFT, figure};
use crate::kit::palette::{BLUE, FAINT, INK, ORANGE, VERMILION};
use crate::kit::sketch::Sketch;
use glam::{Vec3, vec2, vec3};
use raybook::camera::pinhole::Pinhole;
use raybook::image::rgb::Rgb;
use raybook::light::rect_light::RectLight;
use raybook::math::{dir3::Dir3, interval::Interval, pcg::stream, ray::Ray};
use raybook::sample::pattern::jittered::jittered;
use raybook::shape::{Shape, triangle::Triangle};

/// The point whose light is asked for.
const POINT: Vec3 = Vec3::ZERO;

/// A corner and the two sides of the light, and the cells along each.
const LIGHT: [Vec3; 3] = [
    vec3(-1.8, 2.0, -0.6),
    vec3(3.2, 0.0, 0.0),
    vec3(0.0, 0.0, 1.2),
];
const CELLS: [usize; 2] = [4, 2];

/// The random numbers with which no two of the shadow rays look like one.
const SEED: u64 = 7;

/// The corners of the board.
const BOARD: [Vec3; 4] = [
    vec3(0.06, 0.95, 0.5),
    vec3(1.3, 0.95, 0.5),
    vec3(1.3, 0.95, -0.5),
    vec3(0.06, 0.95, -0.5),
];

/// Draws them; the caption says how many points are seen.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Result<(Figure, String), Box<dyn std::error::Error>> {
    let [corner, a, b] = LIGHT;
    let light = RectLight::new(corner, a, b, Rgb::WHITE);
    let points = jittered(CELLS[0], CELLS[1], &mut stream(SEED, 0));
    let points: Vec<_> = points.into_iter().map(|u| light.point(u)).collect();
    let [p0, p1, p2, p3] = BOARD;
    let board = [Triangle::new(p0, p1, p2), Triangle::new(p0, p2, p3)];
    let meets_board = |p: Vec3| {
        let ray = Ray::new(POINT, Dir3::new_or(p - POINT, Dir3::Y));
        let mut hits = board
            .iter()
            .filter_map(|half| half.hit(&ray, Interval::AHEAD));
        hits.next().map(|hit| ray.at(hit.t))
    };
    let (seen, all) = (
        points.iter().filter(|p| meets_board(**p).is_none()).count(),
        points.len(),
    );
    let viewer = Pinhole::look_at(
        vec3(0.6, 4.2, 7.0),
        vec3(0.4, 1.02, 0.0),
        Vec3::Y,
        0.066,
        2.0,
    )?;
    let figure = figure(720, 360, |canvas| {
        let sketch = Sketch { canvas, viewer };
        let floor =
            [(-2.0, 0.9), (3.0, 0.9), (3.0, -0.9), (-2.0, -0.9)].map(|(x, z)| vec3(x, 0.0, z));
        sketch.area(&floor, FAINT, 0.35)?;
        let outline = [corner, corner + a, corner + a + b, corner + b, corner];
        sketch.area(&outline, ORANGE, 0.3)?;
        for i in 1..CELLS[0] {
            let side = corner + i as f32 / CELLS[0] as f32 * a;
            sketch.line(&[side, side + b], ORANGE, 3)?;
        }
        for j in 1..CELLS[1] {
            let side = corner + j as f32 / CELLS[1] as f32 * b;
            sketch.line(&[side, side + a], ORANGE, 3)?;
        }
        sketch.line(&outline, ORANGE, 5)?;
        sketch.area(&BOARD, INK, 0.25)?;
        sketch.line(&[p0, p1, p2, p3, p0], INK, 4)?;
        for &p in &points {
            if let Some(board) = meets_board(p) {
                sketch.dashes(POINT, board, INK, 3)?;
                sketch.dot(board, 8, INK)?;
                sketch.dot(p, 10, INK)?;
            } else {
                sketch.line(&[POINT, p], VERMILION, 4)?;
                sketch.dot(p, 10, VERMILION)?;
            }
        }
        sketch.dot(POINT, 12, BLUE)?;
        sketch.label(POINT, vec2(0.0, 40.0), "x", BLUE)?;
        let beside = corner + a + 0.5 * b;
        sketch.words(beside, vec2(40.0, -24.0), "an area light,", INK, LEFT)?;
        sketch.words(
            beside,
            vec2(40.0, 24.0),
            "one point in each cell",
            INK,
            LEFT,
        )?;
        sketch.words(BOARD[1], vec2(24.0, -6.0), "a board", INK, LEFT)?;
        let words = format!("{seen} of {all} points are seen");
        sketch.words(POINT, vec2(120.0, -26.0), &words, VERMILION, LEFT)
    });
    let caption = format!(
        "An area light as points, one in each cell of the light. From x, {seen} of the {all} shadow rays arrive, so x receives about {seen}/{all} of \
        the light."
    );
    Ok((figure, caption))
}
