//! A panorama, used as an environment map, shows the same again.

use crate::ch20_panorama::{film, panorama, seen};
use glam::{Vec3, vec2, vec3};
use raybook::camera::Camera;
use raybook::camera::pinhole::Pinhole;
use raybook::camera::{panorama::Panorama, pose::Pose};
use raybook::image::{Image, rgb::Rgb};
use raybook::light::environment::Environment;
use raybook::math::pcg;
use raybook::render::{mis::Strategy, path::Path};
use raybook::scene::world::Scene;
use raybook_chapters::ch18_environment::skies;
use raybook_chapters::ch20_panorama::pavilion::{self, EYE};

/// Looks in all directions: level, upwards, downwards, and nearly straight up and down.
const LOOKS: [Vec3; 7] = [
    vec3(0.1, 0.0, -1.0),
    vec3(1.0, -0.1, 0.2),
    vec3(-0.3, 0.2, 1.0),
    vec3(-1.0, 0.6, -0.2),
    vec3(0.4, -1.0, 0.3),
    vec3(0.01, 1.0, 0.0),
    vec3(0.0, -1.0, 0.01),
];

/// A pixel differs if a channel differs by more than this, of white.
const TOLERANCE: f32 = 0.02;

#[test]
fn the_middle_of_every_texel_has_the_radiance_of_its_ray() {
    let scene = pavilion::scene();
    let (width, height) = (128, 64);
    let environment = Environment::new(panorama(&scene, EYE, width));
    let camera = Panorama {
        pose: Pose::level(EYE),
    };
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        let place = (vec2(x as f32, y as f32) + 0.5) / vec2(width as f32, height as f32);
        let ray = camera.central_ray(place);
        assert_eq!(
            environment.radiance(ray.direction),
            seen(&scene, &ray),
            "texel ({x}, {y})"
        );
    }
}

/// The share of the pixels that differ, of pictures in all directions from a point, and the mean of what the pixels differ
/// by; the panorama is taken in the middle.
fn difference(from: Vec3, width: usize) -> (f64, f64) {
    let scene = pavilion::scene();
    let environment = Environment::new(panorama(&scene, EYE, width));
    let (mut differ, mut sum, mut pixels) = (0, 0.0, 0);
    for toward in LOOKS {
        let camera = Pinhole::look_at(from, from + toward, Vec3::Y, 0.02, 1.5);
        let camera = camera.expect("it looks somewhere");
        let film = film(96, 64);
        let real = film.sample(|place, _| seen(&scene, &camera.central_ray(place)));
        let around =
            film.sample(|place, _| environment.radiance(camera.central_ray(place).direction));
        for (a, b) in real.pixels().iter().zip(around.pixels()) {
            let off = a.channels().into_iter().zip(b.channels());
            // The sun is 600: what is brighter than white is white in both.
            let off = off.map(|(a, b)| (a.min(1.0) - b.min(1.0)).abs());
            let off = off.fold(0.0, f32::max);
            differ += i32::from(off > TOLERANCE);
            sum += f64::from(off);
            pixels += 1;
        }
    }
    (
        f64::from(differ) / f64::from(pixels),
        sum / f64::from(pixels),
    )
}

#[test]
fn looks_cut_out_of_a_panorama_are_those_that_a_pinhole_takes_there() {
    let (differ, mean) = difference(EYE, 2048);
    // Measured: 1.7 % and 0.0063. The pixels that differ are those on edges, where a texel decides for its middle.
    assert!(
        differ < 0.02 && mean < 0.0075,
        "{differ} of the pixels differ, by {mean} in the mean"
    );
}

#[test]
fn a_finer_panorama_is_nearer_to_the_scene() {
    let shares = [256, 1024].map(|width| difference(EYE, width));
    let ratio = shares[0].1 / shares[1].1;
    // What differs is along edges, as broad as a texel: of four times as many texels, a quarter.
    assert!(
        (2.5..5.5).contains(&ratio),
        "with a quarter of the texels {ratio} times as much differs: {shares:?}"
    );
}

#[test]
fn from_another_point_the_panorama_is_wrong() {
    let (here, there) = (difference(EYE, 1024), difference(EYE + 0.3 * Vec3::X, 1024));
    assert!(
        there.0 > 0.25,
        "more than a quarter, as the book says: {}",
        there.0
    );
    assert!(
        there.0 > 4.0 * here.0,
        "30 cm aside, {} of the pixels differ; at the point itself, {}",
        there.0,
        here.0
    );
}

#[test]
fn a_panorama_of_an_environment_is_that_environment() {
    let odd = Image::from_fn(37, 11, |x, y| Rgb::new(x as f32, y as f32, 1.0));
    for map in [skies::map(skies::clear_day, 256), odd] {
        let environment = Environment::new(map.clone());
        let camera = Panorama {
            pose: Pose::level(vec3(3.0, 1.0, -2.0)),
        };
        let film = film(map.width(), map.height());
        let again =
            film.sample(|place, _| environment.radiance(camera.central_ray(place).direction));
        assert!(again.same_bits(&map), "every texel, bit for bit");
        // And as a light in a scene, by the whole path tracer.
        let empty: Scene = Scene::new(Vec::new(), vec![Box::new(environment)]);
        let path = Path {
            depth: 3,
            roulette_after: 3,
            strategy: Strategy::Both,
        };
        let rng = &|| pcg::stream(1, 0);
        let again =
            film.sample(|place, _| path.radiance(&empty, &camera.central_ray(place), &mut rng()));
        assert!(again.same_bits(&map), "in a scene, bit for bit");
    }
}

#[test]
fn a_mirrored_or_shifted_panorama_would_be_noticed() {
    let scene = pavilion::scene();
    let map = panorama(&scene, EYE, 256);
    let (width, height) = (map.width(), map.height());
    let wrong: [(&str, Image); 3] = [
        (
            "mirrored",
            Image::from_fn(width, height, |x, y| map.at(width - 1 - x, y)),
        ),
        (
            "upside down",
            Image::from_fn(width, height, |x, y| map.at(x, height - 1 - y)),
        ),
        (
            "a texel aside",
            Image::from_fn(width, height, |x, y| map.at((x + 1) % width, y)),
        ),
    ];
    let camera = Panorama {
        pose: Pose::level(EYE),
    };
    for (name, map) in wrong {
        let environment = Environment::new(map);
        let film = film(width, height);
        let again =
            film.sample(|place, _| environment.radiance(camera.central_ray(place).direction));
        let real = panorama(&scene, EYE, 256);
        let differ = again.pixels().iter().zip(real.pixels());
        let differ = differ.filter(|(a, b)| a != b).count();
        assert!(
            differ > width * height / 4,
            "{name}: {differ} pixels differ"
        );
    }
}
