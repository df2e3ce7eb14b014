//! Denoising: noise goes, and what is known of a picture stays.

use glam::Vec3;
use rand::RngExt;
use raybook::image::denoise::{Guide, denoise};
use raybook::image::{Image, rgb::Rgb};
use raybook::inside::denoise::{differences, plane};
use raybook::math::pcg;

/// On a processor without AVX2, both are the same code.
#[test]
fn wide_vectors_change_no_bit_of_a_plane() {
    let picture = step(1);
    let around: Vec<_> = (0..300).map(|q| (q, 1.0 / (1.0 + q as f32))).collect();
    let [plain, wide] = plane(&picture, 100, &around);
    let bits = |sums: &[(Rgb, f32)]| -> Vec<u32> {
        let numbers = |(sum, weight): &(Rgb, f32)| [sum.r, sum.g, sum.b, *weight];
        sums.iter().flat_map(numbers).map(f32::to_bits).collect()
    };
    assert!(plain.iter().any(|(sum, _)| *sum != Rgb::BLACK));
    assert_eq!(bits(&plain), bits(&wide));
}

/// A step from dark to bright in the middle, with noise of a tenth.
fn step(seed: u64) -> Image {
    let mut rng = pcg::stream(seed, 3);
    Image::from_fn(48, 24, |x, _| {
        let radiance = if x < 24 { 0.2 } else { 1.0 };
        Rgb::gray(radiance * rng.random_range(0.7..1.3))
    })
}

#[test]
fn noise_falls_and_the_edge_stays() {
    let pictures = [step(1), step(2)];
    let clean = denoise(&pictures, &[]);
    let error = |picture: &Image, x: usize, true_value: f32| {
        let off = |y| (picture.at(x, y).g / true_value - 1.0).powi(2);
        (0..24).map(off).sum::<f32>() / 24.0
    };
    for (x, value) in [(12, 0.2), (36, 1.0), (23, 0.2), (24, 1.0)] {
        let before = 0.5 * error(&pictures[0], x, value);
        let after = error(&clean, x, value);
        assert!(after < 0.25 * before, "column {x}: {before} and {after}");
    }
    let mean = |from: usize| {
        let row = |y| (from..from + 24).map(|x| clean.at(x, y).g).sum::<f32>();
        (0..24).map(row).sum::<f32>() / 576.0
    };
    assert!((mean(0) / 0.2 - 1.0).abs() < 0.02 && (mean(24) - 1.0).abs() < 0.02);
}

#[test]
fn a_pixel_that_only_one_picture_has_is_no_pixel_of_the_view() {
    let mut pictures = [step(1), step(2)];
    pictures[0].set(40, 10, Rgb::gray(500.0));
    let clean = denoise(&pictures, &[]);
    for (x, y) in [(40, 10), (41, 10), (38, 12)] {
        assert!(clean.at(x, y).g < 1.2, "{}", clean.at(x, y).g);
    }
}

#[test]
fn a_highlight_stays_as_small_as_it_is() {
    let in_the_sun = |x: usize, y: usize| x.abs_diff(24) <= 1 && y.abs_diff(12) <= 1;
    let metal = |seed: u64| {
        let mut rng = pcg::stream(seed, 5);
        Image::from_fn(48, 24, |x, y| {
            let radiance = if in_the_sun(x, y) { 500.0 } else { 0.3 };
            Rgb::gray(radiance * rng.random_range(0.5..1.5))
        })
    };
    let clean = denoise(&[metal(1), metal(2)], &[]);
    for (x, y) in (0..48 * 24).map(|i| (i % 48, i / 48)) {
        let seen = clean.at(x, y).g;
        assert_eq!(
            in_the_sun(x, y),
            seen > 1.0,
            "{seen} in column {x}, row {y}"
        );
    }
}

#[test]
fn a_first_order_function_stays_as_it_is() {
    let slope = Image::from_fn(40, 30, |x, y| {
        let (x, y) = (x as f32, y as f32);
        Rgb::new(1.0 + 0.1 * x, 1.0 + 0.05 * y, 2.0 + 0.02 * x - 0.01 * y)
    });
    let clean = denoise(&[slope.clone(), slope.clone()], &[]);
    for (clean, true_value) in clean.pixels().iter().zip(slope.pixels()) {
        for (clean, true_value) in clean.channels().into_iter().zip(true_value.channels()) {
            assert!(
                (clean / true_value - 1.0).abs() < 0.003,
                "{clean} for {true_value}"
            );
        }
    }
}

#[test]
fn what_a_guide_knows_stays_sharp_in_noise_that_hides_it() {
    let dark = |x: usize, y: usize| (x + y).is_multiple_of(2);
    let paper = |seed: u64| {
        let mut rng = pcg::stream(seed, 4);
        Image::from_fn(48, 48, |x, y| {
            let colour = if dark(x, y) { 0.4 } else { 0.6 };
            Rgb::gray(colour * rng.random_range(0.0..2.0))
        })
    };
    let guides = |x: usize, y: usize| Guide {
        colour: Rgb::gray(if dark(x, y) { 0.4 } else { 0.6 }),
        normal: Vec3::Y,
        nearness: 1.0,
    };
    let guides: Vec<_> = (0..48 * 48).map(|i| guides(i % 48, i / 48)).collect();
    let error = |guides: &[Guide]| {
        let clean = denoise(&[paper(1), paper(2)], guides);
        let off = |(i, p): (usize, &Rgb)| {
            let colour = if dark(i % 48, i / 48) { 0.4 } else { 0.6 };
            (p.g - colour).powi(2)
        };
        (clean.pixels().iter().enumerate().map(off).sum::<f32>() / 48.0 / 48.0).sqrt()
    };
    let (known, unknown) = (error(&guides), error(&[]));
    assert!(known < 0.04, "{known}");
    assert!(
        unknown > 0.08,
        "{unknown}: without guides the squares are lost"
    );
}

#[test]
#[should_panic(expected = "one guide per pixel")]
fn guides_of_another_picture_are_refused() {
    denoise(&[step(1), step(2)], &[Guide::default()]);
}

/// On a processor without AVX2, both are the same code.
#[test]
fn wide_vectors_change_no_bit() {
    const HIGH: usize = 24;
    let mut rng = pcg::stream(7, 0);
    let mut noise = || Image::from_fn(37, HIGH, |_, _| Rgb::gray(rng.random()));
    let [picture, variance] = [noise(), noise()];
    for by in [[0, 0], [3, -2], [-12, 5], [1, 12]] {
        let sums = differences([&picture, &variance], by, &(0..HIGH));
        let [plain, wide] = sums.map(|sums| sums.into_iter().map(f32::to_bits).collect::<Vec<_>>());
        assert!(!plain.is_empty(), "step {by:?} leads to pixels");
        assert_eq!(plain, wide, "step {by:?}");
    }
}
