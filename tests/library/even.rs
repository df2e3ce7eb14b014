//! Low-discrepancy random numbers, pair after pair.

use raybook::inside::even::scramble;
use raybook::math::pcg::mix;
use raybook::sample::even::Even;

#[test]
fn numbers_in_different_pieces_stay_in_different_pieces_and_each_piece_goes_everywhere() {
    for digits in 1..8 {
        for key in [1, 77, 0xdead_beef] {
            let piece = |i: u32| scramble(i << (32 - digits), key) >> (32 - digits);
            let mut pieces: Vec<_> = (0..1 << digits).map(piece).collect();
            pieces.sort_unstable();
            assert!(pieces.into_iter().eq(0..1 << digits), "{digits} digits");
        }
    }
    let mean = |bits| {
        (0..1000)
            .map(|key| f64::from(scramble(bits, mix(key) as u32)) / 2f64.powi(32))
            .sum::<f64>()
            / 1000.0
    };
    // The mean of 1000 numbers scatters by 0.009 around one half.
    assert!(
        [0, 1 << 31, 123_456_789]
            .iter()
            .all(|&bits| (mean(bits) - 0.5).abs() < 0.045)
    );
}

#[test]
fn every_power_of_two_of_the_samples_fills_the_square_of_each_pair() {
    for (pixel, samples) in [(3, 4_usize), (99, 16), (12_345, 64)] {
        let numbers = |i| Even::new(mix(pixel), i, 64);
        let mut all: Vec<_> = (0..samples).map(numbers).collect();
        for pair in 0..5 {
            let points: Vec<_> = all.iter_mut().map(Even::pair).collect();
            let side = samples.isqrt();
            let mut cells: Vec<_> = points
                .iter()
                .map(|p| (*p * side as f32).as_uvec2())
                .map(|c| c.x + side as u32 * c.y)
                .collect();
            cells.sort_unstable();
            assert!(
                cells.into_iter().eq(0..samples as u32),
                "pair {pair} of {samples}"
            );
        }
    }
}

#[test]
fn one_pair_says_nothing_about_the_next() {
    // The mean product of two pairs' deviations from one half: 0 if the pairs are independent.
    let pixels = 2000_u64;
    let mut sum = 0.0;
    for pixel in 0..pixels {
        for i in 0..16 {
            let mut numbers = Even::new(mix(pixel), i, 16);
            let (a, b) = (numbers.pair(), numbers.pair());
            sum += f64::from((a.x - 0.5) * (b.x - 0.5));
        }
    }
    // Each product scatters by 1/12, and 32000 of them together by 1/12/√32000 = 0.0005.
    assert!((sum / (16.0 * pixels as f64)).abs() < 0.0025, "{sum}");
}
