//! Chapter 15: shadow rays, from just off the surface to just before the light.

use raybook_common::rays;
mod creases;
mod ends;
mod scales;
mod sums;

use glam::{Vec2, Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::light::{Light, LightSample, directional::DirectionalLight, point::PointLight};
use raybook::material::{Material, phong::Phong};
use raybook::math::{dir3::Dir3, interval::Interval, pcg};
use raybook::render::shadow::{lit, shadow_ray};
use raybook::scene::world::{Scene, Thing};
use raybook::shape::{Shape, Surface, plane::Plane, sphere::Sphere};
use rays::{random_direction, ray};
use std::sync::Arc;

const CLAY: Phong = Phong {
    ambient: Rgb::gray(0.5),
    diffuse: Rgb::gray(0.25),
    specular: Rgb::BLACK,
    exponent: 1.0,
};

/// A scene of these shapes, all of clay.
fn scene(shapes: Vec<Box<dyn Shape>>) -> Scene {
    let clay: Arc<dyn Material> = Arc::new(CLAY);
    let thing = |shape| Thing {
        shape: Arc::from(shape),
        material: clay.clone(),
    };
    Scene::new(shapes.into_iter().map(thing).collect(), Vec::new())
}

/// Light from a lamp to a point.
fn from_lamp(position: Vec3, at: &Surface) -> LightSample {
    let lamp = PointLight {
        position,
        intensity: Rgb::WHITE,
    };
    lamp.sample(at.position, Vec2::ZERO)
        .expect("the lamp is elsewhere")
}

/// Light from the sun.
fn from_sun(toward: Vec3) -> LightSample {
    let toward = Dir3::new(toward).expect("a test's direction is one");
    let sun = DirectionalLight {
        toward,
        irradiance: Rgb::WHITE,
    };
    sun.sample(Vec3::ZERO, Vec2::ZERO)
        .expect("it shines everywhere")
}

/// The ground at a place, seen from above.
fn ground_at(x: f32, z: f32) -> Surface {
    let ground = Plane::through(Vec3::ZERO, Dir3::Y);
    rays::sure_hit(&ground, &ray(vec3(x, 3.0, z), Vec3::NEG_Y)).1
}

fn ground() -> Box<dyn Shape> {
    Box::new(Plane::through(Vec3::ZERO, Dir3::Y))
}

fn ball(center: Vec3, radius: f32) -> Box<dyn Shape> {
    Box::new(Sphere::new(center, radius))
}

#[test]
fn the_shadow_of_a_ball_is_as_large_as_geometry_says() {
    // A lamp 4 m above the ground, a ball of radius 1 half way: the shadow's rim is where the ray touches the ball.
    let lamp = vec3(0.0, 4.0, 0.0);
    let scene = scene(vec![ground(), ball(vec3(0.0, 2.0, 0.0), 1.0)]);
    // tan of the angle whose sine is 1/2, times 4 m.
    let rim = 4.0 / 3.0_f32.sqrt();
    let mut lit_places = 0;
    for i in 0..2000 {
        let x = 0.002 * i as f32;
        let at = ground_at(x, 0.0);
        let arrives = lit(&scene, &at, &from_lamp(lamp, &at));
        if (x - rim).abs() > 1e-4 {
            assert_eq!(
                arrives,
                x > rim,
                "{x} m from the middle, the rim is at {rim}"
            );
        }
        lit_places += u32::from(arrives);
    }
    assert!(
        (500..1500).contains(&lit_places),
        "{lit_places} of 2000 are lit"
    );
}

#[test]
fn only_what_is_between_the_surface_and_the_light_throws_a_shadow() {
    let at = ground_at(0.0, 0.0);
    let lamp = from_lamp(vec3(0.0, 3.0, 0.0), &at);
    for (why, height, radius, arrives) in [
        ("between", 1.5, 0.5, false),
        ("just above the ground", 0.01, 0.005, false),
        ("just below the lamp", 2.99, 0.005, false),
        ("around the lamp, like a shade", 3.0, 0.5, false),
        ("just above the lamp", 3.01, 0.005, true),
        ("far above the lamp", 9.0, 2.0, true),
        ("below the ground", -2.0, 1.0, true),
    ] {
        let scene = scene(vec![ground(), ball(vec3(0.0, height, 0.0), radius)]);
        assert_eq!(lit(&scene, &at, &lamp), arrives, "a ball {why}");
    }
    let high = scene(vec![ground(), ball(vec3(0.0, 1e5, 0.0), 1e3)]);
    assert!(
        !lit(&high, &at, &from_sun(Vec3::Y)),
        "before the sun everything counts"
    );
    assert!(
        lit(&high, &at, &from_sun(vec3(1.0, 1.0, 0.0))),
        "unless it is aside"
    );
}

#[test]
fn what_carries_the_light_throws_no_shadow() {
    let mut rng = pcg::stream(15, 0);
    let ceiling = || -> Box<dyn Shape> { Box::new(Plane::through(vec3(0.0, 3.0, 0.0), -Dir3::Y)) };
    let scene = scene(vec![ground(), ceiling()]);
    for _ in 0..20_000 {
        let away = 20.0 * random_direction(&mut rng).with_y(0.0);
        let at = ground_at(away.x, away.z);
        // Right in the ceiling, as a lamp that is let into it.
        assert!(
            lit(&scene, &at, &from_lamp(vec3(0.3, 3.0, 0.1), &at)),
            "{at:?}"
        );
        // One that is above is hidden.
        assert!(
            !lit(&scene, &at, &from_lamp(vec3(0.3, 3.01, 0.1), &at)),
            "{at:?}"
        );
    }
}

#[test]
fn a_sheet_is_in_the_way_of_its_other_side_only() {
    let at = ground_at(1.0, 2.0);
    let scene = scene(vec![ground()]);
    for above in [1.0, -1.0] {
        let (ray, within) = shadow_ray(&at, &from_lamp(vec3(1.0, above, 0.0), &at));
        assert!(
            ray.origin.y * above > 0.0,
            "it starts on the lamp's side: {ray:?}"
        );
        assert!(!scene.blocks(&ray, within), "and does not cross the sheet");
    }
}

#[test]
fn the_interval_is_empty_where_the_light_is_on_the_surface() {
    let at = ground_at(1.0, 2.0);
    let near = from_lamp(vec3(1.0, 1e-9, 2.0), &at);
    let (_, within) = shadow_ray(&at, &near);
    assert!(
        within.min >= within.max,
        "there is nothing between: {within:?}"
    );
    let (_, within) = shadow_ray(&at, &from_sun(Vec3::Y));
    assert_eq!(
        within,
        Interval::AHEAD,
        "the sun is farther than everything"
    );
}
