//! Local illumination: the sum over the lights; and scenes.

use crate::ch12_phong::{PHONG, close, from, ground, rays::ray, toward};
use glam::{Vec2, Vec3, vec2, vec3};
use raybook::image::rgb::Rgb;
use raybook::light::{Light, LightSample, directional::DirectionalLight, point::PointLight};
use raybook::material::{Material, checkered::Checkered, phong::Phong};
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::render::local::{Local, NO_SHADOWS, Visibility};
use raybook::scene::world::{Scene, Thing};
use raybook::shape::{Surface, plane::Plane, sphere::Sphere};

/// A light that never shines.
struct Broken;

impl Light for Broken {
    fn sample(&self, _at: Vec3, _u: Vec2) -> Option<LightSample> {
        None
    }
}

fn lamp(x: f32) -> Box<dyn Light> {
    Box::new(PointLight {
        position: vec3(x, 2.0, 0.0),
        intensity: Rgb::new(4.0, 8.0, 12.0),
    })
}

fn sun() -> Box<dyn Light> {
    Box::new(DirectionalLight {
        toward: Dir3::Y,
        irradiance: Rgb::WHITE,
    })
}

/// What is seen of the ground at the origin from straight above.
fn radiance(lights: Vec<Box<dyn Light>>, samples: u32, arrives: Option<Visibility>) -> Rgb {
    let ground = Thing::new(Plane::through(Vec3::ZERO, Dir3::Y), PHONG);
    let scene = Scene::new(vec![ground], lights).surrounded_by(Rgb::gray(0.2), |_| Rgb::BLACK);
    let seen = scene.closest(&ray(vec3(0.0, 9.0, 0.0), Vec3::NEG_Y));
    let seen = seen.expect("the ray meets the ground");
    let local = Local { samples, arrives };
    local
        .follow(&scene, &seen, Dir3::Y, &mut pcg::stream(0, 0))
        .radiance
}

#[test]
fn ambient_light_and_all_lights_add_up() {
    let ambient = Rgb::gray(0.1);
    close(
        radiance(vec![], 1, NO_SHADOWS),
        ambient,
        "k_a i_a in the dark",
    );
    // 2 m above: 1, 2, 3 W/m² arrive from straight above.
    let of_lamp = (PHONG.diffuse + PHONG.specular) * Rgb::new(1.0, 2.0, 3.0);
    close(
        radiance(vec![lamp(0.0)], 1, NO_SHADOWS),
        ambient + of_lamp,
        "one lamp",
    );
    let of_sun = PHONG.diffuse + PHONG.specular;
    let both = vec![lamp(0.0), sun()];
    close(
        radiance(both, 1, NO_SHADOWS),
        ambient + of_lamp + of_sun,
        "lamp and sun",
    );
    let aside = vec3(1.5, 2.0, 0.0);
    let arriving = Rgb::new(4.0, 8.0, 12.0) / aside.length_squared();
    let cosine = aside.normalize().y;
    let of_aside = (PHONG.diffuse * cosine + PHONG.specular * cosine.powi(2)) * arriving;
    close(
        radiance(vec![lamp(1.5)], 1, NO_SHADOWS),
        ambient + of_aside,
        "a lamp aside",
    );
}

#[test]
fn more_samples_of_a_light_without_extent_change_nothing() {
    let [one, many] = [1, 8].map(|samples| radiance(vec![lamp(0.5), sun()], samples, NO_SHADOWS));
    close(many, one, "their mean is the light");
}

#[test]
fn light_that_does_not_arrive_leaves_the_ambient_light() {
    let ambient = Rgb::gray(0.1);
    close(
        radiance(vec![lamp(0.0)], 1, Some(|_, _, _| false)),
        ambient,
        "all in shadow",
    );
    close(
        radiance(vec![Box::new(Broken)], 1, NO_SHADOWS),
        ambient,
        "a light that is off",
    );
}

#[test]
fn a_scene_shows_the_nearest_thing_and_its_material() {
    let ball = |z: f32, share: f32| -> Thing {
        let ambient = Rgb::gray(share);
        Thing::new(
            Sphere::new(vec3(0.0, 0.0, z), 1.0),
            Phong { ambient, ..PHONG },
        )
    };
    let scene = Scene::new(
        vec![ball(-9.0, 0.1), ball(-4.0, 0.2), ball(-7.0, 0.3)],
        vec![],
    );
    let along = ray(Vec3::ZERO, Vec3::NEG_Z);
    let seen = scene.closest(&along).expect("three balls are ahead");
    assert_eq!(seen.t, 3.0, "the front of the nearest");
    assert_eq!(
        seen.material.ambient(&seen.surface),
        Rgb::gray(0.2),
        "and its material"
    );
    for (min, max, blocked) in [
        (0.0, 2.9, false),
        (0.0, 3.1, true),
        (5.1, 5.9, false),
        (5.1, 6.1, true),
    ] {
        let blocks = scene.blocks(&along, Interval::new(min, max));
        assert_eq!(blocks, blocked, "from {min} to {max}");
    }
    let past = ray(Vec3::ZERO, Vec3::Z);
    assert!(scene.closest(&past).is_none(), "nothing is behind");
    let sky: fn(&Ray) -> Rgb = |ray| Rgb::gray(ray.direction.z);
    assert_eq!(
        (scene.surrounded_by(Rgb::WHITE, sky).backdrop)(&past),
        Rgb::WHITE,
        "but the backdrop"
    );
}

#[test]
fn squares_alternate_through_zero() {
    let other = Phong {
        ambient: Rgb::BLACK,
        diffuse: Rgb::BLACK,
        specular: Rgb::BLACK,
        ..PHONG
    };
    let board = Checkered(PHONG, other);
    for (x, y) in [
        (0.5, 0.5),
        (-0.5, -0.5),
        (-0.5, 1.5),
        (2.5, -3.5),
        (7.5, 1.5),
    ] {
        for (x, y, first) in [
            (x, y, true),
            (x + 1.0, y, false),
            (x, y - 1.0, false),
            (x - 1.0, y + 1.0, true),
        ] {
            let at = Surface {
                texture: vec2(x, y),
                ..ground(Dir3::Y)
            };
            let (same, view) = (if first { &PHONG } else { &other }, toward(Vec3::ONE));
            assert_eq!(board.ambient(&at), same.ambient(&at), "at ({x}, {y})");
            let light = from(vec3(1.0, 2.0, 0.0));
            assert_eq!(
                board.lit(&at, view, &light),
                same.lit(&at, view, &light),
                "at ({x}, {y})"
            );
        }
    }
}
