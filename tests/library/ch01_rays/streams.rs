//! The streams of random numbers: the same everywhere, and each its own.

use rand::RngExt;
use raybook::math::pcg;

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
