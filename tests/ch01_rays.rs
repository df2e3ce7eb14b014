//! Chapter 1: directions, rays, the pin-hole camera, streams of random numbers, and the film loop.

use glam::{Vec2, Vec3, vec2, vec3};
use rand::RngExt;
use raybook::camera::{
    Camera,
    pinhole::{LookAtError, PLANE_HEIGHT, Pinhole},
};
use raybook::image::rgb::Rgb;
use raybook::math::{dir3::Dir3, pcg, ray::Ray};
use raybook::render::film::Film;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A few roundings of `f32` on numbers of about 1.
const ROUNDING: f32 = 4.0 * f32::EPSILON;

fn film(width: usize, height: usize, samples: usize, threads: usize) -> Film<'static> {
    Film {
        width,
        height,
        samples,
        seed: 7,
        threads,
        progress: &|_| (),
    }
}

/// A camera somewhere, that looks somewhere, and not straight.
fn camera() -> Pinhole {
    let from = vec3(1.0, 2.0, 3.0);
    Pinhole::look_at(from, vec3(-4.0, 0.5, -2.0), vec3(0.1, 1.0, 0.2), 0.03, 1.5)
        .expect("this up is not parallel to the view")
}

#[test]
fn every_vector_with_a_direction_becomes_one_of_length_one() {
    let shape = vec3(1.0, -2.0, 3.0);
    for scale in [1e-44, 1e-38, 1e-30, 1e-10, 1.0, 1e10, 1e30, 1e38] {
        let d = Dir3::new(scale * shape).unwrap_or_else(|| panic!("{scale} times a vector points"));
        let length = d.as_dvec3().length();
        assert!(
            (length - 1.0).abs() < 2e-7,
            "length {length} at scale {scale}"
        );
        // Among the subnormals a vector has few digits: 1e-44 is 7 units, so a direction is right to a tenth.
        let off = d.distance(shape / shape.length());
        let digits = if scale < 1e-38 { 0.2 } else { ROUNDING };
        assert!(off < digits, "the direction is {off} off at scale {scale}");
    }
    let diagonal = Dir3::new(Vec3::splat(f32::MAX)).expect("the largest vector points too");
    assert!(
        (*diagonal - Vec3::splat(1.0 / 3.0_f32.sqrt())).length() < ROUNDING,
        "{diagonal:?}"
    );
}

#[test]
fn a_vector_without_a_direction_becomes_none() {
    let (inf, nan) = (f32::INFINITY, f32::NAN);
    for v in [
        Vec3::ZERO,
        -Vec3::ZERO,
        vec3(nan, 1.0, 0.0),
        vec3(0.0, nan, 0.0),
        Vec3::NAN,
        vec3(inf, 0.0, 0.0),
        vec3(1.0, 0.0, -inf),
        vec3(inf, nan, 0.0),
    ] {
        assert_eq!(Dir3::new(v), None, "{v} has no direction");
        assert_eq!(Dir3::new_or(v, Dir3::X), Dir3::X, "{v} is replaced");
    }
}

#[test]
fn the_opposite_direction_has_length_one_too() {
    let d = Dir3::new(vec3(3.0, -4.0, 12.0)).expect("it points");
    assert_eq!(*-d, -*d, "negation turns it round");
    assert_eq!(d.dot(*-d), -d.dot(*d), "and keeps its length");
}

#[test]
fn t_is_a_distance_along_the_ray() {
    let d = Dir3::new(vec3(2.0, 3.0, 6.0)).expect("it points");
    let ray = Ray::new(vec3(1.0, -1.0, 0.5), d);
    assert_eq!(ray.at(0.0), ray.origin, "t = 0 is the origin");
    // (2, 3, 6) has length 7, so that t = 14 is twice the vector.
    let expected = vec3(5.0, 5.0, 12.5);
    assert!(
        ray.at(14.0).distance(expected) < 14.0 * ROUNDING,
        "{}",
        ray.at(14.0)
    );
    assert!(
        ray.at(-7.0).distance(vec3(-1.0, -4.0, -5.5)) < 7.0 * ROUNDING,
        "t may be negative"
    );
}

#[test]
fn camera_axes_are_orthonormal_and_right_handed() {
    let camera = camera();
    let (right, up, forward) = (*camera.right, *camera.up, *camera.forward);
    for (a, b) in [(right, up), (up, forward), (forward, right)] {
        assert!(
            a.dot(b).abs() < ROUNDING,
            "{a} and {b} are square to each other"
        );
    }
    // right, up and *backward* are x, y and z of the camera: a right-handed system.
    assert!(
        right.cross(up).distance(-forward) < ROUNDING,
        "right × up = backward"
    );
    assert!(
        up.dot(vec3(0.1, 1.0, 0.2)) > 0.0,
        "up is on the side that was asked for"
    );
    let toward = vec3(-5.0, -1.5, -5.0);
    assert!(
        forward.distance(toward.normalize()) < ROUNDING,
        "forward is from `from` to `to`"
    );
}

#[test]
fn looking_along_minus_z_makes_the_axes_those_of_the_world() {
    let camera = Pinhole::look_at(Vec3::ZERO, -Vec3::Z, Vec3::Y, 0.05, 1.0).expect("it can");
    assert_eq!(*camera.right, Vec3::X, "x is to the right");
    assert_eq!(*camera.up, Vec3::Y, "y is up");
    assert_eq!(*camera.forward, -Vec3::Z, "the view is along −z");
}

#[test]
fn the_middle_of_the_film_sees_the_point_looked_at() {
    let ray = camera().ray(Vec2::splat(0.5), Vec2::ZERO);
    assert_eq!(
        ray.origin,
        vec3(1.0, 2.0, 3.0),
        "every ray starts at the focal point"
    );
    let t = ray.origin.distance(vec3(-4.0, 0.5, -2.0));
    let missed = ray.at(t).distance(vec3(-4.0, 0.5, -2.0));
    assert!(
        missed < t * ROUNDING,
        "the ray passes the point at a distance of {missed} m"
    );
}

#[test]
fn film_0_0_is_the_top_left() {
    let camera = Pinhole::look_at(Vec3::ZERO, -Vec3::Z, Vec3::Y, 0.05, 2.0).expect("it can");
    for (corner, name, x, y) in [
        (vec2(0.0, 0.0), "top left", -1.0, 1.0),
        (vec2(1.0, 0.0), "top right", 1.0, 1.0),
        (vec2(0.0, 1.0), "bottom left", -1.0, -1.0),
        (vec2(1.0, 1.0), "bottom right", 1.0, -1.0),
    ] {
        let d = camera.ray(corner, Vec2::ZERO).direction;
        // The corner of a plane of 48 mm × 24 mm, 50 mm ahead.
        let expected = vec3(0.024 * x, 0.012 * y, -0.05).normalize();
        assert!(
            d.distance(expected) < ROUNDING,
            "{name} is {expected}, not {}",
            *d
        );
    }
}

#[test]
fn rays_pass_through_the_centres_of_pixels() {
    let (camera, width, height) = (camera(), 6.0, 4.0);
    for (x, y) in [(0.0, 0.0), (5.0, 0.0), (2.0, 3.0)] {
        let ray = camera.ray(vec2((x + 0.5) / width, (y + 0.5) / height), Vec2::ZERO);
        // Walk the plane: from its top left by whole pixels, and half a pixel more.
        let pixel = camera.plane / vec2(width, height);
        let top_left = camera.focal_point + camera.focal_length * *camera.forward
            - 0.5 * camera.plane.x * *camera.right
            + 0.5 * camera.plane.y * *camera.up;
        let centre =
            top_left + (x + 0.5) * pixel.x * *camera.right - (y + 0.5) * pixel.y * *camera.up;
        let t = camera.focal_point.distance(centre);
        // The focal point's coordinates are about 3: their rounding is what is left.
        assert!(
            ray.at(t).distance(centre) < 3.0 * ROUNDING,
            "pixel ({x}, {y})"
        );
    }
}

#[test]
fn focal_length_and_field_of_view_belong_together() {
    // Angles of view of the 35 mm film's height, from photographers' tables: 2·atan(12 mm/f).
    for (millimetres, degrees) in [(14.0, 81.20), (24.0, 53.13), (50.0, 26.99), (200.0, 6.87)] {
        let camera = Pinhole::look_at(Vec3::ZERO, Vec3::X, Vec3::Y, millimetres / 1000.0, 1.5)
            .expect("it can");
        let edge = |y: f32| camera.ray(vec2(0.5, y), Vec2::ZERO).direction;
        let angle = edge(0.0).angle_between(*edge(1.0)).to_degrees();
        assert!(
            (angle - degrees).abs() < 0.01,
            "{millimetres} mm sees {angle}°, not {degrees}°"
        );
        assert!(
            (camera.plane - vec2(1.5 * PLANE_HEIGHT, PLANE_HEIGHT)).length() < ROUNDING,
            "3:2 of 24 mm"
        );
    }
}

#[test]
fn an_up_along_the_view_is_an_error_that_says_so() {
    let up_error = |up: Vec3| {
        Pinhole::look_at(Vec3::ZERO, vec3(0.0, 5.0, 0.0), up, 0.05, 1.0).expect_err("it cannot")
    };
    let error = up_error(2.0 * Vec3::Y);
    assert_eq!(
        error.to_string(),
        "the camera looks along [0, 1, 0], and its up, [0, 2, 0], is zero or parallel to that: choose another up"
    );
    for up in [
        -Vec3::Y,
        vec3(1e-6, 1.0, 0.0),
        Vec3::ZERO,
        Vec3::NAN,
        vec3(0.0, f32::INFINITY, 0.0),
    ] {
        assert!(
            matches!(up_error(up), LookAtError::UpParallelToView { .. }),
            "up = {up}"
        );
    }
    let nearly = Pinhole::look_at(Vec3::ZERO, Vec3::Y, vec3(1e-3, 1.0, 0.0), 0.05, 1.0);
    assert!(
        nearly.is_ok(),
        "a tenth of a degree beside the view is enough: {nearly:?}"
    );
}

#[test]
fn looking_nowhere_is_an_error_that_says_so() {
    let here = vec3(1.0, 2.0, 3.0);
    let error =
        Pinhole::look_at(here, here, Vec3::Y, 0.05, 1.0).expect_err("there is no direction");
    assert_eq!(
        error.to_string(),
        "the camera at [1, 2, 3] looks at [1, 2, 3]: it needs two different, finite points"
    );
    for (from, to) in [
        (here, Vec3::NAN),
        (Vec3::INFINITY, here),
        (Vec3::NAN, Vec3::NAN),
    ] {
        let error =
            Pinhole::look_at(from, to, Vec3::Y, 0.05, 1.0).expect_err("there is no direction");
        assert!(
            matches!(error, LookAtError::SamePoint { .. }),
            "{from} to {to}: {error}"
        );
    }
}

#[test]
fn a_stream_has_the_same_numbers_on_every_machine() {
    // From a second implementation, in Python integers, of O'Neill's pcg32_srandom_r and pcg32_random_r and of SplitMix64:
    // a new version of a crate must not change every picture of the book.
    const SEED_0: [u32; 3] = [2_448_696_445, 4_097_796_745, 4_157_487_129];
    const SEED_1: [u32; 3] = [1_799_471_658, 1_138_507_112, 3_718_165_928];
    const FAR_PIXEL: [u32; 3] = [1_972_556_071, 245_627_136, 2_976_228_324];
    let first = |seed, stream| -> [u32; 3] {
        let mut rng = pcg::stream(seed, stream);
        [rng.random(), rng.random(), rng.random()]
    };
    assert_eq!(first(0, 0), SEED_0, "seed 0, stream 0");
    assert_eq!(first(1, 0), SEED_1, "seed 1, stream 0");
    assert_eq!(first(1, 123_456), FAR_PIXEL, "seed 1, stream 123456");
    let real: f32 = pcg::stream(1, 0).random();
    assert_eq!(
        real,
        (SEED_1[0] >> 8) as f32 / (1 << 24) as f32,
        "a real number is the top 24 bits"
    );
}

#[test]
fn neighbouring_streams_and_seeds_have_nothing_in_common() {
    // 64 × 64 first numbers, as of a picture's pixels. Their mean has a standard deviation of 1/√(12·4096) = 0.0045,
    // and the correlation of neighbours one of 1/64; five of each are allowed.
    let first = |seed: u64, stream: u64| -> f64 { pcg::stream(seed, stream).random() };
    let pixels: Vec<f64> = (0..4096).map(|stream| first(1, stream)).collect();
    let others: Vec<f64> = (0..4096).map(|stream| first(2, stream)).collect();
    let mean = pixels.iter().sum::<f64>() / 4096.0;
    assert!((mean - 0.5).abs() < 5.0 * 0.0045, "the mean is {mean}");
    let correlation = |pairs: &mut dyn Iterator<Item = (f64, f64)>| {
        12.0 * pairs.map(|(a, b)| (a - 0.5) * (b - 0.5)).sum::<f64>() / 4096.0
    };
    for (name, value) in [
        (
            "left and right pixel",
            correlation(&mut pixels.iter().copied().zip(pixels[1..].iter().copied())),
        ),
        (
            "upper and lower pixel",
            correlation(&mut pixels.iter().copied().zip(pixels[64..].iter().copied())),
        ),
        (
            "seed 1 and seed 2",
            correlation(&mut pixels.iter().copied().zip(others.iter().copied())),
        ),
    ] {
        assert!(value.abs() < 5.0 / 64.0, "{name}: correlation {value}");
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
fn progress_adds_up_to_all_pixels() {
    for (width, height, threads) in [(1, 1, 1), (50, 31, 1), (50, 31, 4), (16, 16, 2)] {
        let done = AtomicUsize::new(0);
        let progress = |pixels: usize| {
            done.fetch_add(pixels, Ordering::Relaxed);
        };
        let film = Film {
            progress: &progress,
            ..film(width, height, 1, threads)
        };
        film.render(|_, _| Rgb::BLACK);
        assert_eq!(
            done.into_inner(),
            width * height,
            "{width}×{height} on {threads} threads"
        );
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
    // A half plane through every pixel at x = 0.3: R₂ with 64 samples has a discrepancy below 4/64.
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
