//! The questions of `two_level_walk`.

use crate::{sample};
use raybook::math::{dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook_workbook::exercises::ch09_two_level_grid::{Resolution, TwoLevelWalk};
use glam::vec3;
use rand::RngExt;

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> TwoLevelWalk {
    let min = sample::point(rng, 3.0);
    let size = vec3(
        sample::number(rng, 2.0, 6.0),
        sample::number(rng, 2.0, 6.0),
        sample::number(rng, 2.0, 6.0),
    );
    let mut along = |least| rng.random_range(least..4_u32);
    let coarse = Resolution {
        nx: along(2),
        ny: along(1),
        nz: along(1),
    };
    let count = coarse.nx * coarse.ny * coarse.nz;
    let fine = (0..count)
        .map(|_| {
            let (nx, ny, nz) = (along(0), along(1), along(1));
            let some = u32::from(nx > 0);
            Resolution {
                nx,
                ny: ny * some,
                nz: nz * some,
            }
        })
        .collect();
    let inside = min + size * (sample::point(rng, 0.35) + 0.5);
    let origin = if rng.random_bool(0.3) {
        min + size * (sample::point(rng, 0.5) + 0.5)
    } else {
        inside + size.max_element() * 1.5 * *sample::direction(rng)
    };
    let end = if rng.random_bool(0.3) {
        size.max_element()
    } else {
        f32::INFINITY
    };
    TwoLevelWalk {
        ray: Ray::new(origin, Dir3::new_or(inside - origin, Dir3::X)),
        within: Interval::new(0.0, end),
        min,
        max: min + size,
        coarse,
        fine,
    }
}
