//! A ray's walk through a grid, in the plane: the cells numbered in their order, the crossings, the triangles tested.

use crate::kit::figure::{CENTRE, Canvas, Figure, LEFT, coloured, figure, text, write};
use crate::kit::palette::{BLUE, FAINT, GREEN, INK, ORANGE, SKY, VERMILION};
use crate::kit::stage::Drawn;
use glam::{UVec3, Vec3, uvec3, vec2, vec3};
use plotters::prelude::{Circle, Color, PathElement, Polygon, RGBColor, Rectangle};
use raybook::inside::grid::{Lattice, voxels_of_triangle, walk};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray};
use std::ops::ControlFlow;

/// The grid: one layer of cells.
const CELLS: UVec3 = uvec3(8, 5, 1);

/// The triangles, seen from their edges.
const TRIANGLES: [[Vec3; 2]; 6] = [
    [vec3(5.0, 4.0, 0.5), vec3(6.35, 3.15, 0.5)],
    [vec3(6.35, 3.15, 0.5), vec3(7.7, 4.2, 0.5)],
    [vec3(1.3, 3.3, 0.5), vec3(2.6, 4.2, 0.5)],
    [vec3(2.3, 1.2, 0.5), vec3(4.4, 0.4, 0.5)],
    [vec3(0.4, 2.7, 0.5), vec3(0.75, 2.25, 0.5)],
    [vec3(6.4, 0.35, 0.5), vec3(7.4, 1.5, 0.5)],
];

/// Pixels of the canvas per metre.
const METRE: f32 = 180.0;

/// The canvas, in metres: the grid is at its lower right.
const VIEW: (f32, f32) = (9.5, 6.3);

/// The walk's diagram.
///
/// # Errors
/// If it cannot be drawn.
pub(super) fn diagram() -> Figure {
    let bounds = Aabb {
        min: Vec3::ZERO,
        max: CELLS.as_vec3(),
    };
    let lattice = Lattice::new(&bounds, CELLS);
    let ray = Ray::new(
        vec3(-0.9, 0.3, 0.5),
        Dir3::new_or(vec3(1.0, 0.52, 0.0), Dir3::X),
    );
    let (wide, high) = (VIEW.0 * METRE, VIEW.1 * METRE);
    figure(wide as u32 / 2, high as u32 / 2, |canvas| {
        let at = |p: Vec3| {
            (
                (METRE * (p.x + 1.2)) as i32,
                (high - METRE * (p.y + 0.35)) as i32,
            )
        };
        let label = |words: &str, p: Vec3, size: u32, colour: RGBColor| {
            write(canvas, words, at(p), coloured(size, colour).pos(CENTRE))
        };
        let fill = |cell: UVec3, colour: RGBColor, opacity| {
            let corners = [cell.as_vec3(), (cell + 1).as_vec3()].map(at);
            canvas.draw(&Rectangle::new(corners, colour.mix(opacity).filled()))
        };

        let hits = TRIANGLES.map(|segment| meets(&ray, segment));
        let hit = hits.into_iter().flatten().fold(f32::INFINITY, f32::min);
        let mut visits = Vec::new();
        walk(&lattice, &ray, Interval::AHEAD, |cell, inside| {
            visits.push((cell, inside));
            if hit <= inside.max {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        let visited = |cell: &UVec3| visits.iter().any(|(visited, _)| visited == cell);
        let voxels = TRIANGLES.map(|[a, b]| voxels_of_triangle(&lattice, 0.0, &[a, b, b]));
        for &cell in voxels.iter().flatten().filter(|cell| !visited(cell)) {
            fill(cell, SKY, 0.22)?;
        }
        for &(cell, _) in &visits {
            fill(cell, ORANGE, 0.35)?;
        }
        for x in 0..=CELLS.x {
            let x = x as f32;
            let ends = [vec3(x, 0.0, 0.0), vec3(x, bounds.max.y, 0.0)].map(at);
            canvas.draw(&PathElement::new(ends, FAINT.stroke_width(3)))?;
        }
        for y in 0..=CELLS.y {
            let y = y as f32;
            let ends = [vec3(0.0, y, 0.0), vec3(bounds.max.x, y, 0.0)].map(at);
            canvas.draw(&PathElement::new(ends, FAINT.stroke_width(3)))?;
        }
        for (segment, voxels) in TRIANGLES.iter().zip(&voxels) {
            let colour = if voxels.iter().any(visited) {
                VERMILION
            } else {
                BLUE
            };
            canvas.draw(&PathElement::new(segment.map(at), colour.stroke_width(11)))?;
        }

        canvas.draw(&PathElement::new(
            [at(ray.origin), at(ray.at(hit))],
            INK.stroke_width(6),
        ))?;
        let beyond = [at(ray.at(hit)), at(ray.at(hit + 1.5))];
        canvas.draw(&PathElement::new(beyond, FAINT.stroke_width(4)))?;
        let (d, tip) = (ray.direction.truncate(), ray.at(2.05));
        let head = [vec2(0.1, 0.0), vec2(-0.1, 0.08), vec2(-0.1, -0.08)];
        let head = head.map(|p| at(tip + d.rotate(p).extend(0.0)));
        canvas.draw(&Polygon::new(head.to_vec(), INK.filled()))?;
        for (&(cell, inside), number) in visits.iter().zip(1..) {
            let enters = ray.at(inside.min);
            let through_x =
                (enters.x - enters.x.round()).abs() < (enters.y - enters.y.round()).abs();
            let colour = if through_x { BLUE } else { GREEN };
            canvas.draw(&Circle::new(at(enters), 13, colour.filled()))?;
            // In the corner that is farthest from the ray.
            let middle = cell.as_vec3() + 0.5;
            let beside = ray.at(0.5 * (inside.min + inside.max)) - middle;
            let side = if beside.x < beside.y { 1.0 } else { -1.0 };
            let corner = middle + 0.33 * side * vec3(1.0, -1.0, 0.0);
            label(&number.to_string(), corner, 52, INK)?;
        }
        canvas.draw(&Circle::new(at(ray.at(hit)), 17, VERMILION.filled()))?;
        label("hit", ray.at(hit) + vec3(0.0, 0.36, 0.0), 46, VERMILION)?;

        legend(canvas, at)
    })
}

/// What the colours mean, above the grid.
fn legend(canvas: &Canvas, at: impl Fn(Vec3) -> (i32, i32)) -> Drawn {
    let names = [
        (0.9, "crosses a plane x = i", BLUE),
        (3.9, "crosses a plane y = j", GREEN),
        (6.9, "triangle tested", VERMILION),
    ];
    for (x, name, colour) in names {
        let place = vec3(x - 0.85, 5.5, 0.0);
        canvas.draw(&Circle::new(at(place), 13, colour.filled()))?;
        let beside = at(place + vec3(0.16, 0.0, 0.0));
        write(canvas, name, beside, text(42).pos(LEFT))?;
    }
    Ok(())
}

/// The distance at which the ray meets a triangle that is seen from its edge.
fn meets(ray: &Ray, [a, b]: [Vec3; 2]) -> Option<f32> {
    let (along, from) = ((b - a).truncate(), (a - ray.origin).truncate());
    let across = ray.direction.truncate().perp_dot(along);
    let (t, s) = (
        from.perp_dot(along) / across,
        from.perp_dot(ray.direction.truncate()) / across,
    );
    (t > 0.0 && (0.0..=1.0).contains(&s)).then_some(t)
}
