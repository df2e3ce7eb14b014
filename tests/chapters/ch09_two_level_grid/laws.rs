//! What a two-level grid finds, and what it costs.

use crate::ch09_two_level_grid::valid;
use crate::ch09_two_level_grid::whole::whole;
use glam::Vec3;
use proptest::prelude::*;
use raybook::accel::two_level_grid::{TwoLevelGrid, build::Densities};
use raybook::accel::{Accel, Tests, grid::Grid, list::List};
use raybook::camera::Camera;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::render::film::Film;
use raybook::scene::{soup::soup, stadium::stadium};
use raybook_chapters::ch09_two_level_grid::{
    teapot_in_stadium::camera, teapot_in_stadium::two_levels,
};
use raybook_chapters::shared::heat::heat;
use raybook_chapters::shared::{law::Reach, law::mean_tests};

/// What the chapter is for: near the teapot in the stadium a uniform grid tests most of the teapot for each ray.
#[test]
fn the_teapot_in_the_stadium_costs_a_fraction_of_what_it_costs_in_a_grid() {
    let stadium = stadium(4);
    let film = Film {
        threads: 2,
        ..Film::new(48, 30, 1)
    };
    let camera = camera(film.aspect()).expect("it looks at the teapot");
    let cost = |tests: Tests| tests.boxes + tests.shapes;
    let ray = |place| camera.central_ray(place);
    let grid = Grid::of_facets(stadium.mesh.facets());
    let grid = cost(heat(&film, ray, &grid).tests());
    let [usual, fine] = [Densities::USUAL.coarse, 1.0].map(|coarse| {
        let two_levels = valid(two_levels(&stadium.mesh, coarse));
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
    fn the_two_level_grid_agrees_with_the_list(whole in whole()) {
        for grid in [TwoLevelGrid::of_facets(whole.facets.clone()), TwoLevelGrid::new(whole.facets.clone())] {
            prop_assert_eq!(grid.validate(), Ok(()));
            whole.agrees(&grid)?;
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
        // Of several facets at the same distance, and from afar many are, each may be the answer.
        let expected = List::new(facets.clone()).closest(&ray, Interval::AHEAD).map(|(_, hit)| hit.t);
        let found = TwoLevelGrid::of_facets(facets).closest(&ray, Interval::AHEAD).map(|(_, hit)| hit.t);
        prop_assert_eq!(found, expected);
    }
}
