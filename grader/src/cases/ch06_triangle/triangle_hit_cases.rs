//! The questions of `triangle_hit`.

use crate::{Edge, sample};
use raybook::math::{dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook_workbook::exercises::ch06_triangle::{TriangleHit, TriangleHitQuestion};
use glam::{Vec3, vec3};

/// The cases that are most often got wrong.
pub(super) fn edges() -> Vec<Edge<TriangleHit>> {
    let question = |origin, toward, within| TriangleHitQuestion {
        ray: sample::ray(origin, toward),
        within,
        p0: vec3(0.0, 0.0, 0.0),
        p1: vec3(2.0, 0.0, 0.0),
        p2: vec3(0.0, 2.0, 0.0),
    };
    let edge = |name, origin, toward, within| Edge::new(name, question(origin, toward, within));
    let (ahead, into) = (Interval::AHEAD, Vec3::NEG_Z);
    let above = |x, y| vec3(x, y, 3.0);
    let tiny = |q: TriangleHitQuestion| TriangleHitQuestion {
        p1: 1e-3 * q.p1,
        p2: 1e-3 * q.p2,
        ..q
    };
    let line = |q: TriangleHitQuestion| TriangleHitQuestion {
        p2: vec3(1.0, 0.0, 0.0),
        ..q
    };
    vec![
        edge("in the middle", above(0.5, 0.5), into, ahead),
        edge("from behind", vec3(0.5, 0.5, -3.0), Vec3::Z, ahead),
        edge("askew", vec3(2.0, 2.0, 3.0), vec3(-1.0, -1.5, -3.0), ahead),
        edge("near the second corner", above(1.75, 0.125), into, ahead),
        edge("past the long edge", above(1.5, 1.5), into, ahead),
        edge("left of it", above(-0.5, 0.5), into, ahead),
        edge("below it", above(0.5, -0.5), into, ahead),
        edge("it is behind the ray", above(0.5, 0.5), Vec3::Z, ahead),
        edge(
            "in the plane of the triangle",
            vec3(-1.0, 0.5, 0.0),
            Vec3::X,
            ahead,
        ),
        edge(
            "beyond the interval",
            above(0.5, 0.5),
            into,
            Interval::new(0.0, 2.0),
        ),
        edge(
            "before the interval",
            above(0.5, 0.5),
            into,
            Interval::new(4.0, 9.0),
        ),
        Edge::new(
            "a triangle of two millimetres",
            tiny(question(above(0.0005, 0.0005), into, ahead)),
        ),
        Edge::new(
            "three corners on a line",
            line(question(above(0.5, 0.0), into, ahead)),
        ),
    ]
}

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> TriangleHitQuestion {
    let [p0, p1, p2] = std::array::from_fn(|_| sample::point(rng, 3.0));
    let (b1, b2) = (
        sample::number(rng, -0.3, 0.8),
        sample::number(rng, -0.3, 0.8),
    );
    let aim = p0 + b1 * (p1 - p0) + b2 * (p2 - p0);
    let origin = aim - sample::number(rng, 1.0, 6.0) * *sample::direction(rng);
    let max = sample::end(rng, 0.2, 1.0, 5.0);
    let direction = Dir3::new_or(aim - origin, Dir3::X);
    TriangleHitQuestion {
        ray: Ray::new(origin, direction),
        within: Interval::new(0.0, max),
        p0,
        p1,
        p2,
    }
}
