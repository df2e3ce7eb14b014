//! Whitted and path tracing against each other.

use crate::ch17_rendering_equation::{ALL, direction, square, thing};
use glam::{Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::light::{Light, directional::DirectionalLight, point::PointLight};
use raybook::material::{lambert::Lambert, modified_phong::ModifiedPhong};
use raybook::math::{dir3::Dir3, pcg, ray::Ray};
use raybook::render::{local::Local, mis::Strategy, path::Path, shadow, whitted::Whitted};
use raybook::scene::world::Scene;
use raybook::shape::{plane::Plane, sphere::Sphere};

#[test]
fn whitted_with_point_lights_is_a_path_over_one_surface() {
    const MATT: Lambert = Lambert {
        albedo: Rgb::new(0.7, 0.5, 0.3),
    };
    const GLOSSY: ModifiedPhong = ModifiedPhong {
        diffuse: Rgb::new(0.2, 0.3, 0.1),
        specular: Rgb::gray(0.5),
        exponent: 30.0,
    };
    let lights: Vec<Box<dyn Light>> = vec![
        Box::new(PointLight {
            position: vec3(3.0, 4.0, 2.0),
            intensity: Rgb::new(30.0, 20.0, 10.0),
        }),
        Box::new(DirectionalLight {
            toward: direction(-1.0, 1.0, 0.3),
            irradiance: Rgb::gray(0.5),
        }),
    ];
    let ball = Sphere::new(vec3(0.0, 1.0, 0.0), 1.0);
    let floor = Plane::through(Vec3::ZERO, Dir3::Y);
    let things = vec![thing(ball, GLOSSY), thing(floor, MATT)];
    let scene = Scene::new(things, lights);
    let local = Local {
        samples: 1,
        arrives: Some(shadow::lit),
    };
    let (whitted, mut lit, mut dark) = (Whitted { local, depth: 3 }, 0, 0);
    for strategy in [Strategy::Surface, Strategy::Light, Strategy::Both] {
        let path = Path {
            depth: 1,
            strategy,
            ..ALL
        };
        let mut rng = pcg::stream(31, 0);
        for _ in 0..2000 {
            let u = square(&mut rng);
            let ray = Ray::new(
                vec3(0.5, 2.5, 6.0),
                direction(u.x - 0.6, 0.2 - 0.8 * u.y, -1.0),
            );
            let one = path.radiance(&scene, &ray, &mut rng);
            let other = whitted.radiance(&scene, &ray, &mut rng);
            assert_eq!(one, other, "{strategy:?}, {ray:?}");
            (lit, dark) = if one.g > 0.0 {
                (lit + 1, dark)
            } else {
                (lit, dark + 1)
            };
        }
    }
    assert!(lit > 3000 && dark > 300, "{lit} are lit, {dark} are not");
}

#[test]
fn an_empty_scene_shows_its_backdrop() {
    let mut scene = Scene::new(vec![], vec![]);
    scene.backdrop = Box::new(|ray| Rgb::gray(ray.direction.y));
    let ray = Ray::new(Vec3::ZERO, Dir3::Y);
    let mut rng = pcg::stream(1, 1);
    assert_eq!(
        ALL.radiance(&scene, &ray, &mut rng),
        Rgb::WHITE,
        "straight up"
    );
    let ball = thing(
        Sphere::new(vec3(0.0, 3.0, 0.0), 1.0),
        Lambert { albedo: Rgb::BLACK },
    );
    let scene = Scene::new(vec![ball], vec![]);
    assert_eq!(
        ALL.radiance(&scene, &ray, &mut rng),
        Rgb::BLACK,
        "a black ball"
    );
}
