//! Chapter 9: the two-level grid.

mod laws;
use raybook_common::whole;

use glam::{U8Vec3, UVec3, Vec3, vec3};
use raybook::accel::two_level_grid::TwoLevelGrid;
use raybook::inside::grid::{Lattice, by_first_use};
use raybook::inside::two_level_grid::{self, Levels, refine_cell, walk_two_levels};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::{mesh::Facet, teapot};
use std::ops::ControlFlow;

fn valid(grid: TwoLevelGrid<Facet>) -> TwoLevelGrid<Facet> {
    assert_eq!(
        grid.validate(),
        Ok(()),
        "a two-level grid keeps its promises"
    );
    grid
}

#[test]
fn crowded_cells_are_cut_finely_and_empty_ones_not_at_all() {
    let cell = Aabb {
        min: Vec3::ZERO,
        max: Vec3::splat(2.0),
    };
    let coarse = Lattice::new(&cell, UVec3::ONE);
    let everywhere = |_, fine: &Lattice| vec![fine.resolution - UVec3::ONE];
    let resolution = |count| {
        let shapes: Vec<u32> = (0..count).collect();
        refine_cell(&coarse, &shapes, 1.0, everywhere).resolution
    };
    assert_eq!(
        resolution(0),
        U8Vec3::ZERO,
        "nothing to find, nothing to cut"
    );
    assert_eq!(resolution(1), U8Vec3::ONE, "one shape, one cell");
    assert_eq!(resolution(64), U8Vec3::splat(4), "64 shapes, 64 cells");
    assert_eq!(
        resolution(20_000_000),
        U8Vec3::splat(255),
        "a byte holds no more"
    );
}

#[test]
fn all_fine_cells_are_in_one_row_without_gaps() {
    let grid = valid(TwoLevelGrid::of_facets(teapot::mesh(6).facets()));
    let levels = two_level_grid::levels(&grid);
    let mut next = 0;
    for coarse in levels.top.all() {
        if let Some((first, fine)) = levels.fine(coarse) {
            assert_eq!(
                first, next,
                "the cells of {coarse} follow those of the one before"
            );
            next += fine.cells();
        }
    }
    assert_eq!(next, levels.cells(), "and the last one ends the row");
    let bytes = grid.bytes() as f32 / teapot::mesh(6).triangles().len() as f32;
    assert!(bytes < 160.0, "{bytes} bytes per triangle");
}

#[test]
fn memory_is_bounded_whatever_the_shapes_are() {
    let huge = (0..300).map(|id| {
        let z = id as f32 * 0.01;
        let corners = [vec3(-9.0, -9.0, z), vec3(9.0, -9.0, z), vec3(0.0, 9.0, z)];
        Facet { corners, id }
    });
    let [x, y, z] = [Vec3::X, Vec3::Y, Vec3::Z];
    let equal = (0..1000).map(|id| Facet {
        corners: [x, y, z],
        id,
    });
    let point = (0..9).map(|id| Facet {
        corners: [x, x, x],
        id,
    });
    for (name, facets) in [
        ("large sheets", huge.collect::<Vec<_>>()),
        ("a thousand equal triangles", equal.collect()),
        ("points at the same place", point.collect()),
        ("nothing", Vec::new()),
    ] {
        let count = facets.len();
        for grid in [
            TwoLevelGrid::of_facets(facets.clone()),
            TwoLevelGrid::new(facets),
        ] {
            let grid = valid(grid);
            let most = (1 << 24).max(32 * count);
            assert!(
                grid.references() <= most,
                "{name}: {} references",
                grid.references()
            );
        }
    }
}

#[test]
fn the_walk_ends_where_it_is_told() {
    let cell = Aabb {
        min: Vec3::ZERO,
        max: Vec3::splat(8.0),
    };
    let top = Lattice::new(&cell, UVec3::new(2, 1, 1));
    let levels = Levels::new(top, [U8Vec3::new(4, 1, 1), U8Vec3::new(2, 1, 1)]);
    let along = Ray::new(vec3(-1.0, 3.0, 3.0), Dir3::X);
    let walked = |most: usize| {
        let mut places = Vec::new();
        walk_two_levels(&levels, &along, Interval::AHEAD, |place, _| {
            places.push(place);
            if places.len() == most {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        places
    };
    let all = [
        None,
        Some(0),
        Some(1),
        Some(2),
        Some(3),
        None,
        Some(4),
        Some(5),
    ];
    assert_eq!(
        walked(99),
        all,
        "coarse cells as none, each before its fine ones"
    );
    for most in 1..all.len() {
        assert_eq!(walked(most), all[..most], "after {most} cells");
    }
}

#[test]
fn shapes_are_numbered_by_their_first_use() {
    let (mut shapes, mut named) = (vec!["a", "b", "c", "d"], vec![3, 1, 3, 0]);
    by_first_use(&mut shapes, &mut named);
    assert_eq!(
        shapes,
        ["d", "b", "a", "c"],
        "in the order of use, the unused last"
    );
    assert_eq!(
        named,
        [0, 1, 0, 2],
        "and they are named by their new numbers"
    );
}
