//! Paths under a sky: a scene of known radiance, two ways to choose directions, and two kinds of random numbers.

use glam::{Vec2, Vec3, vec3};
use rand::RngExt;
use raybook::image::{Image, rgb::Rgb};
use raybook::light::{Light, environment::Environment};
use raybook::material::lambert::Lambert;
use raybook::math::{dir3::Dir3, pcg, ray::Ray};
use raybook::render::{film::Film, mis::Strategy, path::Path};
use raybook::scene::world::{Scene, Thing};
use raybook::shape::sphere::Sphere;
use raybook_chapters::ch18_environment::skies;
use raybook_chapters::ch18_environment::uniform_environment::UniformEnvironment;
use raybook_common::statistics::Mean;
use raybook_scenes::{Shot, gallery};

const STRATEGIES: [Strategy; 3] = [Strategy::Surface, Strategy::Light, Strategy::Both];

fn path(strategy: Strategy) -> Path {
    Path {
        depth: 12,
        roulette_after: 3,
        strategy,
    }
}

fn balls(albedo: f32, light: impl Light + 'static) -> Scene {
    let ball = |x: f32, r: f32| -> Thing {
        let albedo = Rgb::gray(albedo);
        Thing::new(Sphere::new(vec3(x, 0.0, 0.0), r), Lambert { albedo })
    };
    Scene::new(vec![ball(-1.0, 1.0), ball(0.9, 0.8)], vec![Box::new(light)])
}

/// The mean radiance that a narrow bundle of rays sees of both balls.
fn seen(scene: &Scene, path: Path, samples: u32) -> Mean {
    Mean::sampled(191, samples, |rng| {
        let (x, y): (f32, f32) = (rng.random(), rng.random());
        let toward = vec3(1.6 * x - 0.8, 0.6 * y - 0.3, -4.0);
        let ray = Ray::new(vec3(0.0, 0.0, 4.0), Dir3::new(toward).expect("not zero"));
        path.radiance(scene, &ray, rng).g
    })
}

#[test]
fn white_balls_disappear_under_a_white_sky() {
    for strategy in STRATEGIES {
        for (width, height) in [(1, 1), (16, 8)] {
            let white = Environment::new(Image::from_fn(width, height, |_, _| Rgb::WHITE));
            let mean = seen(
                &balls(1.0, white),
                Path {
                    depth: 200,
                    ..path(strategy)
                },
                1500,
            );
            mean.assert_is(1.0, &format!("{strategy:?}, {width} × {height}"));
        }
    }
}

#[test]
fn directions_by_their_light_and_uniform_ones_bring_the_same_light() {
    let sky = || {
        Environment::new(Image::from_fn(16, 8, |x, y| {
            Rgb::gray(0.2 + ((5 * x + 3 * y) % 7) as f32)
        }))
    };
    let by_light = seen(&balls(0.6, sky()), path(Strategy::Both), 4000);
    for strategy in STRATEGIES {
        let uniform = seen(&balls(0.6, UniformEnvironment(sky())), path(strategy), 4000);
        by_light.assert_same(&uniform, &format!("{strategy:?}, everywhere"));
        let other = seen(&balls(0.6, sky()), path(strategy), 4000);
        by_light.assert_same(&other, &format!("{strategy:?}, by the light"));
    }
}

fn still_life(light: Box<dyn Light>) -> Shot {
    gallery::STILL_LIFE.under(light, 24).expect("a scene")
}

#[test]
fn a_strong_sun_pays_for_being_asked() {
    let sky = || Environment::new(skies::map(skies::clear_day, 256));
    let direct = |light: Box<dyn Light>, strategy| {
        let path = Path {
            depth: 1,
            ..path(strategy)
        };
        let Shot { scene, camera, .. } = still_life(light);
        let eye = camera.central_ray(Vec2::splat(0.5)).origin;
        let ray = Ray::new(
            eye,
            Dir3::new(vec3(-2.2, 0.0, 1.0) - eye).expect("not zero"),
        );
        Mean::sampled(192, 300, |rng| path.radiance(&scene, &ray, rng).g).error
    };
    let by_light = direct(Box::new(sky()), Strategy::Both);
    let uniform = direct(Box::new(UniformEnvironment(sky())), Strategy::Both);
    assert!(
        uniform > 4.0 * by_light,
        "in the sun: an error of {by_light} by the light, of {uniform} everywhere"
    );
}

#[test]
fn even_random_numbers_change_the_noise_and_not_the_mean() {
    let overcast = Environment::new(skies::map(skies::overcast, 64));
    let Shot { scene, camera, .. } = still_life(Box::new(overcast));
    let path = path(Strategy::Both);
    let ray = |at| camera.central_ray(at);
    let film = |seed, samples| Film {
        seed,
        threads: 2,
        ..Film::new(24, 15, samples)
    };
    for samples in [1, 32] {
        let (mut by_chance, mut evenly) = (vec![], vec![]);
        let (mut noise, mut less) = (0.0, 0.0);
        let mut last: Option<[Image; 2]> = None;
        for seed in 0..16 {
            let film = film(seed, samples);
            let chance = film.sample(|at, rng| path.radiance(&scene, &ray(at), rng));
            let even = film.refine(|at, rng| path.radiance(&scene, &ray(at), rng));
            let mean = |image: &Image| {
                let sum: f64 = image.pixels().iter().map(|p| f64::from(p.g)).sum();
                sum / image.pixels().len() as f64
            };
            by_chance.push(mean(&chance));
            evenly.push(mean(&even));
            if let Some([a, b]) = &last {
                noise += difference(a, &chance);
                less += difference(b, &even);
            }
            last = Some([chance, even]);
        }
        let [by_chance, evenly] = [Mean::of(&by_chance), Mean::of(&evenly)];
        by_chance.assert_same(&evenly, &format!("{samples} samples"));
        assert!(
            samples == 1 || less < 0.7 * noise,
            "{samples} samples: mean squares {less} and {noise}"
        );
    }
}

fn difference(a: &Image, b: &Image) -> f64 {
    let pairs = a.pixels().iter().zip(b.pixels());
    pairs.map(|(a, b)| f64::from(a.g - b.g).powi(2)).sum()
}

#[test]
fn a_sky_is_seen_behind_everything() {
    let sky = Environment::new(Image::from_fn(1, 2, |_, y| Rgb::gray(1.0 + y as f32)));
    let scene = balls(0.5, sky);
    let mut rng = pcg::stream(193, 0);
    for strategy in STRATEGIES {
        for (toward, radiance) in [(Dir3::Y, 1.0), (-Dir3::Y, 2.0)] {
            let ray = Ray::new(Vec3::new(0.0, 3.0, 9.0), toward);
            let seen = path(strategy).radiance(&scene, &ray, &mut rng);
            assert_eq!(seen, Rgb::gray(radiance), "{strategy:?}, {toward:?}");
        }
    }
}
