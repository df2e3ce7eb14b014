//! Every tree answers as the list does.

use crate::ch11_bvh::METHODS;
use crate::ch11_bvh::scenes::{asked, facets, scaled};
use glam::Vec3;
use proptest::prelude::*;
use rand::RngExt;
use raybook::accel::{Accel, bvh::Bvh, list::List};
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::scene::{soup::soup, terrain::terrain};
use raybook::shape::mesh::Facet;
use raybook::shape::{Shape, plane::Plane, sphere::Sphere, teapot};

/// Two hits at the same place may be found in either order; what is found must be as near, up to a number of roundings
/// of the scene's size.
const ROUNDINGS: f32 = 32.0 * (f32::EPSILON / 2.0);

/// What both say, if it is not the same.
fn differ<S: Shape>(
    list: &impl Accel<S>,
    tree: &impl Accel<S>,
    (ray, within): (&Ray, Interval),
    size: f32,
) -> Option<String> {
    let (right, got) = (list.closest(ray, within), tree.closest(ray, within));
    let same = match (&right, &got) {
        (None, None) => true,
        (Some((_, right)), Some((_, got))) => {
            right.id == got.id && right.t == got.t
                || (right.t - got.t).abs() <= ROUNDINGS * size.max(right.t)
        }
        _ => false,
    };
    let (right, got) = (right.map(|r| r.1), got.map(|g| g.1));
    let any = tree.any(ray, within) == right.is_some();
    (!same || !any).then(|| format!("{ray:?} {within:?}: {right:?}, the tree {got:?}, any {any}"))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn every_builders_tree_agrees_with_the_list(
        facets in facets(),
        asked in prop::collection::vec(asked(), 30),
        power in -6..=6_i32,
    ) {
        let scale = 10.0_f32.powi(power);
        let facets = scaled(&facets, scale);
        let list = List::new(facets.clone());
        for method in METHODS {
            let tree = Bvh::build(facets.clone(), method);
            prop_assert_eq!(tree.validate(), Ok(()), "{:?}", method);
            for (ray, within) in &asked {
                let ray = Ray::new(ray.origin * scale, ray.direction);
                let within = Interval::new(within.min * scale, within.max * scale);
                let said = differ(&list, &tree, (&ray, within), 3e3 * scale);
                prop_assert!(said.is_none(), "{method:?} of {}: {said:?}", facets.len());
            }
        }
    }
}

#[test]
fn trees_of_meshes_agree_with_the_list() {
    let mut rng = pcg::stream(11, 1);
    for (name, mesh) in [
        ("teapot", teapot::mesh(4)),
        ("terrain", terrain(16)),
        ("soup", soup(900, 1)),
    ] {
        let (center, size) = (mesh.bounds().center(), mesh.bounds().size());
        let mut point = || {
            let p = Vec3::from_array(std::array::from_fn(|_| rng.random::<f32>() - 0.5));
            center + 1.4 * p * size
        };
        let rays: Vec<_> = (0..4000)
            .map(|_| {
                let (from, to) = (point(), point());
                Ray::new(from, Dir3::new_or(to - from, Dir3::X))
            })
            .collect();
        let list = List::new(mesh.facets());
        let hits = rays.iter().filter(|ray| list.any(ray, Interval::AHEAD));
        assert!(hits.count() > 500, "{name}: the rays hit");
        for method in METHODS {
            let tree = Bvh::build(mesh.facets(), method);
            assert_eq!(tree.validate(), Ok(()), "{name} {method:?}");
            for ray in &rays {
                let said = differ(&list, &tree, (ray, Interval::AHEAD), size.max_element());
                assert_eq!(said, None, "{name} {method:?}");
            }
        }
    }
}

#[test]
fn shapes_without_an_end_are_searched_beside_the_tree() {
    let ground = Plane::through(Vec3::ZERO, Dir3::Y);
    let tree = Bvh::new(vec![ground; 3]);
    let down = Ray::new(Vec3::Y, -Dir3::Y);
    let (_, hit) = tree
        .closest(&down, Interval::AHEAD)
        .expect("the ground is below");
    assert_eq!(hit.t, 1.0, "a tree of planes only");
    assert!(tree.any(&down, Interval::AHEAD) && !tree.any(&down, Interval::new(0.0, 0.5)));
    assert_eq!(tree.validate(), Ok(()));
    let balls = Bvh::new(vec![
        Sphere::new(3.0 * Vec3::Y, 1.0),
        Sphere::new(-3.0 * Vec3::Y, 1.0),
    ]);
    let (ball, hit) = balls
        .closest(&down, Interval::AHEAD)
        .expect("a ball is below");
    assert_eq!(
        (ball.center.y, hit.t),
        (-3.0, 3.0),
        "shapes other than facets"
    );
}

#[test]
fn no_shapes_one_shape_and_a_thousand_equal_ones_work() {
    let facet = Facet {
        corners: [Vec3::ZERO, Vec3::X, Vec3::Y],
        id: 7,
    };
    let ray = Ray::new(Vec3::new(0.2, 0.2, 1.0), -Dir3::Z);
    for method in METHODS {
        for count in [0, 1, 2, 1000] {
            let tree = Bvh::build(vec![facet; count], method);
            assert_eq!(tree.validate(), Ok(()), "{method:?} of {count}");
            let hit = tree.closest(&ray, Interval::AHEAD).map(|(_, hit)| hit.id);
            assert_eq!(hit, (count > 0).then_some(7), "{method:?} of {count}");
        }
    }
}
