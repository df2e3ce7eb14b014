//! Low-discrepancy random numbers, pair after pair.

use raybook::inside::even::scramble;
use raybook::math::pcg::mix;
use raybook::prelude::*;
use raybook::sample::even::Even;

/// The numbers of the cells in which n points lie, of √n × √n cells; sorted.
fn cells(points: Vec<Vec2>) -> Vec<u32> {
    let side = points.len().isqrt() as u32;
    let cell = |p: Vec2| (p * side as f32).as_uvec2();
    let mut cells: Vec<_> = points
        .into_iter()
        .map(cell)
        .map(|c| c.x + side * c.y)
        .collect();
    cells.sort_unstable();
    cells
}

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
            assert!(
                cells(points).into_iter().eq(0..samples as u32),
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

#[test]
fn pixels_side_by_side_fill_the_square_of_each_pair_together() {
    for (samples, side) in [(4, 2), (1, 4), (16, 2), (4, 8)] {
        for corner in [[0, 0], [8, 24], [64, 640]] {
            let pixels = (0..side * side).map(|i| [corner[0] + i % side, corner[1] + i / side]);
            let numbers = pixels
                .flat_map(|pixel| (0..samples).map(move |i| Even::of_pixel(3, pixel, i, samples)));
            let mut all: Vec<_> = numbers.collect();
            for pair in 0..5 {
                let points = all.iter_mut().map(Even::pair).collect();
                assert!(
                    cells(points)
                        .into_iter()
                        .eq(0..(samples * side * side) as u32),
                    "pair {pair} of {side} × {side} pixels of {samples} samples from {corner:?}"
                );
            }
        }
    }
}

#[test]
fn neighbours_make_up_for_each_others_errors_and_far_pixels_know_nothing_of_each_other() {
    // The estimate of a pixel: the mean of the pairs' x + y.
    let estimate = |seed, pixel| {
        let points = (0..4).map(|i| {
            let mut numbers = Even::of_pixel(seed, pixel, i, 4);
            numbers.pair();
            numbers.pair()
        });
        points.map(|p| f64::from(p.x + p.y) - 1.0).sum::<f64>() / 4.0
    };
    let [mut alone, mut together, mut apart, mut below] = [0.0; 4];
    for seed in 0..2000 {
        let block = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|pixel| estimate(seed, pixel));
        alone += block.iter().map(|error| error * error).sum::<f64>() / 4.0;
        together += (block.iter().sum::<f64>() / 4.0).powi(2);
        apart += block[0] * estimate(seed, [8, 0]);
        below += block[0] * estimate(seed, [0, 8]);
    }
    // Independent pixels would leave a quarter of the variance; a net of all their points leaves a sixteenth of that.
    assert!(together < 0.04 * alone, "{together} of {alone}");
    assert!(apart.abs() < 0.1 * alone, "{apart} of {alone}");
    assert!(below.abs() < 0.1 * alone, "{below} of {alone}");
}

/// The error of a pixel of one sample: its x + y, less 1.
fn error(seed: u64, pixel: [usize; 2]) -> f64 {
    let p = Even::of_pixel(seed, pixel, 0, 1).pair();
    f64::from(p.x + p.y) - 1.0
}

#[test]
fn no_direction_is_preferred_and_no_area_is_luckier_than_another() {
    let mut with = [0.0; 3];
    let mut alone = 0.0;
    for seed in 0..6000 {
        let at = |pixel| error(seed, pixel);
        let first = at([2, 4]);
        alone += first * first;
        for (sum, other) in with.iter_mut().zip([[3, 4], [2, 5], [3, 5]]) {
            *sum += first * at(other);
        }
    }
    // Four numbers whose sum is nearly 0 have correlations of −1/3 if they are alike.
    for sum in with {
        assert!(
            (sum / alone + 1.0 / 3.0).abs() < 0.08,
            "{with:?} of {alone}"
        );
    }
    let noise = |area: usize| {
        let pixels = (0..64 * 64).map(|i| [64 * area + i % 64, i / 64]);
        pixels.map(|pixel| error(3, pixel).powi(2)).sum::<f64>() / (64.0 * 64.0)
    };
    // The variance of x + y is 1/6.
    for area in 0..40 {
        assert!((6.0 * noise(area) - 1.0).abs() < 0.2, "{}", noise(area));
    }
}

#[test]
fn the_pairs_of_a_pixel_are_even_alone_and_say_nothing_about_each_other() {
    let (mut sum, mut count) = (0.0, 0.0);
    for x in 0..200 {
        let pixel = [x, 3 * x + 1];
        for samples in [4, 16] {
            let numbers = |i| Even::of_pixel(9, pixel, i, 16);
            let mut all: Vec<_> = (0..samples).map(numbers).collect();
            for pair in 0..3 {
                let points: Vec<_> = all.iter_mut().map(Even::pair).collect();
                assert!(
                    cells(points).into_iter().eq(0..samples as u32),
                    "pair {pair} of {samples} in {pixel:?}"
                );
            }
        }
        for i in 0..16 {
            let mut numbers = Even::of_pixel(9, pixel, i, 16);
            let (a, b) = (numbers.pair(), numbers.pair());
            sum += f64::from((a.x - 0.5) * (b.x - 0.5));
            count += 1.0;
        }
    }
    // Each product scatters by 1/12.
    assert!((12.0 * sum / f64::sqrt(count)).abs() < 5.0, "{sum}");
}

#[test]
fn the_pixels_of_a_picture_share_their_numbers() {
    // What each sample sees is its second pair's x + y: so the pixels of a block of 2 × 2 make up for each other.
    let film = Film::new(64, 64, 4);
    let picture = film.evenly(|_, numbers| {
        numbers.pair();
        let p = numbers.pair();
        Rgb::gray(p.x + p.y)
    });
    let error = |x: usize, y: usize| f64::from(picture.at(x, y).g) - 1.0;
    let (mut alone, mut together) = (0.0, 0.0);
    for [x, y] in (0..32 * 32).map(|i| [2 * (i % 32), 2 * (i / 32)]) {
        let block = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[i, j]| error(x + i, y + j));
        alone += block.iter().map(|error| error * error).sum::<f64>() / 4.0;
        together += (block.iter().sum::<f64>() / 4.0).powi(2);
    }
    assert!(together < 0.04 * alone, "{together} of {alone}");
}
