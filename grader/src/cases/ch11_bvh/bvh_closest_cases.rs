//! The questions of `bvh_closest`.

use super::tree;
use raybook::accel::bvh::build::Method;
use crate::{sample};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook_workbook::exercises::ch07_mesh::Corners;
use raybook_workbook::exercises::ch11_bvh::BvhClosest;
use raybook_workbook::tree_rows::BoxRow;
use glam::Vec3;

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> BvhClosest {
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
pub(super) fn question(triangles: &[[Vec3; 3]], ray: Ray, within: Interval) -> BvhClosest {
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
    BvhClosest {
        ray,
        within,
        triangles: in_order.collect(),
        nodes: tree.nodes,
    }
}
