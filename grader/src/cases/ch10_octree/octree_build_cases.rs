//! The questions of `octree_build`.

use crate::{sample};
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch05_box::Corners;
use raybook_workbook::exercises::ch10_octree::OctreeBuild;
use glam::Vec3;
use rand::RngExt;

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> OctreeBuild {
    let min = sample::point(rng, 3.0);
    let size = sample::number(rng, 1.0, 4.0);
    // Half of the shapes in one corner, so that depth matters.
    let crowd = min + size * Vec3::splat(sample::number(rng, 0.1, 0.6));
    let shapes = (0..rng.random_range(6..11))
        .map(|i| {
            let anywhere = min + size * (0.9 * (sample::point(rng, 0.5) + 0.5));
            let near = crowd + size * (0.1 * (sample::point(rng, 0.5) + 0.5));
            let least = if i % 2 == 0 { near } else { anywhere };
            let extent = size * 0.08 * (sample::point(rng, 0.5) + 0.5);
            Corners {
                min: least,
                max: least + extent,
            }
        })
        .collect();
    OctreeBuild {
        min,
        max: min + size,
        opening: 1.0,
        copies: [1.2, 2.0, 8.0][rng.random_range(0..3_usize)],
        depth: rng.random_range(1..4),
        shapes,
    }
}
