//! The film loop: the same picture on any number of threads, and means without bias.

use glam::{Vec2, vec2};
use rand::RngExt;
use raybook::image::rgb::Rgb;
use raybook::math::pcg::Pcg;
use raybook::render::film::{Done, Film};
use raybook::render::followed::Followed;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};

pub(crate) fn film(width: usize, height: usize, samples: usize, threads: usize) -> Film<'static> {
    Film {
        width,
        height,
        samples,
        seed: 7,
        threads,
        progress: &|_| (),
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
        .render(|place, rng| {
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
        let picture = film(width, height, 1, 3).render(|place, _| Rgb::new(place.x, place.y, 1.0));
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
        };
        let film = Film {
            progress: &progress,
            ..film(width, height, 2, threads)
        };
        film.render(|_, _| Followed {
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
        let picture = film(100, 100, samples, 2).render(|place, _| {
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
    let mean = film(1, 1, samples, 1).render(|place, _| {
        let fine = (1024.0 * place.x).fract();
        Rgb::new(fine, fine * fine, place.x * place.y)
    });
    let Rgb { r, g, b } = mean.at(0, 0);
    // The sum of a million numbers in f32 is itself right to about 1e-3 only.
    assert!(
        (r - 0.5).abs() < 3e-3,
        "the mean within a 1024th of the pixel is {r}"
    );
    assert!((g - 1.0 / 3.0).abs() < 3e-3, "and that of its square {g}");
    assert!((b - 0.25).abs() < 3e-3, "xy has the mean {b}");
}

#[test]
fn an_edge_through_pixels_is_found_by_the_mean() {
    // A half plane through every pixel at x = 0.3: 64 of Sobol's points have a discrepancy below 4/64.
    let picture = film(8, 8, 64, 1).render(|place, _| {
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
fn edges_are_rendered_with_all_samples_and_the_rest_with_few() {
    // A disc of a quarter of the picture's area, with a soft shade inside.
    let asked = AtomicUsize::new(0);
    let disc = |place: Vec2, _: &mut Pcg| {
        asked.fetch_add(1, Ordering::Relaxed);
        let inside = place.distance(Vec2::splat(0.5)) < 0.28;
        Rgb::gray(if inside { 0.5 + 0.1 * place.x } else { 1.0 })
    };
    let film = film(100, 100, 16, 2);
    let all = film.render(disc);
    assert_eq!(asked.swap(0, Ordering::Relaxed), 160_000);
    let edges = film.render_edges(disc);
    let (asked, pixels) = (asked.into_inner(), all.pixels().iter().zip(edges.pixels()));
    // The rim is 2π·28 = 176 pixels long, and a band of three to four pixels is looked at more closely.
    assert!((20_000..32_000).contains(&asked), "{asked} samples");
    let (mut on_edge, mut same) = (0, 0);
    for (a, b) in pixels {
        let is_edge = a.r > 0.6 && a.r < 1.0;
        on_edge += u32::from(is_edge);
        same += u32::from(is_edge && a == b);
        // Half a pixel is 0.0005 of the shade.
        assert!((a.r - b.r).abs() < 0.001, "{a:?} and {b:?}");
    }
    assert!(on_edge > 150, "{on_edge} pixels on the edge");
    assert_eq!(on_edge, same, "pixels on the edge");
}
