//! The questions of `box_clip`.

use crate::{Edge, sample};
use raybook::math::{dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook_workbook::exercises::ch05_box::{BoxClip, BoxClipQuestion};
use glam::{Vec3, vec3};

/// The cases that are most often got wrong.
pub(super) fn edges() -> Vec<Edge<BoxClip>> {
    let question = |origin, toward, within| BoxClipQuestion {
        ray: sample::ray(origin, toward),
        within,
        min: vec3(1.0, -1.0, -2.0),
        max: vec3(3.0, 1.0, 2.0),
    };
    let edge = |name, origin, toward, within| Edge::new(name, question(origin, toward, within));
    let ahead = Interval::AHEAD;
    let flat = |q: BoxClipQuestion| BoxClipQuestion {
        max: vec3(3.0, -1.0, 2.0),
        ..q
    };
    vec![
        edge("straight through along x", Vec3::ZERO, Vec3::X, ahead),
        edge(
            "straight through the other way",
            vec3(5.0, 0.0, 0.0),
            Vec3::NEG_X,
            ahead,
        ),
        edge(
            "from inside",
            vec3(2.0, 0.0, 0.0),
            vec3(1.0, 1.0, 0.0),
            ahead,
        ),
        edge("the box is behind", Vec3::ZERO, Vec3::NEG_X, ahead),
        edge("beside it, parallel", vec3(0.0, 3.0, 0.0), Vec3::X, ahead),
        edge(
            "beside it, parallel, with a negative zero",
            vec3(0.0, 3.0, 0.0),
            vec3(1.0, -0.0, -0.0),
            ahead,
        ),
        edge(
            "through it with a negative zero",
            Vec3::ZERO,
            vec3(1.0, -0.0, 0.0),
            ahead,
        ),
        edge("in a face", vec3(0.0, 1.0, 0.0), Vec3::X, ahead),
        edge("askew", vec3(0.0, 0.5, -3.0), vec3(1.0, -0.25, 2.0), ahead),
        edge("just past a corner", Vec3::ZERO, vec3(1.0, 1.1, 0.0), ahead),
        edge(
            "the interval ends inside",
            Vec3::ZERO,
            Vec3::X,
            Interval::new(0.0, 2.5),
        ),
        edge(
            "the interval ends before it",
            Vec3::ZERO,
            Vec3::X,
            Interval::new(0.0, 0.5),
        ),
        Edge::new(
            "a flat box",
            flat(question(vec3(2.0, 4.0, 0.0), Vec3::NEG_Y, ahead)),
        ),
    ]
}

/// An ordinary question.
pub(super) fn random(rng: &mut Pcg) -> BoxClipQuestion {
    let (center, half) = (
        sample::point(rng, 3.0),
        Vec3::splat(1.25) + sample::point(rng, 1.0),
    );
    let origin = center + sample::point(rng, 5.0);
    let aim = center + sample::point(rng, 1.5) * half;
    let max = sample::end(rng, 0.3, 1.0, 8.0);
    BoxClipQuestion {
        ray: Ray::new(origin, Dir3::new_or(aim - origin, Dir3::X)),
        within: Interval::new(0.0, max),
        min: center - half,
        max: center + half,
    }
}
