//! The pin-hole camera: its axes, its pixels, and what it refuses.

use super::ROUNDING;
use glam::{Vec2, Vec3, vec2, vec3};
use raybook::camera::{
    Camera,
    pinhole::{LookAtError, PLANE_HEIGHT, Pinhole},
};

/// A camera somewhere, that looks somewhere, and not straight.
fn camera() -> Pinhole {
    let from = vec3(1.0, 2.0, 3.0);
    Pinhole::look_at(from, vec3(-4.0, 0.5, -2.0), vec3(0.1, 1.0, 0.2), 0.03, 1.5)
        .expect("this up is not parallel to the view")
}

#[test]
fn camera_axes_are_orthonormal_and_right_handed() {
    let camera = camera();
    let (right, up, forward) = (*camera.right, *camera.up, *camera.forward);
    for (a, b) in [(right, up), (up, forward), (forward, right)] {
        assert!(
            a.dot(b).abs() < ROUNDING,
            "{a} and {b} are square to each other"
        );
    }
    // right, up and *backward* are x, y and z of the camera: a right-handed system.
    assert!(
        right.cross(up).distance(-forward) < ROUNDING,
        "right × up = backward"
    );
    assert!(
        up.dot(vec3(0.1, 1.0, 0.2)) > 0.0,
        "up is on the side that was asked for"
    );
    let toward = vec3(-5.0, -1.5, -5.0);
    assert!(
        forward.distance(toward.normalize()) < ROUNDING,
        "forward is from `from` to `to`"
    );
}

#[test]
fn looking_along_minus_z_makes_the_axes_those_of_the_world() {
    let camera = Pinhole::look_at(Vec3::ZERO, -Vec3::Z, Vec3::Y, 0.05, 1.0).expect("it can");
    assert_eq!(*camera.right, Vec3::X, "x is to the right");
    assert_eq!(*camera.up, Vec3::Y, "y is up");
    assert_eq!(*camera.forward, -Vec3::Z, "the view is along −z");
}

#[test]
fn the_middle_of_the_film_sees_the_point_looked_at() {
    let ray = camera().central_ray(Vec2::splat(0.5));
    assert_eq!(
        ray.origin,
        vec3(1.0, 2.0, 3.0),
        "every ray starts at the focal point"
    );
    let t = ray.origin.distance(vec3(-4.0, 0.5, -2.0));
    let missed = ray.at(t).distance(vec3(-4.0, 0.5, -2.0));
    assert!(
        missed < t * ROUNDING,
        "the ray passes the point at a distance of {missed} m"
    );
}

#[test]
fn film_0_0_is_the_top_left() {
    let camera = Pinhole::look_at(Vec3::ZERO, -Vec3::Z, Vec3::Y, 0.05, 2.0).expect("it can");
    for (corner, name, x, y) in [
        (vec2(0.0, 0.0), "top left", -1.0, 1.0),
        (vec2(1.0, 0.0), "top right", 1.0, 1.0),
        (vec2(0.0, 1.0), "bottom left", -1.0, -1.0),
        (vec2(1.0, 1.0), "bottom right", 1.0, -1.0),
    ] {
        let d = camera.central_ray(corner).direction;
        // The corner of a plane of 48 mm × 24 mm, 50 mm ahead.
        let expected = vec3(0.024 * x, 0.012 * y, -0.05).normalize();
        assert!(
            d.distance(expected) < ROUNDING,
            "{name} is {expected}, not {}",
            *d
        );
    }
}

#[test]
fn rays_pass_through_the_centres_of_pixels() {
    let (camera, width, height) = (camera(), 6.0, 4.0);
    for (x, y) in [(0.0, 0.0), (5.0, 0.0), (2.0, 3.0)] {
        let ray = camera.central_ray(vec2((x + 0.5) / width, (y + 0.5) / height));
        // Walk the plane: from its top left by whole pixels, and half a pixel more.
        let pixel = camera.plane / vec2(width, height);
        let top_left = camera.focal_point + camera.focal_length * *camera.forward
            - 0.5 * camera.plane.x * *camera.right
            + 0.5 * camera.plane.y * *camera.up;
        let centre =
            top_left + (x + 0.5) * pixel.x * *camera.right - (y + 0.5) * pixel.y * *camera.up;
        let t = camera.focal_point.distance(centre);
        // The focal point's coordinates are about 3: their rounding is what is left.
        assert!(
            ray.at(t).distance(centre) < 3.0 * ROUNDING,
            "pixel ({x}, {y})"
        );
    }
}

#[test]
fn focal_length_and_field_of_view_belong_together() {
    // Angles of view of the 35 mm film's height, from photographers' tables: 2·atan(12 mm/f).
    for (millimetres, degrees) in [(14.0, 81.20), (24.0, 53.13), (50.0, 26.99), (200.0, 6.87)] {
        let camera = Pinhole::look_at(Vec3::ZERO, Vec3::X, Vec3::Y, millimetres / 1000.0, 1.5)
            .expect("it can");
        let edge = |y: f32| camera.central_ray(vec2(0.5, y)).direction;
        let angle = edge(0.0).angle_between(*edge(1.0)).to_degrees();
        assert!(
            (angle - degrees).abs() < 0.01,
            "{millimetres} mm sees {angle}°, not {degrees}°"
        );
        assert!(
            (camera.plane - vec2(1.5 * PLANE_HEIGHT, PLANE_HEIGHT)).length() < ROUNDING,
            "3:2 of 24 mm"
        );
    }
}

#[test]
fn an_up_along_the_view_is_an_error_that_says_so() {
    let up_error = |up: Vec3| {
        Pinhole::look_at(Vec3::ZERO, vec3(0.0, 5.0, 0.0), up, 0.05, 1.0).expect_err("it cannot")
    };
    let error = up_error(2.0 * Vec3::Y);
    assert_eq!(
        error.to_string(),
        "the camera looks along [0, 1, 0], and its up, [0, 2, 0], is zero or parallel to that: choose another up"
    );
    for up in [
        -Vec3::Y,
        vec3(1e-6, 1.0, 0.0),
        Vec3::ZERO,
        Vec3::NAN,
        vec3(0.0, f32::INFINITY, 0.0),
    ] {
        assert!(
            matches!(up_error(up), LookAtError::UpParallelToView { .. }),
            "up = {up}"
        );
    }
    let nearly = Pinhole::look_at(Vec3::ZERO, Vec3::Y, vec3(1e-3, 1.0, 0.0), 0.05, 1.0);
    assert!(
        nearly.is_ok(),
        "a tenth of a degree beside the view is enough: {nearly:?}"
    );
}

#[test]
fn looking_nowhere_is_an_error_that_says_so() {
    let here = vec3(1.0, 2.0, 3.0);
    let error =
        Pinhole::look_at(here, here, Vec3::Y, 0.05, 1.0).expect_err("there is no direction");
    assert_eq!(
        error.to_string(),
        "the camera at [1, 2, 3] looks at [1, 2, 3]: it needs two different, finite points"
    );
    for (from, to) in [
        (here, Vec3::NAN),
        (Vec3::INFINITY, here),
        (Vec3::NAN, Vec3::NAN),
    ] {
        let error =
            Pinhole::look_at(from, to, Vec3::Y, 0.05, 1.0).expect_err("there is no direction");
        assert!(
            matches!(error, LookAtError::SamePoint { .. }),
            "{from} to {to}: {error}"
        );
    }
}
