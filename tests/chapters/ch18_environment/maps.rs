//! Maps that are not as one would like them: huge contrasts, fine rows at the poles, texels that are no light.

use glam::{Vec3, vec2};
use rand::RngExt;
use raybook::image::{Image, rgb::Rgb};
use raybook::light::environment::{Environment, latlong};
use raybook::light::{Light, LightSample};
use raybook::math::pcg;

fn samples(environment: &Environment, n: usize) -> Vec<LightSample> {
    let mut rng = pcg::stream(188, 0);
    let samples = (0..n).map(|_| {
        let u = vec2(rng.random(), rng.random());
        environment.sample(Vec3::ZERO, u)
    });
    samples.flatten().collect()
}

#[test]
fn the_sun_makes_no_firefly_of_a_dark_neighbour() {
    // The dark half of the light is so finely chosen that many of its directions are at the sun's edges.
    let map = Image::from_fn(8, 4, |x, y| {
        Rgb::gray(if (x, y) == (5, 1) { 1e5 } else { 1.0 })
    });
    let environment = Environment::new(map);
    let all = samples(&environment, 20_000);
    let arriving = |light: &LightSample| light.arriving.g;
    let (least, most) = all
        .iter()
        .map(arriving)
        .fold((f32::MAX, 0.0_f32), |(a, b), v| (a.min(v), b.max(v)));
    assert!(
        most / least < 1.0 + 1e-4,
        "every sample carries the same light: from {least} to {most}"
    );
    // Where rounding decides: places on the edges themselves.
    for i in 0..1000 {
        let turn = (5 + i % 2) as f32 / 8.0;
        let d = latlong::toward(turn, 0.7 * f64::from(i) / 1000.0);
        let (radiance, pdf) = (environment.radiance(d).g, environment.density(d));
        assert!(
            (radiance / pdf / least - 1.0).abs() < 1e-4,
            "{d:?}: radiance {radiance} and density {pdf} belong together"
        );
    }
}

#[test]
fn a_texel_at_the_pole_of_a_fine_map_is_hit() {
    for (width, height) in [(64, 4096), (2048, 1024)] {
        for row in [0, 1, height - 1] {
            let bright = (width / 3, row);
            let map = Image::from_fn(width, height, |x, y| Rgb::gray(f32::from((x, y) == bright)));
            let environment = Environment::new(map);
            let found = samples(&environment, 1000).len();
            assert!(
                found > 950,
                "{width} × {height}: {found} of 1000 samples are in the texel of row {row}"
            );
        }
    }
}

#[test]
fn texels_that_are_no_light_are_dark() {
    for wrong in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -3.0] {
        let map = Image::from_fn(4, 2, |x, _| {
            Rgb::new(if x == 1 { wrong } else { 1.0 }, 1.0, 0.0)
        });
        let environment = Environment::new(map);
        for light in samples(&environment, 1000) {
            let finite = |rgb: Rgb| rgb.channels().iter().all(|v| v.is_finite() && *v >= 0.0);
            assert!(finite(light.arriving), "{wrong}: {light:?}");
            assert!(finite(environment.radiance(light.toward)), "{wrong}: seen");
        }
        assert_eq!(
            environment.map().at(1, 0),
            Rgb::new(0.0, 1.0, 0.0),
            "{wrong} is 0"
        );
    }
}

#[test]
#[should_panic(expected = "a map of directions has texels")]
fn a_map_without_texels_is_refused() {
    drop(Environment::new(Image::from_fn(0, 0, |_, _| Rgb::BLACK)));
}
