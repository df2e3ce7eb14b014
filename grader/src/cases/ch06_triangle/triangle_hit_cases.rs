//! The questions of `triangle_hit`.

use crate::{sample};
use raybook::math::{dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook_workbook::exercises::ch06_triangle::TriangleHit;

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> TriangleHit {
    let [p0, p1, p2] = std::array::from_fn(|_| sample::point(rng, 3.0));
    let (b1, b2) = (
        sample::number(rng, -0.3, 0.8),
        sample::number(rng, -0.3, 0.8),
    );
    let aim = p0 + b1 * (p1 - p0) + b2 * (p2 - p0);
    let origin = aim - sample::number(rng, 1.0, 6.0) * *sample::direction(rng);
    let max = sample::end(rng, 0.2, 1.0, 5.0);
    let direction = Dir3::new_or(aim - origin, Dir3::X);
    TriangleHit {
        ray: Ray::new(origin, direction),
        within: Interval::new(0.0, max),
        p0,
        p1,
        p2,
    }
}
