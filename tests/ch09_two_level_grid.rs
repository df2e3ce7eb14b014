//! Chapter 9: the two-level grid.

#[path = "common/rays.rs"]
mod rays;

use glam::{U8Vec3, UVec3, Vec3, vec3};
use proptest::prelude::*;
use raybook::accel::lattice::Lattice;
use raybook::accel::two_level_grid::{
    TwoLevelGrid, build::Densities, levels::Levels, refine::refine_cell, walk::walk_two_levels,
};
use raybook::accel::{Accel, Tests, grid::Grid, list::List, order};
use raybook::lab::heat::heat;
use raybook::lab::law::{Reach, mean_tests};
use raybook::lab::teapot_in_stadium::{camera, two_levels};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray};
use raybook::render::film::Film;
use raybook::scene::{soup::soup, stadium::stadium};
use raybook::shape::{mesh::Facet, teapot};
use rays::ray;
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
    let levels = grid.levels();
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
    order::by_first_use(&mut shapes, &mut named);
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

/// What the chapter is for: near the teapot in the stadium a uniform grid tests most of the teapot for each ray.
#[test]
fn the_teapot_in_the_stadium_costs_a_fraction_of_what_it_costs_in_a_grid() {
    let stadium = stadium(4);
    let film = Film {
        width: 48,
        height: 30,
        samples: 1,
        seed: 0,
        threads: 2,
        progress: &|_| {},
    };
    let camera = camera(film.aspect()).expect("it looks at the teapot");
    let cost = |tests: Tests| tests.boxes + tests.shapes;
    let ray = |place| camera.ray_through(place);
    let grid = Grid::of_facets(stadium.mesh.facets());
    let grid = cost(heat(&film, ray, &grid).tests());
    let [usual, fine] = [Densities::USUAL.coarse, 1.0].map(|coarse| {
        let two_levels = valid(two_levels(&stadium, coarse));
        cost(heat(&film, ray, &two_levels).tests())
    });
    println!("grid {grid}, two levels {usual}, with more coarse cells {fine}");
    assert!(10 * usual < 9 * grid, "two levels {usual}, the grid {grid}");
    assert!(
        5 * fine < grid,
        "with more coarse cells {fine}, the grid {grid}"
    );
}

/// In a soup, every coarse cell holds as much as every other, so this is a grid again: short rays cost the same whatever N.
#[test]
fn short_rays_in_a_soup_cost_the_same_with_any_number_of_triangles() {
    let costs =
        [1000, 10_000, 100_000].map(|n| mean_tests(n, Reach::Near, TwoLevelGrid::of_facets));
    println!("{costs:?}");
    for i in 0..2 {
        let (first, last) = (costs[0][i], costs[2][i]);
        assert!(
            (last / first - 1.0).abs() < 0.4,
            "from {first:.1} to {last:.1}"
        );
    }
}

proptest! {
    #[test]
    fn the_two_level_grid_agrees_with_the_list(
        corners in prop::collection::vec(prop::array::uniform3(prop::array::uniform3(-3_i8..4)), 0..40),
        from in prop::array::uniform3(-5_i8..6),
        to in prop::array::uniform3(-3_i8..4),
        scale in -6_i32..7,
    ) {
        // Whole numbers: corners lie in planes of the grid, and rays meet edges.
        let scale = 10.0_f32.powi(scale);
        let point = |p: [i8; 3]| scale * Vec3::from_array(p.map(f32::from));
        let facet = |(id, c): (u32, &[[i8; 3]; 3])| Facet { corners: c.map(point), id };
        let facets: Vec<_> = (0..).zip(&corners).map(facet).collect();
        let (from, to) = (point(from), point(to));
        prop_assume!(from != to);
        let ray = ray(from, to - from);
        let expected = List::new(facets.clone()).closest(&ray, Interval::AHEAD).map(|(_, hit)| hit.t);
        for grid in [TwoLevelGrid::of_facets(facets.clone()), TwoLevelGrid::new(facets)] {
            prop_assert_eq!(grid.validate(), Ok(()));
            let found = grid.closest(&ray, Interval::AHEAD).map(|(_, hit)| hit.t);
            let close = match (expected, found) {
                (Some(a), Some(b)) => (a - b).abs() <= 32.0 * f32::EPSILON * 10.0 * scale,
                (a, b) => a == b,
            };
            prop_assert!(close, "{:?} and not {:?}", found, expected);
            prop_assert_eq!(grid.any(&ray, Interval::AHEAD), found.is_some());
        }
    }

    #[test]
    fn rays_from_afar_find_what_the_list_finds(
        n in 1_u32..200,
        distance in 1.0_f32..1e5,
        aim in prop::array::uniform3(0.0_f32..1.0),
        direction in prop::array::uniform3(-1.0_f32..1.0),
    ) {
        let facets = soup(n, 9).facets();
        let direction = Dir3::new_or(Vec3::from(direction), Dir3::X);
        let ray = Ray::new(Vec3::from(aim) - distance * *direction, direction);
        let expected = List::new(facets.clone()).closest(&ray, Interval::AHEAD).map(|(_, hit)| hit);
        let found = TwoLevelGrid::of_facets(facets).closest(&ray, Interval::AHEAD).map(|(_, hit)| hit);
        prop_assert_eq!(found, expected);
    }
}
