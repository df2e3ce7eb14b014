//! The noise-aware comparison of pictures: right ones with another seed pass, and a table of planted errors is caught.

use glam::{Vec3, vec2};
use rand::RngExt;
use raybook::camera::Camera;
use raybook::camera::pinhole::{PLANE_HEIGHT, Pinhole};
use raybook::image::{Image, rgb::Rgb};
use raybook::math::pcg;
use raybook::render::{film::Film, mis::Strategy, path::Path};
use raybook::sample::pattern::jittered::jittered;
use raybook::scene::cornell;
use raybook_common::noisy::{BATCHES, Noisy};
use std::sync::LazyLock;

/// Width and height of the pictures.
const SIZE: usize = 40;
/// Samples per pixel of a batch: 16 batches are 512.
const SAMPLES: usize = 32;
/// Number of batches that are drawn; all comparisons choose 16 and 16 others of them.
const POOL: usize = 40;
/// Number of right pictures that are compared.
const RUNS: u64 = 200;

const ALL: Path = Path {
    depth: 12,
    roulette_after: 3,
    strategy: Strategy::Both,
};

fn render(path: Path, seed: u64) -> Image {
    let scene = cornell::cornell_box();
    let (eye, zoom) = (cornell::EYE, cornell::ZOOM * PLANE_HEIGHT);
    let camera = Pinhole::look_at(eye, eye + Vec3::Z, Vec3::Y, zoom, 1.0).expect("a camera");
    let film = Film {
        seed,
        threads: 2,
        ..Film::new(SIZE, SIZE, SAMPLES)
    };
    // Jittered samples, whose noise is nearly normal, as the bounds suppose: the film's own, which are spread more evenly, take
    // only a few values where an edge runs through a pixel.
    film.render_pixels(|x, y, rng| {
        let places = jittered(8, SAMPLES / 8, rng);
        let seen = places.into_iter().map(|place| {
            let place = (vec2(x as f32, y as f32) + place) / SIZE as f32;
            path.radiance(&scene, &camera.central_ray(place), rng)
        });
        seen.sum::<Rgb>() / SAMPLES as f32
    })
}

static BATCH: LazyLock<Vec<Image>> =
    LazyLock::new(|| (0..POOL as u64).map(|seed| render(ALL, seed)).collect());

/// 16 batches, and 16 others.
fn split(seed: u64) -> [Noisy; 2] {
    let mut rng = pcg::stream(seed, 99);
    let mut order: Vec<&Image> = BATCH.iter().collect();
    for i in (1..order.len()).rev() {
        order.swap(i, rng.random_range(0..=i));
    }
    [&order[..BATCHES], &order[BATCHES..2 * BATCHES]].map(Noisy::of)
}

#[test]
fn right_pictures_raise_no_alarm() {
    for seed in 0..RUNS {
        let [reference, other] = split(seed);
        let verdict = reference.compare(&other.image());
        assert_eq!(verdict, Ok(()), "split {seed} of the right batches");
    }
}

#[test]
fn the_same_light_by_another_strategy_raises_no_alarm() {
    let [reference, _] = split(0);
    let path = Path {
        strategy: Strategy::Light,
        roulette_after: 1,
        ..ALL
    };
    let others: Vec<_> = (1000..1016).map(|seed| render(path, seed)).collect();
    let picture = Noisy::of(&others.iter().collect::<Vec<_>>()).image();
    assert_eq!(
        reference.compare(&picture),
        Ok(()),
        "towards the light only"
    );
}

/// The errors that the comparison must see.
fn planted(right: &Image) -> Vec<(&'static str, Image)> {
    let only = |place: fn(usize, usize) -> bool, change: fn(Rgb) -> Rgb| {
        let change = move |x, y, v| if place(x, y) { change(v) } else { v };
        Image::from_fn(SIZE, SIZE, |x, y| change(x, y, right.at(x, y)))
    };
    let from = |place: fn(usize, usize) -> (usize, usize)| {
        Image::from_fn(SIZE, SIZE, |x, y| {
            let (x, y) = place(x, y);
            right.at(x, y)
        })
    };
    vec![
        ("a black column", only(|x, _| x == 20, |_| Rgb::BLACK)),
        ("a black row", only(|_, y| y == 12, |_| Rgb::BLACK)),
        (
            "a pixel to the left",
            from(|x, y| ((x + 1).min(SIZE - 1), y)),
        ),
        (
            "a pixel to the right",
            from(|x, y| (x.saturating_sub(1), y)),
        ),
        ("a pixel up", from(|x, y| (x, (y + 1).min(SIZE - 1)))),
        ("a pixel down", from(|x, y| (x, y.saturating_sub(1)))),
        ("1 % too bright everywhere", right.map(|v| v * 1.01)),
        ("1 % too dark everywhere", right.map(|v| v * 0.99)),
        ("gamma 1.02", right.map(|v| v.map(|v| v.powf(1.02)))),
        (
            "3 % too bright in a quarter",
            only(|x, y| x < SIZE / 2 && y < SIZE / 2, |v| v * 1.03),
        ),
        (
            "2 % too much red",
            right.map(|v| Rgb::new(1.02 * v.r, v.g, v.b)),
        ),
        ("left and right swapped", from(|x, y| (SIZE - 1 - x, y))),
        (
            "a black pixel",
            only(|x, y| (x, y) == (25, 18), |_| Rgb::BLACK),
        ),
        (
            "a firefly",
            only(|x, y| (x, y) == (9, 30), |v| v + Rgb::gray(20.0)),
        ),
        (
            "a black tile",
            only(|x, y| x / 4 == 2 && y / 4 == 7, |_| Rgb::BLACK),
        ),
        (
            "not a number",
            only(|x, y| (x, y) == (3, 3), |_| Rgb::gray(f32::NAN)),
        ),
    ]
}

#[test]
fn every_planted_error_is_caught() {
    for seed in 0..10 {
        let [reference, other] = split(seed);
        for (name, wrong) in planted(&other.image()) {
            let found = reference.compare(&wrong);
            assert!(found.is_err(), "{name} passes with split {seed}");
            if seed == 0 {
                println!("{name:30} {:?}", found.expect_err("it was caught"));
            }
        }
    }
}

#[test]
fn an_integrator_that_is_a_little_wrong_is_caught() {
    let [reference, _] = split(0);
    let cut = Path { depth: 4, ..ALL };
    let batches: Vec<_> = (2000..2016).map(|seed| render(cut, seed)).collect();
    let picture = Noisy::of(&batches.iter().collect::<Vec<_>>()).image();
    let found = reference.compare(&picture);
    assert!(found.is_err(), "light after the fourth surface is left out");
}
