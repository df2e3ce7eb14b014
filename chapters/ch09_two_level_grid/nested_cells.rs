//! A two-level grid in the plane.

use crate::kit::{figure::Figure, palette::SKY};
use crate::shared::flatland::{SIDE, discs, plane, ray};
use glam::{Vec3, vec3};
use raybook::accel::two_level_grid::build::Densities;
use raybook::inside::grid::{Lattice, grid_resolution, range};
use raybook::inside::two_level_grid::{Levels, refine_cell, walk_two_levels};
use raybook::math::{aabb::Aabb, interval::Interval};
use std::ops::ControlFlow;

/// The two-level grid of some discs, and the fine cells that a ray visits, numbered in order.
///
/// # Errors
/// What plotters reports.
pub(super) fn diagram() -> Figure {
    let (discs, size) = (discs(), vec3(SIDE, SIDE, 1e-4));
    let densities = Densities {
        coarse: 1.0 / 4.0,
        fine: 2.0,
    };
    let square = Aabb::of([Vec3::ZERO, size]);
    let top = Lattice::new(
        &square,
        grid_resolution(size, discs.len(), densities.coarse),
    );
    let cells_of = |disc: u32, lattice: &Lattice| {
        let (first, last) = lattice.cells_of(&discs[disc as usize]);
        range(first, last).collect()
    };
    let resolutions = top.all().map(|cell| {
        let cell = top.only(cell);
        let Aabb { min, max } = cell.bounds();
        let inside = |&i: &u32| {
            let disc = discs[i as usize];
            disc.min.cmplt(max).all() && min.cmple(disc.max).all()
        };
        let inside: Vec<_> = (0..discs.len() as u32).filter(inside).collect();
        refine_cell(&cell, &inside, densities.fine, cells_of).resolution
    });
    let levels = Levels::new(top, resolutions);
    let fine = top.all().filter_map(|cell| levels.fine(cell));
    let cells: Vec<_> = fine
        .flat_map(|(_, fine)| fine.all().map(move |cell| fine.bounds_of(cell, cell)))
        .collect();
    let mut visited = Vec::new();
    walk_two_levels(&levels, &ray(), Interval::AHEAD, |place, _| {
        visited.extend(place);
        ControlFlow::Continue(())
    });
    plane(|plane| {
        for cell in &cells {
            plane.cell(cell, Some((SKY, 0.25)), 2)?;
        }
        for (i, &place) in visited.iter().enumerate() {
            plane.visited(&cells[place], i + 1, 2)?;
        }
        top.all()
            .try_for_each(|cell| plane.cell(&top.bounds_of(cell, cell), None, 7))
    })
}
