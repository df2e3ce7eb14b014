//! Rays between the curves of a fan go where they would if they were followed themselves.

use glam::{DVec3, Vec3, dvec3, vec3};
use raybook::math::dir3::Dir3;
use raybook::render::curved::fan::Fan;
use raybook::render::curved::follow::{Fate, follow};
use raybook::render::curved::geodesic::between;
use raybook::render::curved::observer;
use raybook_common::rays::random_direction;
use std::ops::ControlFlow;

/// From curve to curve, in radians.
const APART: f64 = 4e-4;

/// The directions of some rays of an eye, no two alike.
fn directions() -> impl Iterator<Item = Dir3> {
    let mut rng = raybook::math::pcg::stream(21, 7);
    (0..3000).map(move |_| random_direction(&mut rng))
}

fn stepped(eye: Vec3, toward: Dir3) -> (Option<DVec3>, Vec<DVec3>) {
    let mut crossings = Vec::new();
    let fate = follow(
        observer::seen(eye.as_dvec3(), toward.as_dvec3()),
        1e-9,
        |piece| {
            if (piece.from.x.y > 0.0) != (piece.to.x.y > 0.0) {
                let (mut low, mut high) = (0.0, 1.0);
                for _ in 0..40 {
                    let middle = 0.5 * (low + high);
                    let at = between(&piece.from, &piece.to, piece.step, middle);
                    if (at.y > 0.0) == (piece.from.x.y > 0.0) {
                        low = middle;
                    } else {
                        high = middle;
                    }
                }
                crossings.push(between(&piece.from, &piece.to, piece.step, low));
            }
            ControlFlow::Continue(())
        },
    );
    let escapes = match fate {
        Fate::Escaped(toward) => Some(toward),
        _ => None,
    };
    (escapes, crossings)
}

#[test]
fn rays_escape_where_those_that_are_followed_do() {
    for eye in [vec3(0.0, 1.9, 17.0), vec3(2.0, -1.0, 0.5)] {
        let fan = Fan::new(eye, std::f64::consts::PI, APART);
        let (mut escaped, mut fell, mut other) = (0, 0, 0);
        for toward in directions() {
            match (stepped(eye, toward).0, fan.ray(toward).escapes()) {
                (None, None) => fell += 1,
                (Some(a), Some(b)) => {
                    escaped += 1;
                    // Next to the shadow's edge the sky is squeezed, and a curve's distance is much of it.
                    other += u32::from(a.angle_between(b) > APART);
                }
                _ => other += 1,
            }
        }
        assert!(escaped > 1000 && fell > 5, "{escaped} escape, {fell} fall");
        assert!(other <= 30, "{other} of 3000 go elsewhere, from {eye}");
    }
}

#[test]
fn rays_pass_through_a_plane_where_those_that_are_followed_do() {
    let eye = vec3(0.0, 1.9, 17.0);
    let fan = Fan::new(eye, std::f64::consts::PI, APART);
    let near = |p: &DVec3| p.length() < 12.0;
    let (mut same, mut other) = (0, 0);
    for toward in directions() {
        // Towards the hole: from afar, most directions lead past it.
        let toward = Dir3::new_or(-eye.normalize() + 0.5 * *toward, Dir3::Z);
        let followed = stepped(eye, toward).1.into_iter().find(near);
        let curve = fan.ray(toward).crossings(DVec3::Y).find(near);
        match (followed, curve) {
            (Some(a), Some(b)) => {
                // Where the ray grazes the plane, a small angle is a long way.
                let off = a.distance(b) / a.distance(eye.as_dvec3());
                same += u32::from(off < 5.0 * APART);
                other += u32::from(off >= 5.0 * APART);
            }
            (None, None) => {}
            _ => other += 1,
        }
    }
    assert!(same > 500, "{same} rays pass near the hole");
    assert!(other <= 15, "{other} of them elsewhere");
    let straight = dvec3(0.0, -1.9, -17.0);
    let middle = fan.ray(Dir3::new_or(straight.as_vec3(), Dir3::Z));
    assert!(middle.escapes().is_none(), "the middle is black");
}
