//! The fisheye: where its disc ends, and what each projection keeps.

use glam::{Vec2, Vec3, vec2};
use rand::RngExt;
use raybook::camera::Camera;
use raybook::camera::fisheye::{Fisheye, Projection};
use raybook::camera::pose::Pose;
use raybook::light::environment::{angular::Angular, convert::Layout};
use raybook::math::pcg;
use std::f32::consts::PI;

fn fisheye(projection: Projection, view: f32, aspect: f32) -> Fisheye {
    Fisheye::new(Pose::level(Vec3::ZERO), projection, view, aspect).expect("it can be shown")
}

/// The angle to forward, in radians, of a place on the film.
fn angle(camera: &Fisheye, film: Vec2) -> Option<f32> {
    let d = camera.direction(film)?;
    Some(vec2(d.x, d.y).length().atan2(-d.z))
}

#[test]
fn the_middle_looks_ahead_and_the_rim_is_half_of_the_view_away() {
    for projection in Projection::ALL {
        for view in [1.0, 60.0, 179.0, projection.widest()] {
            let camera = fisheye(projection, view, 1.0);
            let middle = angle(&camera, Vec2::splat(0.5));
            assert_eq!(middle, Some(0.0), "{projection:?}: the middle is forward");
            let rim = angle(&camera, vec2(0.5, 0.0)).expect("the disc touches the top edge");
            let expected = 0.5 * view.to_radians();
            // The sine is flat at its top: an orthographic rim has lost half of its digits.
            assert!(
                (rim - expected).abs() < 1e-3,
                "{projection:?}, {view}°: the rim is {rim} away, not {expected}"
            );
        }
    }
}

#[test]
fn up_is_up_and_right_is_right() {
    for projection in Projection::ALL {
        let camera = fisheye(projection, 120.0, 1.0);
        let at = |x, y| camera.direction(vec2(x, y)).expect("inside");
        assert!(
            at(0.5, 0.3).y > 0.1,
            "{projection:?}: above the middle is up"
        );
        assert!(at(0.7, 0.5).x > 0.1, "{projection:?}: right of it is right");
    }
}

#[test]
fn beside_the_disc_there_is_no_ray_and_in_it_there_always_is_one() {
    let mut rng = pcg::stream(203, 0);
    for projection in Projection::ALL {
        for aspect in [0.5, 1.0, 16.0 / 9.0] {
            let camera = fisheye(projection, projection.widest(), aspect);
            let mut inside = 0;
            for _ in 0..20_000 {
                let film: Vec2 = vec2(rng.random(), rng.random());
                let p = (film - 0.5) * vec2(aspect, 1.0) / (0.5 * aspect.min(1.0));
                if (p.length() - 1.0).abs() < 1e-5 {
                    continue; // rounding may put it on either side
                }
                let seen = camera.sees(film);
                assert_eq!(
                    seen,
                    p.length() < 1.0,
                    "{projection:?}, aspect {aspect}: at {film}"
                );
                inside += usize::from(seen);
            }
            // The disc is π/4 of the square that the shorter edges leave it.
            let share = PI / 4.0 * aspect.min(1.0 / aspect);
            let found = inside as f32 / 20_000.0;
            assert!(
                (found - share).abs() < 0.02,
                "{projection:?}, aspect {aspect}: the disc is {found} of the film, not {share}"
            );
        }
    }
}

#[test]
fn the_angle_of_a_radius_is_the_inverse_of_the_radius_of_an_angle() {
    for projection in Projection::ALL {
        let widest = 0.5 * projection.widest().to_radians();
        for i in 0..=100 {
            let theta = 0.99 * widest * i as f32 / 100.0;
            let back = projection.angle(projection.radius(theta));
            assert!(
                (back - theta).abs() < 1e-4,
                "{projection:?}: {theta} comes back as {back}"
            );
        }
    }
}

/// dr/dθ and r/sin θ: how long a small step outwards is on the film, and a small step around.
fn scales(projection: Projection, theta: f32) -> (f32, f32) {
    let step = 1e-2;
    let [near, far] = [theta - step, theta + step].map(|theta| projection.radius(theta));
    (
        (far - near) / (2.0 * step),
        projection.radius(theta) / theta.sin(),
    )
}

#[test]
fn each_projection_keeps_what_it_promises() {
    for i in 1..30 {
        let theta = 0.05 * i as f32;
        let close = |a: f32, b: f32, what: &str| {
            assert!(
                (a / b - 1.0).abs() < 1e-3,
                "{what} at θ = {theta}: {a} and {b}"
            );
        };
        let (out, _) = scales(Projection::Equidistant, theta);
        close(out, 1.0, "a step outwards");
        let (out, around) = scales(Projection::Equisolid, theta);
        close(out * around, 1.0, "the area of a solid angle");
        let (out, around) = scales(Projection::Stereographic, theta);
        close(out, around, "a small circle's two diameters");
        let (out, around) = scales(Projection::Orthographic, theta);
        close(out * around, theta.cos(), "the area of a solid angle");
    }
}

#[test]
fn no_two_projections_keep_the_same() {
    let theta = 1.2;
    let products = Projection::ALL.map(|projection| {
        let (out, around) = scales(projection, theta);
        (out * around, out / around)
    });
    for (i, a) in products.iter().enumerate() {
        for b in &products[..i] {
            let apart = (a.0 - b.0).abs().max((a.1 - b.1).abs());
            assert!(
                apart > 0.1,
                "{a:?} and {b:?} are told apart by the test above"
            );
        }
    }
}

#[test]
fn an_equidistant_fisheye_of_360_degrees_is_the_angular_map() {
    let camera = fisheye(Projection::Equidistant, 360.0, 1.0);
    let mut rng = pcg::stream(204, 0);
    let mut compared = 0;
    for _ in 0..10_000 {
        let film = vec2(rng.random(), rng.random());
        let (seen, expected) = (camera.direction(film), Angular.direction(film));
        if let (Some(seen), Some(expected)) = (seen, expected) {
            let off = seen.distance(*expected);
            assert!(off < 2e-6, "at {film}: {seen:?}, not {expected:?}");
            compared += 1;
        }
    }
    assert!(
        compared > 7500,
        "π/4 of all places are on the disc: {compared}"
    );
}

#[test]
fn views_that_cannot_be_are_errors_for_people() {
    let pose = Pose::level(Vec3::ZERO);
    for projection in Projection::ALL {
        let too_wide = projection.widest() + 0.1;
        for view in [0.0, -90.0, too_wide, f32::INFINITY, f32::NAN] {
            let error = Fisheye::new(pose, projection, view, 1.0).expect_err("no such view");
            let said = error.to_string();
            let widest = projection.widest().to_string();
            assert!(
                said.contains(&format!("{view}°")) && said.contains(&widest),
                "it says what was asked for and what is possible: {said}"
            );
        }
    }
}
