//! What shadows leave of the light.

use crate::ch15_shadows::rays::ray;
use crate::ch15_shadows::{CLAY, ball, ground, lit, scene};
use glam::{Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::light::{Light, point::PointLight};
use raybook::material::{Material, mirror::Mirror};
use raybook::math::{dir3::Dir3, pcg};
use raybook::render::local::Local;
use raybook::render::whitted::Whitted;
use raybook::scene::world::{Scene, Thing};
use raybook::shape::plane::Plane;
use std::sync::Arc;

#[test]
fn a_shadow_takes_away_one_lights_part_and_no_more() {
    let lamp = |x: f32| -> Box<dyn Light> {
        Box::new(PointLight {
            position: vec3(x, 4.0, 0.0),
            intensity: Rgb::gray(16.0),
        })
    };
    let mut scene = scene(vec![ground(), ball(vec3(0.0, 2.0, 0.0), 0.5)])
        .surrounded_by(Rgb::gray(0.1), |_| Rgb::BLACK);
    scene.lights = vec![lamp(0.0), lamp(3.0)];
    let local = Local {
        samples: 1,
        arrives: Some(lit),
    };
    let whitted = Whitted { local, depth: 1 };
    let aslant = ray(vec3(0.0, 1.0, 0.0), Vec3::NEG_Y);
    let seen = whitted.radiance(&scene, &aslant, &mut pcg::stream(0, 0)).r;
    // The lamp above is hidden. The other: 5 m away, so 16/25 W/m² and a cosine of 4/5.
    let expected = 0.5 * 0.1 + 0.25 * 0.8 * 16.0 / 25.0;
    assert!((seen - expected).abs() < 1e-6, "{seen}, not {expected}");
}

#[test]
fn no_ray_is_sent_for_light_that_would_not_count() {
    let mirror = Mirror { share: Rgb::WHITE };
    let things = |material: Arc<dyn Material>| {
        let floor = Plane::through(Vec3::ZERO, Dir3::Y);
        vec![Thing {
            shape: Arc::new(floor),
            material,
        }]
    };
    let lamp = |y: f32| -> Box<dyn Light> {
        Box::new(PointLight {
            position: vec3(0.0, y, 0.0),
            intensity: Rgb::WHITE,
        })
    };
    let local = Local {
        samples: 1,
        arrives: Some(lit),
    };
    let rays = |material: Arc<dyn Material>, y: f32| {
        let scene = Scene::new(things(material), vec![lamp(y)]);
        let down = ray(vec3(0.0, 1.0, 0.0), Vec3::NEG_Y);
        let whitted = Whitted { local, depth: 1 };
        whitted.follow(&scene, &down, &mut pcg::stream(0, 0)).rays
    };
    assert_eq!(rays(Arc::new(CLAY), 4.0), 2, "to the floor and to the lamp");
    assert_eq!(
        rays(Arc::new(CLAY), -4.0),
        1,
        "the lamp is behind the floor"
    );
    assert_eq!(
        rays(Arc::new(mirror), 4.0),
        1,
        "a mirror makes nothing of it"
    );
}
