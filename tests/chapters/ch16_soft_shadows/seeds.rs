//! The renderer with lights that have an extent, against itself with other random numbers, and with another choice of them.

use crate::ch16_soft_shadows::noisy::{BATCHES, Noisy};
use glam::{Vec3, vec3};
use raybook::image::{Image, rgb::Rgb};
use raybook::light::{
    Light, extent::LightSampling, rect_light::RectLight, sphere_light::SphereLight,
};
use raybook::render::local::{Local, Visibility};
use raybook::render::{film::Film, shadow, whitted::Whitted};
use raybook::shape::sphere::Sphere;
use raybook_scenes::{Shot, gallery};

const MIDDLE: Vec3 = vec3(-3.0, 4.0, -3.0);

fn square(radiance: f32, choose: LightSampling) -> Box<dyn Light> {
    let corner = MIDDLE - vec3(1.0, 0.0, 1.0);
    let light = RectLight::new(corner, 2.0 * Vec3::X, 2.0 * Vec3::Z, Rgb::gray(radiance));
    Box::new(light.choosing(choose))
}

fn sphere(radiance: f32, choose: LightSampling) -> Box<dyn Light> {
    Box::new(SphereLight {
        sphere: Sphere::new(MIDDLE, 0.8),
        radiance: Rgb::gray(radiance),
        choose,
    })
}

/// 16 batches of the posts under a light; the first seed tells them from others.
fn render(light: Box<dyn Light>, arrives: Visibility, first_seed: u64) -> Noisy {
    let shot = gallery::POSTS.under(light, 48).expect("a scene");
    let Shot { scene, camera, .. } = shot;
    let local = Local {
        samples: 2,
        arrives: Some(arrives),
    };
    let whitted = Whitted { local, depth: 1 };
    let batch = |seed: u64| {
        let film = Film {
            seed,
            threads: 2,
            ..Film::new(48, 27, 4)
        };
        film.sample(|place, rng| whitted.radiance(&scene, &camera.central_ray(place), rng))
    };
    let batches: Vec<Image> = (first_seed..).take(BATCHES).map(batch).collect();
    Noisy::of(&batches.iter().collect::<Vec<_>>())
}

#[test]
fn other_random_numbers_and_another_choice_show_the_same() {
    for light in [square, sphere] {
        let reference = render(light(10.0, LightSampling::ByArea), shadow::lit, 0);
        for choose in [LightSampling::ByArea, LightSampling::BySolidAngle] {
            let other = render(light(10.0, choose), shadow::lit, 1000);
            assert_eq!(reference.compare(&other.image()), Ok(()), "{choose:?}");
        }
    }
}

#[test]
fn a_wrong_light_shows() {
    let reference = render(square(10.0, LightSampling::ByArea), shadow::lit, 0);
    let late: Visibility = |scene, at, light| {
        let (ray, _) = shadow::shadow_ray(at, light);
        !scene.blocks(
            &ray,
            raybook::math::interval::Interval::new(1.0, f32::INFINITY),
        )
    };
    for (what, other) in [
        (
            "1 % stronger",
            render(square(10.1, LightSampling::ByArea), shadow::lit, 2000),
        ),
        (
            "a shadow ray that skips a metre",
            render(square(10.0, LightSampling::ByArea), late, 3000),
        ),
    ] {
        assert!(
            reference.compare(&other.image()).is_err(),
            "{what} is not seen"
        );
    }
}
