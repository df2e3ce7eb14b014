//! How samples are spread over the lens.

use crate::ch19_depth_of_field::camera;
use glam::{Vec2, vec2};
use rand::{Rng, RngExt};
use raybook::camera::Camera;
use raybook::camera::aperture::Aperture;
use raybook::camera::thin_lens::ThinLens;
use raybook::image::{Image, rgb::Rgb};
use raybook::math::ray::Ray;
use raybook::render::film::Film;
use raybook::sample::even::Even;
use raybook_common::statistics::Mean;

fn film(samples: usize, seed: u64, threads: usize) -> Film<'static> {
    Film {
        seed,
        threads,
        ..Film::new(24, 16, samples)
    }
}

/// The film's size in metres: a pixel is small beside the circle of confusion of what is far behind.
const PLANE: Vec2 = vec2(0.0018, 0.0012);

fn lens() -> ThinLens {
    camera(PLANE, 2.0, 2.0, Aperture::Round)
}

/// What a lens sees with low-discrepancy numbers.
fn through_lens(
    film: &Film,
    camera: &ThinLens,
    see: impl Fn(&Ray, &mut Even) -> Rgb + Sync,
) -> Image {
    film.evenly(|place, numbers| see(&camera.ray(place, numbers.pair()), numbers))
}

/// Stripes far behind the plane in focus.
fn stripes(ray: &Ray, _: &mut impl Rng) -> Rgb {
    let p = ray.at(12.0 / -ray.direction.z);
    Rgb::gray(f32::from((2.0 * p.x + 0.7 * p.y).fract().abs() < 0.5))
}

/// The mean of squared differences between two pictures that differ in their seed only.
fn noise(draw: impl Fn(u64) -> Image) -> f64 {
    let (a, b) = (draw(1), draw(2));
    let pairs = a.pixels().iter().zip(b.pixels());
    pairs
        .map(|(a, b)| f64::from(a.g - b.g).powi(2))
        .sum::<f64>()
        / a.pixels().len() as f64
}

#[test]
fn samples_spread_over_the_lens_have_less_noise_than_random_ones_and_the_same_mean() {
    let camera = lens();
    let spread = |seed| through_lens(&film(64, seed, 2), &camera, stripes);
    let random = |seed| {
        film(64, seed, 2).sample(|place, rng| {
            let ray = camera.ray(place, vec2(rng.random(), rng.random()));
            stripes(&ray, rng)
        })
    };
    let ratio = noise(spread) / noise(random);
    assert!(
        ratio < 0.35,
        "the noise's variance is {ratio} of that by chance"
    );
    let means = |draw: &dyn Fn(u64) -> Image| {
        let mean = |image: Image| {
            let sum: f64 = image.pixels().iter().map(|p| f64::from(p.g)).sum();
            sum / image.pixels().len() as f64
        };
        Mean::of(&(0..16).map(|seed| mean(draw(seed))).collect::<Vec<_>>())
    };
    means(&spread).assert_same(&means(&random), "the mean of the picture");
}

#[test]
fn a_place_in_the_pixel_says_nothing_about_the_point_of_the_lens() {
    const SAMPLES: usize = 64;
    let camera = lens();
    let squares = (0..32).flat_map(|seed| {
        let picture = through_lens(&film(SAMPLES, seed, 1), &camera, |ray, _| {
            let off = (ray.origin - camera.view.focal_point) / camera.lens.aperture();
            let in_focus = ray.at(2.0 / -ray.direction.z) - camera.view.focal_point;
            let step = PLANE.x / camera.view.focal_length * 2.0 / 24.0;
            let place = (in_focus.x / step + 12.0).rem_euclid(1.0) - 0.5;
            Rgb::gray(off.x * place)
        });
        let squares: Vec<_> = picture.pixels().iter().map(|p| p.g * p.g).collect();
        squares
    });
    let squares: Vec<_> = squares.collect();
    let mean = squares.iter().sum::<f32>() / squares.len() as f32;
    // A place that is uniform over a pixel has the variance 1/12, one over a disc of radius ½ has 1/16 in each direction.
    let by_chance = 1.0 / (12.0 * 16.0 * SAMPLES as f32);
    assert!(
        (0.5..2.0).contains(&(mean / by_chance)),
        "in each pixel the two have as much to do with each other as by chance: {} of that",
        mean / by_chance
    );
}

#[test]
fn a_single_sample_is_somewhere_on_the_lens() {
    let camera = lens();
    let picture = through_lens(&film(1, 1, 1), &camera, |ray, _| {
        Rgb::gray(2.0 * ray.origin.distance(camera.view.focal_point) / camera.lens.aperture())
    });
    let mean = picture.pixels().iter().map(|p| p.g).sum::<f32>() / picture.pixels().len() as f32;
    assert!(
        (mean - 2.0 / 3.0).abs() < 0.04,
        "the mean radius of a disc is 2/3, not {mean}"
    );
    let places = through_lens(&film(1, 1, 1), &camera, |ray, _| {
        let off = (ray.origin - camera.view.focal_point) / camera.lens.aperture();
        Rgb::new(off.x, off.y, 0.0)
    });
    let sum: Rgb = places.pixels().iter().copied().sum();
    let mean = sum / places.pixels().len() as f32;
    assert!(
        mean.r.abs() < 0.05 && mean.g.abs() < 0.05,
        "and its middle is the lens' middle, not {mean:?}"
    );
}

#[test]
fn the_picture_does_not_depend_on_the_number_of_threads() {
    let camera = lens();
    let [one, three] = [1, 3].map(|threads| through_lens(&film(5, 7, threads), &camera, stripes));
    assert!(one.pixels() == three.pixels(), "bit for bit");
}
