//! The film loop that spares samples where they are alike.

use crate::ch01_rays::film::film;
use glam::Vec2;
use raybook::image::rgb::Rgb;
use raybook_common::statistics::Mean;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A disc on a soft shade.
fn disc(place: Vec2) -> Rgb {
    let inside = place.distance(Vec2::splat(0.5)) < 0.28;
    Rgb::gray(if inside { 0.1 } else { 0.7 + 0.1 * place.x })
}

#[test]
fn edges_get_all_samples_and_what_is_even_gets_four() {
    let asked = AtomicUsize::new(0);
    let picture = film(100, 100, 64, 2).refine(|place, _| {
        asked.fetch_add(1, Ordering::Relaxed);
        disc(place)
    });
    // Four for each pixel, and up to 60 more in a band of three or four pixels along a rim of 176.
    let more = asked.into_inner() - 40_000;
    assert!((10_000..45_000).contains(&more), "{more} samples more");
    let exact = film(100, 100, 4096, 2).sample(|place, _| disc(place));
    for (a, b) in picture.pixels().iter().zip(exact.pixels()) {
        // An edge that hardly touches a pixel may be missed by up to an eighth of its step of 0.65.
        assert!((a.g - b.g).abs() < 0.09, "{} is not {}", a.g, b.g);
    }
}

#[test]
fn noise_is_the_same_on_any_number_of_threads_and_has_the_same_mean_as_by_chance() {
    let noisy = |v: Vec2, u: Vec2| Rgb::gray(if u.x * u.y < 0.5 * v.x { 0.9 } else { 0.1 });
    let even = |seed, threads| {
        let mut film = film(24, 16, 32, threads);
        film.seed = seed;
        film.refine(|place, numbers| noisy(place, numbers.pair()))
    };
    assert!(
        even(3, 1).pixels() == even(3, 3).pixels(),
        "bit for bit on three threads"
    );
    let chance = |seed| {
        use rand::RngExt;
        let mut film = film(24, 16, 32, 2);
        film.seed = seed;
        film.sample(|place, rng| noisy(place, Vec2::new(rng.random(), rng.random())))
    };
    let mean = |image: raybook::image::Image| {
        let sum: f64 = image.pixels().iter().map(|p| f64::from(p.g)).sum();
        sum / image.pixels().len() as f64
    };
    let of = |draw: &dyn Fn(u64) -> raybook::image::Image| {
        Mean::of(&(0..24).map(|seed| mean(draw(seed))).collect::<Vec<_>>())
    };
    of(&|seed| even(seed, 2)).assert_same(&of(&chance), "the mean of the picture");
}
