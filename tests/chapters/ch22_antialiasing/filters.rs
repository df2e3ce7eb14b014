//! Filters: weights, averages, and pictures made by them.

use super::pattern;
use glam::{Vec2, vec2};
use rand::{Rng, RngExt};
use raybook::image::{Image, rgb::Rgb};
use raybook::math::pcg::Pcg;
use raybook::render::film::{Film, Progress};
use raybook::render::{followed::Followed, supersample};
use raybook::sample::filter::{Filter, Sample, pixel_average};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicUsize, Ordering};

fn film(samples: usize) -> Film<'static> {
    Film {
        seed: 3,
        threads: 2,
        ..Film::new(24, 18, samples)
    }
}

fn by(samples: usize, filter: Filter) -> Film<'static> {
    Film {
        filter,
        ..film(samples)
    }
}

#[test]
fn every_filter_is_even_and_ends_at_its_radius() {
    for filter in Filter::ALL {
        for (x, y) in [(0.1, 0.3), (0.45, 0.2), (0.9, 1.4), (1.7, 0.1)] {
            let weight = filter.weight(vec2(x, y));
            for mirrored in [vec2(-x, y), vec2(x, -y), vec2(y, x)] {
                let other = filter.weight(mirrored);
                assert!((weight - other).abs() < 1e-6, "{}: even", filter.name);
            }
        }
        assert_eq!(
            filter.weight(vec2(filter.radius, 0.0)),
            0.0,
            "{}: ends",
            filter.name
        );
        assert_eq!(filter.weight(vec2(0.0, -2.5)), 0.0, "{}: ends", filter.name);
        let (inner, edge) = (
            filter.weight(Vec2::ZERO),
            filter.weight(vec2(0.999 * filter.radius, 0.0)),
        );
        assert!(inner > 0.0, "{}: the centre counts", filter.name);
        assert!(
            filter.radius < 1.0 || edge.abs() < 0.01 * inner,
            "{}: continuous",
            filter.name
        );
    }
}

#[test]
fn the_tent_and_mitchells_cubic_add_up_to_one_over_the_pixels() {
    // A partition of unity: a wall of one colour has it in every sample.
    for filter in [Filter::TENT, Filter::MITCHELL, Filter::BOX] {
        for x in [0.0, 0.13, 0.4, 0.77] {
            let sum: f32 = (-3..=3)
                .map(|i| filter.weight(vec2(x + i as f32, 0.0)))
                .sum();
            let height = filter.weight(Vec2::ZERO) / filter.profile.map_or(1.0, |f| f(0.0));
            assert!(
                (sum / height - 1.0).abs() < 1e-5,
                "{} at {x}: {sum}",
                filter.name
            );
        }
    }
}

#[test]
fn mitchells_cubic_has_its_known_values() {
    for (x, expected) in [
        (0.0, 8.0 / 9.0),
        (1.0, 1.0 / 18.0),
        (2.0, 0.0),
        (1.5, -5.0 / 144.0),
    ] {
        let mitchell = Filter::MITCHELL.profile.expect("a cubic");
        let got = mitchell(x / 2.0);
        assert!(
            (got - expected).abs() < 1e-6,
            "k({x}) is {got}, not {expected}"
        );
    }
}

#[test]
fn an_average_divides_by_the_weights() {
    let sample = |x, v| Sample {
        offset: vec2(x, 0.0),
        radiance: Rgb::gray(v),
    };
    let two = [sample(0.0, 1.0), sample(0.5, 4.0)];
    let got = pixel_average(&Filter::TENT, &two);
    assert!(
        (got.g - 2.0).abs() < 1e-6,
        "(1 + ½ · 4)/(1 + ½) = 2, not {}",
        got.g
    );
    assert_eq!(
        pixel_average(&Filter::TENT, &[]),
        Rgb::BLACK,
        "no sample is black"
    );
    assert_eq!(
        pixel_average(&Filter::BOX, &[sample(3.0, 1.0)]),
        Rgb::BLACK,
        "none in reach"
    );
}

#[test]
fn a_white_wall_stays_white_by_every_filter_and_pattern() {
    for filter in Filter::ALL {
        let white =
            supersample::supersample(&by(4, filter), pattern("jittered"), |_, _| Rgb::WHITE);
        let off = white
            .pixels()
            .iter()
            .map(|p| (p.g - 1.0).abs())
            .fold(0.0, f32::max);
        assert!(off < 1e-5, "{}: off by {off}", filter.name);
    }
}

#[test]
fn the_box_filter_is_the_mean_of_the_pixels_own_samples() {
    let ramp = |place: Vec2, _: &mut dyn Rng| Rgb::new(place.x, place.y, place.x * place.y);
    let mean = supersample::supersample(&film(9), pattern("jittered"), ramp);
    // As wide as the pixel, within rounding: the samples go the way of the wide filters.
    let wide = Filter {
        radius: 0.5 * (1.0 + f32::EPSILON),
        ..Filter::BOX
    };
    let boxed = supersample::supersample(&by(9, wide), pattern("jittered"), ramp);
    for (one, other) in mean.pixels().iter().zip(boxed.pixels()) {
        let off = (one.r - other.r).abs().max((one.b - other.b).abs());
        assert!(off < 1e-5, "{one:?} and {other:?}");
    }
}

#[test]
fn wider_filters_blur_more_and_mitchell_overshoots() {
    let edge = |place: Vec2, _: &mut dyn Rng| Rgb::gray(f32::from(u8::from(place.x > 0.5)));
    let of = |filter| supersample::supersample(&by(64, filter), pattern("regular-grid"), edge);
    let row = |filter| -> Vec<f32> { (0..24).map(|x| of(filter).at(x, 9).g).collect() };
    let grey = |row: &[f32]| row.iter().filter(|v| (0.02..0.98).contains(*v)).count();
    assert_eq!(grey(&row(Filter::BOX)), 0, "the edge is between two pixels");
    assert_eq!(grey(&row(Filter::TENT)), 2, "a pixel on each side");
    assert!(
        row(Filter::MITCHELL).iter().any(|v| *v > 1.005),
        "brighter than white"
    );
    assert!(
        row(Filter::GAUSSIAN)
            .iter()
            .all(|v| (-1e-6..1.00001).contains(v)),
        "never"
    );
}

#[test]
fn one_thread_and_four_make_the_same_picture() {
    let noise = |place: Vec2, rng: &mut dyn Rng| Rgb::gray(place.x + rng.random::<f32>());
    let with = |threads| Film { threads, ..film(4) };
    let one = supersample::supersample(&with(1), pattern("poisson-disk"), noise);
    let four = supersample::supersample(&with(4), pattern("poisson-disk"), noise);
    assert!(one.same_bits(&four), "bit for bit");
}

#[test]
fn a_filtered_picture_that_is_no_longer_wanted_places_no_more_points() {
    let placed = AtomicUsize::new(0);
    let points = |_: usize, _: usize, _: &mut Pcg| {
        placed.fetch_add(1, Ordering::Relaxed);
        vec![Vec2::splat(0.5)]
    };
    let stopped = Film {
        progress: &|_| ControlFlow::Break(()),
        ..by(1, Filter::MITCHELL)
    };
    let picture = supersample::supersample(&stopped, &points, |_, _| Rgb::WHITE);
    let placed = placed.into_inner();
    assert!(placed <= 16 * stopped.threads, "{placed} pixels");
    let drawn = picture.pixels().iter().filter(|p| **p != Rgb::BLACK);
    assert!(drawn.count() <= 16 * stopped.threads, "nor does it filter");
}

#[test]
fn every_pixel_may_have_points_of_its_own() {
    // One sample at the left, four at the right: each counts by itself.
    let right = |x: usize| 2 * x >= film(1).width;
    let points =
        |x: usize, _: usize, _: &mut Pcg| vec![Vec2::splat(0.5); if right(x) { 4 } else { 1 }];
    let counted = |_: Vec2, _: &mut dyn Rng| Followed {
        radiance: Rgb::WHITE,
        rays: 1,
    };
    let rays = AtomicUsize::new(0);
    let count: &Progress = &|done| {
        rays.fetch_add(done.rays as usize, Ordering::Relaxed);
        ControlFlow::Continue(())
    };
    let boxed = Film {
        progress: count,
        ..film(1)
    };
    let tent = Film {
        filter: Filter::TENT,
        ..boxed
    };
    let expected = boxed.height
        * (0..boxed.width)
            .map(|x| if right(x) { 4 } else { 1 })
            .sum::<usize>();
    let check = |picture: Image| {
        assert_eq!(rays.swap(0, Ordering::Relaxed), expected);
        assert!(picture.pixels().iter().all(|p| *p == Rgb::WHITE));
    };
    check(supersample::supersample(&boxed, &points, counted));
    check(supersample::supersample(&tent, &points, counted));
}
