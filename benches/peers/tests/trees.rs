//! What trees cost: by hand, and as the library says.

use glam::{Vec3, vec3};
use raybook::accel::{bvh::Bvh, wide_bvh::WideBvh};
use raybook::math::aabb::Aabb;
use raybook::shape::teapot;
use raybook_peers::sah::{Inside, Sah};
use raybook_peers::trees;

/// Two unit cubes side by side in a box: half of its surface area is 5, and half of theirs 3.
#[test]
fn two_cubes_cost_what_their_areas_say() {
    let cube = |x: f32| Aabb::new(vec3(x, 0.0, 0.0), vec3(x + 1.0, 1.0, 1.0));
    let root = cube(0.0).union(&cube(1.0));
    let nodes = [
        (root, Inside::Children(2)),
        (cube(0.0), Inside::Triangles(4)),
        (cube(1.0), Inside::Triangles(5)),
    ];
    let expected = Sah {
        nodes: 1.0,
        boxes: 2.0,
        leaves: 2.0 * 3.0 / 5.0,
        blocks: 3.0 / 5.0 + 2.0 * 3.0 / 5.0,
        triangles: (4.0 + 5.0) * 3.0 / 5.0,
    };
    let sah = Sah::of(&root, &nodes).expect("it has a surface");
    for (is, should) in [
        (sah.nodes, expected.nodes),
        (sah.boxes, expected.boxes),
        (sah.leaves, expected.leaves),
        (sah.blocks, expected.blocks),
        (sah.triangles, expected.triangles),
    ] {
        assert!((is - should).abs() < 1e-12, "{sah:?}, not {expected:?}");
    }
}

#[test]
fn a_tree_without_a_surface_costs_nothing_that_could_be_told() {
    assert_eq!(Sah::of(&Aabb::new(Vec3::ZERO, Vec3::ONE), &[]), None);
    let point = Aabb::of([Vec3::ONE]);
    assert_eq!(Sah::of(&point, &[(point, Inside::Triangles(1))]), None);
}

/// With a node for 1 and a triangle for 1, which are the library's prices.
#[test]
fn bvh_costs_what_the_library_says() {
    let mesh = teapot::mesh(4);
    let bvh = Bvh::new(mesh.facets());
    let sah = Sah::of(&mesh.bounds(), &trees::binary(&bvh)).expect("it has a surface");
    let (here, there) = (sah.nodes + sah.triangles, f64::from(bvh.sah_cost()));
    // The library sums in single precision what is summed here in double precision.
    assert!((here / there - 1.0).abs() < 1e-5, "{here}, not {there}");
}

#[test]
fn wide_tree_opens_fewer_nodes_than_the_binary_one_and_tests_all_triangles() {
    let mesh = teapot::mesh(4);
    let (bvh, wide) = (Bvh::new(mesh.facets()), WideBvh::new(mesh.facets()));
    let nodes = trees::wide(&wide, mesh.bounds());
    let triangles = nodes.iter().map(|(_, inside)| match inside {
        Inside::Children(_) => 0,
        Inside::Triangles(count) => *count,
    });
    assert_eq!(triangles.sum::<usize>(), mesh.triangles().len());
    let of = |nodes: &[_]| Sah::of(&mesh.bounds(), nodes).expect("it has a surface");
    let (of_wide, of_binary) = (of(&nodes), of(&trees::binary(&bvh)));
    assert!(
        of_wide.nodes < 0.5 * of_binary.nodes,
        "{of_wide:?} beside {of_binary:?}"
    );
}
