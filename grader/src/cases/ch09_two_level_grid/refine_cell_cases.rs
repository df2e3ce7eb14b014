//! The questions of `refine_cell`.

use crate::{Edge, sample};
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch05_box::Corners;
use raybook_workbook::exercises::ch09_two_level_grid::{RefineCell, RefineCellQuestion};
use glam::{Vec3, vec3};
use rand::RngExt;

/// The cases that are most often got wrong.
pub(super) fn edges() -> Vec<Edge<RefineCell>> {
    let question = |max: Vec3, density, shapes: &[(Vec3, Vec3)]| RefineCellQuestion {
        min: vec3(1.0, 2.0, 3.0),
        max: vec3(1.0, 2.0, 3.0) + max,
        density,
        shapes: shapes
            .iter()
            .map(|&(min, max)| Corners { min, max })
            .collect(),
    };
    let edge = |name, max, density, shapes: &[_]| Edge::new(name, question(max, density, shapes));
    let corner = (vec3(1.1, 2.1, 3.1), vec3(1.3, 2.4, 3.2));
    let across = (vec3(1.2, 2.2, 3.2), vec3(2.8, 3.8, 3.4));
    let outside = (vec3(0.5, 1.5, 2.5), vec3(1.6, 2.4, 3.4));
    let larger = (Vec3::ZERO, Vec3::splat(9.0));
    let far = (vec3(2.7, 3.7, 4.7), vec3(2.9, 3.9, 4.9));
    let cube = Vec3::splat(2.0);
    vec![
        edge("no shapes", cube, 2.0, &[]),
        edge("one small shape", cube, 1.0, &[corner]),
        edge("one shape, eight fine cells", cube, 8.0, &[corner]),
        edge("one that reaches across", cube, 8.0, &[across]),
        edge("one that begins outside", cube, 8.0, &[outside]),
        edge("one larger than the cell", cube, 8.0, &[larger]),
        edge("in opposite corners", cube, 4.0, &[corner, far]),
        edge(
            "a long cell",
            vec3(8.0, 2.0, 1.0),
            4.0,
            &[corner, across, outside],
        ),
        edge("a flat cell", vec3(4.0, 4.0, 0.01), 4.0, &[larger, outside]),
    ]
}

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> RefineCellQuestion {
    let min = sample::point(rng, 3.0);
    let size = vec3(
        sample::number(rng, 1.0, 4.0),
        sample::number(rng, 1.0, 4.0),
        sample::number(rng, 1.0, 4.0),
    );
    let shapes = (0..rng.random_range(2..6))
        .map(|_| {
            let middle = min + size * (sample::point(rng, 0.55) + 0.5);
            let half = 0.2 * size * (sample::point(rng, 0.5) + 0.5);
            // All of them reach the cell.
            let middle = middle.clamp(min - 0.5 * half, min + size + 0.5 * half);
            Corners {
                min: middle - half,
                max: middle + half,
            }
        })
        .collect();
    RefineCellQuestion {
        min,
        max: min + size,
        density: sample::number(rng, 2.0, 6.0),
        shapes,
    }
}
