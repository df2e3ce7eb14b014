//! Triangles are in all cells that they reach, and in few others; and how many cells there are.

use crate::ch08_grid::polygon::clipped;
use glam::{DVec3, UVec3, Vec3, uvec3, vec3};
use proptest::prelude::*;
use raybook::accel::grid::Grid;
use raybook::inside::grid::{
    Lattice, grid_resolution, range, triangle_meets_box, voxels_of_triangle,
};
use raybook::math::aabb::Aabb;
use raybook::shape::mesh::Facet;

/// Whether a triangle meets a box: the triangle is clipped by the planes of the box, in double precision.
fn meets(corners: [Vec3; 3], bounds: &Aabb, margin: f64) -> bool {
    let mut polygon: Vec<DVec3> = corners.map(Vec3::as_dvec3).to_vec();
    for axis in 0..3 {
        let (low, high) = (
            f64::from(bounds.min[axis]) - margin,
            f64::from(bounds.max[axis]) + margin,
        );
        polygon = clipped(&polygon, |p| p[axis] - low);
        polygon = clipped(&polygon, |p| high - p[axis]);
    }
    !polygon.is_empty()
}

fn corner() -> impl Strategy<Value = Vec3> {
    let quarter = || (-8..9_i16).prop_map(|i| 0.25 * f32::from(i));
    prop_oneof![
        (quarter(), quarter(), quarter()).prop_map(|(x, y, z)| vec3(x, y, z)),
        prop::array::uniform3(-2.0_f32..2.0).prop_map(Vec3::from),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn overlap_never_says_a_wrong_no_and_hardly_a_wrong_yes(
        corners in [corner(), corner(), corner()],
        low in corner(),
        size in prop::array::uniform3(0.01_f32..2.0),
        scale in prop_oneof![Just(1.0_f32), Just(1e-15), Just(1e15), Just(1e-6), Just(1e6)],
    ) {
        let corners = corners.map(|p| scale * p);
        let bounds = Aabb { min: scale * low, max: scale * (low + Vec3::from(size)) };
        let (found, hair) = (triangle_meets_box(&corners, &bounds), f64::from(scale) * 1e-5);
        prop_assert!(found || !meets(corners, &bounds, 0.0), "a wrong no is a hole");
        prop_assert!(!found || meets(corners, &bounds, hair), "a wrong yes by more than a hair");
    }

    #[test]
    fn a_triangle_is_in_the_cells_that_it_meets(
        corners in [corner(), corner(), corner()],
        resolution in prop::array::uniform3(1_u32..9),
        margin in prop_oneof![Just(0.0_f32), 0.0_f32..0.2],
    ) {
        let bounds = Aabb { min: Vec3::splat(-1.5), max: vec3(1.5, 1.0, 2.0) };
        let lattice = Lattice::new(&bounds, resolution.into());
        let voxels = voxels_of_triangle(&lattice, margin, &corners);
        for cell in range(UVec3::ZERO, lattice.resolution - 1) {
            let cell_box = lattice.bounds_of(cell, cell);
            let found = voxels.contains(&cell);
            let far = f64::from(margin) + 1e-5;
            let near = f64::from(margin) - 1e-5;
            prop_assert!(found || !meets(corners, &cell_box, near), "cell {} is missing", cell);
            prop_assert!(!found || meets(corners, &cell_box, far), "cell {} is too much", cell);
        }
    }

    #[test]
    fn the_cells_are_about_as_many_as_asked_for_and_about_cubes(
        extents in prop::array::uniform3(prop_oneof![0.1_f32..10.0, Just(0.0), 1e-5_f32..1e-3]),
        shapes in 1_usize..200_000,
        density in 0.2_f32..20.0,
    ) {
        let extents = Vec3::from(extents);
        let n = grid_resolution(extents, shapes, density);
        let (asked, cells) = (density * shapes as f32, n.as_vec3().element_product());
        prop_assert!(n.min_element() >= 1);
        prop_assume!(asked > 1000.0 && extents.max_element() > 0.0);
        // Each of three numbers between 1 and 2 is rounded by up to a third.
        prop_assert!((0.25..4.0).contains(&(cells / asked)), "{} cells of {}", cells, asked);
        let sides: Vec<_> = (0..3).filter(|&i| n[i] > 3).map(|i| extents[i] / n[i] as f32).collect();
        for a in &sides {
            prop_assert!(sides.iter().all(|b| a / b < 1.4), "sides {:?}", sides);
        }
    }
}

#[test]
fn strange_scenes_make_sound_grids() {
    let triangle = |corners: [[f32; 3]; 3]| Facet {
        corners: corners.map(Vec3::from),
        id: 0,
    };
    let large = triangle([[-1.0, -1.0, -1.0], [1.0, -0.9, 1.0], [0.0, 1.0, 0.5]]);
    let scenes = [
        ("nothing", vec![]),
        ("one triangle", vec![large]),
        ("a thousand equal ones", vec![large; 1000]),
        ("a point", vec![triangle([[0.0; 3]; 3]); 5]),
        ("a point far away", vec![triangle([[1e6, -1e6, 3.0]; 3]); 5]),
        (
            "flat",
            vec![triangle([[0.0, 2.0, 0.0], [1.0, 2.0, 0.0], [0.0, 2.0, 5.0]]); 9],
        ),
        (
            "a grain at a million",
            vec![triangle([[1e6, 0.0, 0.0], [1e6, 0.1, 0.0], [1e6, 0.0, 0.1]]); 9],
        ),
        (
            "as large as can be",
            vec![triangle([[-9e17, 0.0, 0.0], [9e17, 1e17, 0.0], [0.0, 9e17, -9e17]]); 3],
        ),
        (
            "not a number",
            vec![
                triangle([[f32::NAN, 0.0, f32::INFINITY], [0.0; 3], [1.0; 3]]),
                large,
            ],
        ),
    ];
    for (name, facets) in scenes {
        let count = facets.len();
        for grid in [
            Grid::of_facets(facets.clone()),
            Grid::new(facets.clone()),
            Grid::of_facets_with_resolution(facets.clone(), uvec3(0, 3, 4_000_000_000)),
        ] {
            assert_eq!(grid.validate(), Ok(()), "{name}");
            assert!(
                grid.bytes() < 1 << 29,
                "{name}: {} bytes for {count} triangles",
                grid.bytes()
            );
        }
    }
}
