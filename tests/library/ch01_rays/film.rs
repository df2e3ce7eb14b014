//! The film loop: the same picture on any number of threads, and means without bias.

use glam::vec2;
use rand::RngExt;
use raybook::prelude::*;
use raybook::render::adaptive::Limits;
use raybook::render::film::{Done, SILENT};
use raybook::render::followed::Followed;
use raybook::render::needs_more::StoppingRule;
use raybook::sample::{filter::Filter, pattern};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};

pub(crate) fn film(width: usize, height: usize, samples: usize, threads: usize) -> Film<'static> {
    Film {
        seed: 7,
        threads,
        ..Film::new(width, height, samples)
    }
}

#[test]
fn the_picture_does_not_depend_on_the_number_of_threads() {
    // 37 × 29 is no multiple of a tile; the radiance takes a varying number of random numbers.
    let draw = |threads, seed| {
        Film {
            seed,
            ..film(37, 29, 3, threads)
        }
        .sample(|place, rng| {
            let more: f32 = rng.random();
            let last: f32 = if more < 0.5 { rng.random() } else { 0.0 };
            Rgb::new(place.x, more, last)
        })
    };
    let one = draw(1, 7);
    for threads in [2, 5] {
        assert!(
            one.same_bits(&draw(threads, 7)),
            "{threads} threads draw the same bits as one"
        );
    }
    assert!(!one.same_bits(&draw(1, 8)), "another seed draws other bits");
}

#[test]
fn every_pixel_gets_its_own_place_whatever_the_size() {
    for (width, height) in [(1, 1), (1, 40), (17, 16), (33, 15), (48, 32)] {
        let picture = film(width, height, 1, 3).sample(|place, _| Rgb::new(place.x, place.y, 1.0));
        assert_eq!(
            (picture.width(), picture.height()),
            (width, height),
            "the size asked for"
        );
        for y in 0..height {
            for x in 0..width {
                let Rgb { r, g, b } = picture.at(x, y);
                let centre = vec2(
                    (x as f32 + 0.5) / width as f32,
                    (y as f32 + 0.5) / height as f32,
                );
                assert_eq!(
                    vec2(r, g),
                    centre,
                    "one sample is at the centre of ({x}, {y}) of {width}×{height}"
                );
                assert_eq!(b, 1.0, "the pixel was drawn");
            }
        }
    }
}

#[test]
fn progress_adds_up_to_all_pixels_and_all_rays() {
    for (width, height, threads) in [(1, 1, 1), (50, 31, 1), (50, 31, 4), (16, 16, 2)] {
        let (done, followed) = (AtomicUsize::new(0), AtomicU64::new(0));
        let progress = |Done { pixels, rays }: Done| {
            done.fetch_add(pixels, Ordering::Relaxed);
            followed.fetch_add(rays, Ordering::Relaxed);
            ControlFlow::Continue(())
        };
        let film = Film {
            progress: &progress,
            ..film(width, height, 2, threads)
        };
        film.sample(|_, _| Followed {
            radiance: Rgb::BLACK,
            rays: 3,
        });
        assert_eq!(
            done.into_inner(),
            width * height,
            "{width}×{height} on {threads} threads"
        );
        let rays = 2 * 3 * (width * height) as u64;
        assert_eq!(followed.into_inner(), rays, "3 rays for each of 2 samples");
    }
}

#[test]
fn the_mean_of_samples_is_the_mean_over_the_pixel() {
    // x² over [0, 1] has the mean 1/3. The shift of each pixel is random, so that many pixels have no bias, whatever the
    // number of samples: the standard deviation of one sample is √(4/45) = 0.298, that of 10,000 pixels' mean 0.003 at
    // most; five of them are allowed.
    for samples in [2, 3, 5, 16] {
        let picture = film(100, 100, samples, 2).sample(|place, _| {
            let in_pixel = (100.0 * place).fract();
            Rgb::new(
                in_pixel.x.powi(2),
                in_pixel.y.powi(2),
                in_pixel.x * in_pixel.y,
            )
        });
        let sum: Rgb = picture.pixels().iter().copied().sum();
        let mean = sum / 10_000.0;
        assert!(
            (mean.r - 1.0 / 3.0).abs() < 0.015,
            "x² with {samples} samples: {}",
            mean.r
        );
        assert!(
            (mean.g - 1.0 / 3.0).abs() < 0.015,
            "y² with {samples} samples: {}",
            mean.g
        );
        assert!(
            (mean.b - 0.25).abs() < 0.015,
            "xy with {samples} samples: {}",
            mean.b
        );
    }
}

#[test]
fn many_samples_still_fill_the_pixel_evenly() {
    // 2²⁰ samples: counted in f32, i·0.75 has lost all but 4 binary digits by then, and rows of the pixel stay empty.
    let samples = 1 << 20;
    let mean = film(1, 1, samples, 1).sample(|place, _| {
        let fine = (1024.0 * place.x).fract();
        Rgb::new(fine, fine * fine, place.x * place.y)
    });
    let Rgb { r, g, b } = mean.at(0, 0);
    // Within a 1024th of the pixel, all points are shifted alike, by up to 1/2048 of it.
    assert!(
        (r - 0.5).abs() < 6e-4,
        "the mean within a 1024th of the pixel is {r}"
    );
    assert!((g - 1.0 / 3.0).abs() < 6e-4, "and that of its square {g}");
    assert!((b - 0.25).abs() < 1e-5, "xy has the mean {b}");
}

#[test]
fn an_edge_through_pixels_is_found_by_the_mean() {
    // A half plane through every pixel at x = 0.3: 64 of Sobol's points have a discrepancy below 4/64.
    let picture = film(8, 8, 64, 1).sample(|place, _| {
        if (8.0 * place.x).fract() < 0.3 {
            Rgb::WHITE
        } else {
            Rgb::BLACK
        }
    });
    for p in picture.pixels() {
        assert!(
            (p.r - 0.3).abs() < 4.0 / 64.0,
            "30 % of the pixel are white, not {}",
            p.r
        );
    }
}

#[test]
fn a_film_that_is_told_to_stop_ends_after_a_row_of_pixels() {
    for threads in [1, 3] {
        let rows = AtomicUsize::new(0);
        let stop = |done: Done| {
            assert_eq!(done.pixels, 16, "a row of a tile");
            rows.fetch_add(1, Ordering::Relaxed);
            ControlFlow::Break(())
        };
        let film = Film {
            progress: &stop,
            ..film(160, 160, 1, threads)
        };
        let picture = film.sample(|_, _| Rgb::WHITE);
        let rows = rows.into_inner();
        assert!(
            (1..=threads).contains(&rows),
            "{rows} rows on {threads} threads"
        );
        let drawn = picture.pixels().iter().filter(|p| **p == Rgb::WHITE);
        assert_eq!(drawn.count(), rows * 16, "what is drawn is kept");
    }
}

#[test]
fn a_refined_picture_that_is_told_to_stop_keeps_its_first_samples() {
    let rows = AtomicUsize::new(0);
    let stop = |_| match rows.fetch_add(1, Ordering::Relaxed) {
        0..4 => ControlFlow::Continue(()),
        _ => ControlFlow::Break(()),
    };
    let film = Film {
        progress: &stop,
        ..film(160, 160, 16, 1)
    };
    let picture = film.refine(|_, _| Rgb::WHITE);
    let drawn = picture.pixels().iter().filter(|p| **p == Rgb::WHITE);
    assert_eq!(drawn.count(), 5 * 16, "five rows of a tile");
    assert_eq!(rows.into_inner(), 5, "nothing is begun after the end");
}

#[test]
fn what_was_ended_is_not_denoised() {
    let noise = |film: &Film| {
        Film {
            progress: SILENT,
            ..*film
        }
        .sample(|_, rng| Rgb::gray(rng.random()))
    };
    let film = film(24, 24, 2, 1);
    let ended = |_: Done| ControlFlow::Break(());
    let one = noise(&Film { samples: 1, ..film });
    let stopped = Film {
        progress: &ended,
        ..film
    };
    assert!(
        stopped.denoised(&[], noise).same_bits(&one),
        "the first half, as it is"
    );
    assert!(
        !film.denoised(&[], noise).same_bits(&one),
        "else it is denoised"
    );

    // Two threads denoise: each asks at most twice more after the end, before a row and before a band of rows.
    let asked = AtomicUsize::new(0);
    let later = |_: Done| match asked.fetch_add(1, Ordering::Relaxed) {
        0..20 => ControlFlow::Continue(()),
        _ => ControlFlow::Break(()),
    };
    let stopped = Film {
        progress: &later,
        ..film
    };
    let left = stopped.denoised(&[], noise);
    assert!(left.same_bits(&one), "also when denoising has begun");
    let asked = asked.into_inner();
    assert!(
        asked <= 20 + 2 * 2 + 1,
        "denoising ends at once, and not after {asked} questions"
    );
}

#[test]
fn every_sampler_draws_the_same_picture_but_for_its_noise() {
    let ball = Thing::new(
        Sphere::new(Vec3::ZERO, 1.0),
        Lambert {
            albedo: Rgb::gray(0.5),
        },
    );
    let scene = Scene::new(vec![ball], vec![]).surrounded_by(Rgb::BLACK, |_| Rgb::WHITE);
    let camera = Pinhole::look_at(
        vec3(0.0, 0.0, 5.0),
        Vec3::ZERO,
        Vec3::Y,
        focal_length(40.0),
        1.0,
    )
    .unwrap();
    // What the lens sees from everywhere on it, with the same view.
    let lens = ThinLens::with_view(&camera, 0.001, 4.0, Aperture::Round).unwrap();
    // In a square view of 40° the ball is a disc of this radius, in sides of the square.
    let radius = (0.2_f32.asin().tan() / 20_f32.to_radians().tan()) * 0.5;
    let exact = 1.0 - 0.5 * std::f32::consts::PI * radius * radius;
    let limits = Limits { first: 4, most: 64 };
    let samplers = [
        Sampler::Even,
        Sampler::Refined,
        Sampler::Pattern(pattern::find("jittered").unwrap()),
        Sampler::Adaptive(limits, StoppingRule::BY_CONTRAST),
        Sampler::Budget { first: 4 },
    ];
    for (sampler, filter) in samplers.iter().flat_map(|s| Filter::ALL.map(|f| (s, f))) {
        for camera in [&camera as &dyn Camera, &lens] {
            let [one, three] = [1, 3].map(|threads| {
                let film = Film {
                    filter,
                    ..film(40, 40, 16, threads)
                };
                film.render(camera, sampler, &Path::WHOLE, &scene)
            });
            assert!(one.same_bits(&three), "{sampler:?} on three threads");
            let mean = one.pixels().iter().map(|p| p.g).sum::<f32>() / 1600.0;
            // Of 120 pixels on the rim each is off by up to 0.1 of its half: 0.5·0.1·√120/1600 = 0.0003.
            assert!(
                (mean - exact).abs() < 0.0015,
                "{sampler:?}, {}: {mean}, not {exact}",
                filter.name
            );
        }
    }
}

#[test]
#[should_panic(expected = "no memory for a film of 1000000000 × 1000000000 pixels")]
fn a_film_that_is_too_large_for_any_memory_is_told() {
    Film::new(1_000_000_000, 1_000_000_000, 1).sample(|_, _| Rgb::BLACK);
}
