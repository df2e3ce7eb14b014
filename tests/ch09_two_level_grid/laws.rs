//! What a two-level grid finds, and what it costs.

use crate::rays::ray;
use crate::valid;
use glam::Vec3;
use proptest::prelude::*;
use raybook::accel::two_level_grid::{TwoLevelGrid, build::Densities};
use raybook::accel::{Accel, Tests, grid::Grid, list::List};
use raybook::lab::heat::heat;
use raybook::lab::law::{Reach, mean_tests};
use raybook::lab::teapot_in_stadium::{camera, two_levels};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::render::film::Film;
use raybook::scene::{soup::soup, stadium::stadium};
use raybook::shape::mesh::Facet;

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
    for (first, last) in costs[0].into_iter().zip(costs[2]) {
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
