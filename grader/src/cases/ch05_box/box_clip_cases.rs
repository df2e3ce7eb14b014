//! The questions of `box_clip`.

use crate::{sample};
use raybook::math::{dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook_workbook::exercises::ch05_box::BoxClip;
use glam::Vec3;

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> BoxClip {
    let (center, half) = (
        sample::point(rng, 3.0),
        Vec3::splat(1.25) + sample::point(rng, 1.0),
    );
    let origin = center + sample::point(rng, 5.0);
    let aim = center + sample::point(rng, 1.5) * half;
    let max = sample::end(rng, 0.3, 1.0, 8.0);
    BoxClip {
        ray: Ray::new(origin, Dir3::new_or(aim - origin, Dir3::X)),
        within: Interval::new(0.0, max),
        min: center - half,
        max: center + half,
    }
}
