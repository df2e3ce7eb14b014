//! The questions of `bvh_closest`.

use super::tree;
use raybook::accel::bvh::build::Method;
use crate::{Edge, sample};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook_workbook::exercises::ch07_mesh::Corners;
use raybook_workbook::exercises::ch11_bvh::{BvhClosest, BvhClosestQuestion};
use raybook_workbook::tree_rows::BoxRow;
use glam::{Vec3, vec3};

/// The cases that are most often got wrong.
pub(super) fn edges() -> Vec<Edge<BvhClosest>> {
    let wall = |z: f32| [vec3(-2.0, -2.0, z), vec3(2.0, -2.0, z), vec3(0.0, 3.0, z)];
    let walls = |zs: &[f32], ray, within| {
        question(
            &zs.iter().map(|&z| wall(z)).collect::<Vec<_>>(),
            ray,
            within,
        )
    };
    let ray = sample::ray(Vec3::ZERO, Vec3::Z);
    let ahead = Interval::AHEAD;
    let row = [2.0, 4.0, 6.0, 8.0, 10.0, 12.0, 14.0, 16.0];
    let minus_zero = sample::ray(Vec3::ZERO, vec3(-0.0, -0.0, 1.0));
    let slanted = |z: f32| {
        [
            vec3(-2.0, -2.0, z - 3.0),
            vec3(2.0, -2.0, z - 3.0),
            vec3(0.0, 3.0, z + 4.0),
        ]
    };
    vec![
        Edge::new("eight walls ahead", walls(&row, ray, ahead)),
        Edge::new(
            "eight walls, from the other end",
            walls(
                &row,
                sample::ray(vec3(0.0, 0.0, 18.0), vec3(0.0, 0.0, -1.0)),
                ahead,
            ),
        ),
        Edge::new(
            "from between the walls",
            walls(&row, sample::ray(vec3(0.0, 0.0, 9.0), Vec3::Z), ahead),
        ),
        Edge::new(
            "past the walls",
            walls(&row, sample::ray(vec3(5.0, 0.0, 0.0), Vec3::Z), ahead),
        ),
        Edge::new(
            "the interval ends before the walls",
            walls(&row, ray, Interval::new(0.0, 1.0)),
        ),
        Edge::new(
            "the interval begins behind some walls",
            walls(&row, ray, Interval::new(5.0, 30.0)),
        ),
        Edge::new("a direction with two −0", walls(&row, minus_zero, ahead)),
        Edge::new("one leaf is all", walls(&[3.0], ray, ahead)),
        Edge::new(
            "the nearer box has the farther hit",
            question(
                &[slanted(4.0), slanted(4.5), wall(3.0), wall(3.5)],
                ray,
                ahead,
            ),
        ),
    ]
}

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> BvhClosestQuestion {
    let triangles = (0..24).map(|_| {
        let center = sample::point(rng, 2.0);
        std::array::from_fn(|_| center + sample::point(rng, 1.0))
    });
    let triangles: Vec<_> = triangles.collect();
    let origin = sample::point(rng, 4.0);
    let toward = sample::point(rng, 1.5) - origin;
    let end = sample::end(rng, 0.2, 2.0, 5.0);
    let ray = Ray::new(origin, Dir3::new_or(toward, Dir3::X));
    question(&triangles, ray, Interval::new(0.0, end))
}

/// The question about triangles in a tree of small leaves.
pub(super) fn question(triangles: &[[Vec3; 3]], ray: Ray, within: Interval) -> BvhClosestQuestion {
    let boxes: Vec<_> = triangles
        .iter()
        .map(|&corners| {
            let Aabb { min, max } = Aabb::of(corners);
            BoxRow { min, max }
        })
        .collect();
    let tree = tree(&boxes, Method::Binned, 2);
    let in_order = tree.order.iter().map(|&i| {
        let [p0, p1, p2] = triangles[i as usize];
        Corners { p0, p1, p2 }
    });
    BvhClosestQuestion {
        ray,
        within,
        triangles: in_order.collect(),
        nodes: tree.nodes,
    }
}
