//! Chapter 7: the search through a list.

use glam::{Vec3, vec3};
use proptest::prelude::*;
use raybook::accel::{Accel, Meshed, Tests, list::List};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::{Shape, mesh::Mesh, sphere::Sphere};

#[test]
fn the_nearest_is_found_wherever_it_is_in_the_list() {
    let ball = |z: f32| Sphere::new(vec3(0.0, 0.0, z), 1.0);
    let ray = Ray::new(Vec3::ZERO, -Dir3::Z);
    for order in [
        [-5.0, -10.0, -15.0],
        [-10.0, -5.0, -15.0],
        [-15.0, -10.0, -5.0],
    ] {
        let list = List::new(order.map(ball).to_vec());
        let (nearest, hit) = list.closest(&ray, Interval::AHEAD).expect("all are ahead");
        assert_eq!(
            (nearest.center.z, hit.t),
            (-5.0, 4.0),
            "in the order {order:?}"
        );
        let beyond = list
            .closest(&ray, Interval::new(7.0, 13.0))
            .expect("one lies between");
        assert_eq!(beyond.1.t, 9.0, "the interval leaves out what is nearer");
        assert_eq!(
            list.closest(&ray, Interval::new(0.0, 4.0)),
            None,
            "and is open at its end"
        );
    }
}

#[test]
fn every_shape_is_tested_once() {
    let list = List::new(vec![Sphere::new(Vec3::ZERO, 1.0); 7]);
    for ray in [
        Ray::new(vec3(0.0, 0.0, 5.0), -Dir3::Z),
        Ray::new(vec3(0.0, 9.0, 5.0), -Dir3::Z),
    ] {
        let mut tests = Tests::default();
        list.closest_counted(&ray, Interval::AHEAD, &mut tests);
        assert_eq!(
            tests,
            Tests {
                boxes: 0,
                shapes: 7
            },
            "hit or miss, a list asks all"
        );
    }
}

#[test]
fn of_equal_distances_the_first_stays() {
    let mesh = Mesh::new(
        vec![Vec3::ZERO, Vec3::X, Vec3::Z],
        vec![[0, 2, 1]; 3],
        None,
        None,
    )
    .expect("sound");
    let hit = Meshed::new(mesh, List::new)
        .hit(&Ray::new(vec3(0.2, 5.0, 0.2), -Dir3::Y), Interval::AHEAD)
        .expect("it hits all three");
    assert_eq!(
        hit.id, 0,
        "three triangles at the same place: the first counts"
    );
}

proptest! {
    #[test]
    fn the_list_agrees_with_a_search_by_hand(
        balls in prop::collection::vec((prop::array::uniform3(-4.0_f32..4.0), 0.2_f32..2.0), 0..12),
        aim in prop::array::uniform3(-3.0_f32..3.0),
        max in 1.0_f32..12.0,
    ) {
        let shapes: Vec<_> = balls.into_iter().map(|(c, r)| Sphere::new(c.into(), r)).collect();
        let from = vec3(0.0, 0.0, 6.0);
        let ray = Ray::new(from, Dir3::new_or(Vec3::from(aim) - from, Dir3::X));
        let within = Interval::new(0.5, max);
        let hits = shapes.iter().filter_map(|s| s.hit(&ray, within));
        let by_hand = hits.min_by(|a, b| a.t.total_cmp(&b.t));
        let list = List::new(shapes.clone());
        prop_assert_eq!(list.closest(&ray, within).map(|(_, hit)| hit), by_hand);
        prop_assert_eq!(list.any(&ray, within), by_hand.is_some());
        if let Some((shape, hit)) = list.closest(&ray, within) {
            prop_assert_eq!(shape.hit(&ray, within), Some(hit), "the hit belongs to the shape that comes with it");
        }
    }
}
