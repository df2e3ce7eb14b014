//! The questions of `two_level_walk`.

use crate::{Edge, sample};
use raybook::math::{dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook_workbook::exercises::ch09_two_level_grid::{
    Resolution, TwoLevelWalk, TwoLevelWalkQuestion,
};
use glam::{Vec3, vec3};
use rand::RngExt;

/// The cases that are most often got wrong.
pub(super) fn edges() -> Vec<Edge<TwoLevelWalk>> {
    let cut = |nx, ny, nz| Resolution { nx, ny, nz };
    let q = |origin: Vec3, toward: Vec3, within| TwoLevelWalkQuestion {
        ray: Ray::new(origin, Dir3::new_or(toward, Dir3::X)),
        within,
        min: Vec3::ZERO,
        max: vec3(8.0, 8.0, 4.0),
        coarse: cut(2, 2, 1),
        fine: vec![cut(1, 1, 1), cut(4, 2, 2), cut(0, 0, 0), cut(2, 2, 1)],
    };
    let ahead = Interval::AHEAD;
    let from = vec3(-2.0, 1.0, 1.0);
    vec![
        Edge::new("along +x", q(from, Vec3::X, ahead)),
        Edge::new(
            "along −x, with −0.0",
            q(vec3(11.0, 1.0, 1.0), vec3(-1.0, -0.0, -0.0), ahead),
        ),
        Edge::new(
            "through an empty coarse cell",
            q(vec3(-1.0, 5.0, 1.0), vec3(1.0, 0.1, 0.0), ahead),
        ),
        Edge::new(
            "across, from the upper right",
            q(vec3(10.0, 9.0, 3.0), vec3(-1.0, -0.8, -0.1), ahead),
        ),
        Edge::new(
            "in the plane between coarse cells",
            q(vec3(4.0, -1.0, 1.0), Vec3::Y, ahead),
        ),
        Edge::new(
            "in a plane between fine cells",
            q(vec3(6.0, -1.0, 1.0), Vec3::Y, ahead),
        ),
        Edge::new(
            "through a corner of four coarse cells",
            q(vec3(8.5, 8.5, 1.0), vec3(-1.0, -1.0, 0.0), ahead),
        ),
        Edge::new(
            "from inside",
            q(vec3(5.5, 1.0, 3.0), vec3(1.0, 0.3, -0.4), ahead),
        ),
        Edge::new(
            "ends in the first coarse cell",
            q(from, vec3(1.0, 0.1, 0.1), Interval::new(0.0, 4.0)),
        ),
        Edge::new(
            "begins in the second coarse cell",
            q(from, vec3(1.0, 0.1, 0.1), Interval::new(7.0, 40.0)),
        ),
        Edge::new(
            "passes the grid by",
            q(vec3(-2.0, 9.0, 1.0), Vec3::X, ahead),
        ),
    ]
}

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> TwoLevelWalkQuestion {
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
    TwoLevelWalkQuestion {
        ray: Ray::new(origin, Dir3::new_or(inside - origin, Dir3::X)),
        within: Interval::new(0.0, end),
        min,
        max: min + size,
        coarse,
        fine,
    }
}
