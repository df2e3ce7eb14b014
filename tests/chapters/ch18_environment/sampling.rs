//! Importance sampling: the density is what it says, and the estimates are right.

use crate::ch18_environment::direction;
use glam::{Vec2, Vec3, vec2};
use rand::RngExt;
use raybook::image::{Image, rgb::Rgb};
use raybook::light::{Light, environment::Environment};
use raybook::math::pcg::{self, Pcg};
use raybook::math::{dir3::Dir3, ray::Ray};
use std::f32::consts::PI;

fn uniform(rng: &mut Pcg) -> Vec2 {
    vec2(rng.random(), rng.random())
}

/// A map of random brightness, a third of it dark, and some of it very bright.
fn patchy(width: usize, height: usize, rng: &mut Pcg) -> Environment {
    Environment::new(Image::from_fn(width, height, |_, _| {
        Rgb::gray((3.0 * rng.random::<f32>() - 1.0).max(0.0).powi(3))
    }))
}

#[test]
fn a_constant_map_is_sampled_evenly_by_solid_angle() {
    for (width, height) in [(1, 1), (2, 1), (1, 2), (16, 8), (31, 17)] {
        let environment = Environment::new(Image::from_fn(width, height, |_, _| Rgb::WHITE));
        let mut rng = pcg::stream(182, 0);
        for _ in 0..1000 {
            let light = environment.sample(Vec3::ZERO, uniform(&mut rng));
            let light = light.expect("there is light");
            for pdf in [light.pdf, environment.density(light.toward)] {
                assert!(
                    (pdf * 4.0 * PI - 1.0).abs() < 1e-6,
                    "{width} × {height}: the density is {pdf}, not 1/4π"
                );
            }
        }
    }
}

#[test]
fn the_density_integrates_to_one() {
    let mut rng = pcg::stream(183, 0);
    let environment = patchy(16, 8, &mut rng);
    // Exactly: every texel's density times its solid angle.
    let mut integral = 0.0;
    for y in 0..8 {
        let edge = |y: usize| (PI * y as f32 / 8.0).cos();
        let solid_angle = 2.0 * PI * (edge(y) - edge(y + 1)) / 16.0;
        for x in 0..16 {
            let place = vec2((x as f32 + 0.5) / 16.0, (y as f32 + 0.5) / 8.0);
            let toward = raybook::light::environment::latlong::direction(place);
            integral += environment.density(toward) * solid_angle;
        }
    }
    assert!((integral - 1.0).abs() < 1e-5, "∫ p dω = {integral}");
}

#[test]
fn a_light_knows_its_density() {
    let mut rng = pcg::stream(188, 0);
    let environment = patchy(16, 8, &mut rng);
    for _ in 0..1000 {
        let toward = direction(&mut rng);
        let [near, far] = [1.0, f32::INFINITY]
            .map(|farthest| environment.seen(&Ray::new(Vec3::ZERO, toward), farthest));
        assert!(near.is_none(), "it is farther than a metre");
        let (pdf, density) = (far.expect("it shines").pdf, environment.density(toward));
        assert!(
            (pdf - density).abs() <= 1e-6 * density,
            "{toward:?}: {pdf} and {density}"
        );
    }
}

#[test]
fn samples_follow_the_density() {
    let mut rng = pcg::stream(184, 0);
    let environment = patchy(16, 8, &mut rng);
    let samples = 200_000;
    let mut counts = [0.0_f64; 128];
    for _ in 0..samples {
        let toward = environment
            .choose(uniform(&mut rng))
            .expect("there is light");
        let place = raybook::light::environment::latlong::place(toward);
        counts[16 * (8.0 * place.y) as usize + (16.0 * place.x) as usize] += 1.0;
    }
    let total: f64 = (0..128).map(|i| weight(&environment, i)).sum();
    let (mut chi2, mut cells) = (0.0, 0.0);
    for (i, count) in counts.into_iter().enumerate() {
        let expected = f64::from(samples) * weight(&environment, i) / total;
        if expected > 0.0 {
            chi2 += (count - expected).powi(2) / expected;
            cells += 1.0;
        } else {
            assert_eq!(count, 0.0, "texel {i} is dark");
        }
    }
    // χ² has a mean of cells − 1 and a standard deviation of √(2 (cells − 1)).
    let z = (chi2 - (cells - 1.0)) / (2.0 * (cells - 1.0_f64)).sqrt();
    assert!(
        cells > 60.0 && z.abs() < 4.0,
        "χ² = {chi2} of {cells} texels: z = {z}"
    );
}

/// A texel's light, computed another way: its brightness times its zone's height.
fn weight(environment: &Environment, i: usize) -> f64 {
    let edge = |y: usize| (std::f64::consts::PI * y as f64 / 8.0).cos();
    f64::from(environment.map().at(i % 16, i / 16).g) * (edge(i / 16) - edge(i / 16 + 1))
}

#[test]
fn within_a_texel_samples_are_uniform_by_solid_angle() {
    // One texel, from pole to pole: the direction's cosine must be uniform in [−1, 1], and its mean square 1/3.
    let environment = Environment::new(Image::from_fn(1, 1, |_, _| Rgb::WHITE));
    let n = 256;
    let mut squares = 0.0;
    for i in 0..n {
        let u = vec2(0.3, (i as f32 + 0.5) / n as f32);
        squares += environment.choose(u).expect("light").y.powi(2) / n as f32;
    }
    assert!(
        (squares - 1.0 / 3.0).abs() < 1e-4,
        "the mean square is {squares}"
    );
}

#[test]
fn a_single_bright_texel_is_always_found_and_darkness_never() {
    let one = Image::from_fn(8, 4, |x, y| Rgb::gray(f32::from((x, y) == (5, 1))));
    let environment = Environment::new(one);
    let mut rng = pcg::stream(185, 0);
    for _ in 0..1000 {
        let toward = environment.choose(uniform(&mut rng)).expect("light");
        assert_eq!(
            environment.radiance(toward),
            Rgb::WHITE,
            "{toward:?} is in the texel"
        );
    }
    let dark = Environment::new(Image::from_fn(8, 4, |_, _| Rgb::BLACK));
    assert_eq!(dark.choose(vec2(0.5, 0.5)), None, "nothing shines");
    assert_eq!(dark.density(Dir3::X), 0.0, "and nothing is chosen");
    assert!(
        dark.sample(Vec3::ZERO, vec2(0.1, 0.9)).is_none(),
        "so nothing arrives"
    );
}

#[test]
fn a_constant_sky_gives_an_irradiance_of_pi() {
    let environment = Environment::new(Image::from_fn(64, 32, |_, _| Rgb::WHITE));
    let mut rng = pcg::stream(186, 0);
    let samples = 100_000;
    let sum: f32 = (0..samples)
        .filter_map(|_| environment.sample(Vec3::ZERO, uniform(&mut rng)))
        .map(|light| light.arriving.g * light.toward.y.max(0.0))
        .sum();
    // 4π max(0, cos θ) has a standard deviation of 4π √(1/6 − 1/16) = 4.06: five of √n.
    let irradiance = sum / samples as f32;
    assert!((irradiance - PI).abs() < 0.065, "E = {irradiance}, not π");
}

#[test]
fn what_is_seen_is_what_is_sampled() {
    let mut rng = pcg::stream(187, 0);
    let environment = patchy(32, 16, &mut rng);
    let n = 200_000;
    let by_light: f32 = (0..n)
        .filter_map(|_| environment.sample(Vec3::ZERO, uniform(&mut rng)))
        .map(|light| light.arriving.g * light.toward.x.max(0.0))
        .sum();
    let by_chance: f32 = (0..n)
        .map(|_| direction(&mut rng))
        .filter_map(|d| {
            Some((
                d,
                environment
                    .seen(&Ray::new(Vec3::ZERO, d), f32::INFINITY)?
                    .radiance,
            ))
        })
        .map(|(d, radiance)| 4.0 * PI * radiance.g * d.x.max(0.0))
        .sum();
    let [a, b] = [by_light, by_chance].map(|sum| sum / n as f32);
    assert!(
        (a / b - 1.0).abs() < 0.02,
        "{a} by its light, {b} by chance"
    );
}
