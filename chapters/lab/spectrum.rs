//! The power spectrum: which waves a pattern takes for others.

use crate::lab::subject::Subject;
use glam::Vec2;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// The mean power at all whole frequencies up to a limit.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum {
    /// The highest frequency along each axis, in waves across the square.
    pub limit: usize,
    /// Row by row, from −limit to limit along both axes.
    power: Vec<f64>,
}

impl Spectrum {
    /// |Σ exp(−2πi f·p)|²/n, the mean over realisations.
    ///
    /// Independent points have 1 at every whole frequency but 0. Where it is 0, a wave of that frequency disappears in the mean,
    /// as it should; where it is high, it turns up as another one.
    pub fn of(subject: &Subject, n: usize, limit: usize, realisations: u64) -> Self {
        let side = 2 * limit + 1;
        let realisations = subject.realisations(n, realisations);
        let sum = (0..realisations)
            .into_par_iter()
            .map(|pixel| power(&subject.points(n, pixel), limit))
            .collect::<Vec<_>>() // summed in order: the same on any number of threads
            .into_iter()
            .fold(vec![0.0; side * side], |mut sum, one| {
                sum.iter_mut().zip(one).for_each(|(sum, one)| *sum += one);
                sum
            });
        let power = sum.into_iter().map(|p| p / realisations as f64).collect();
        Self { limit, power }
    }

    /// The power at a frequency, each of −limit … limit.
    pub fn at(&self, x: i32, y: i32) -> f64 {
        let (limit, side) = (self.limit as i32, 2 * self.limit + 1);
        self.power[(y + limit) as usize * side + (x + limit) as usize]
    }

    /// The frequencies in the ring from r − ½ to r + ½.
    fn ring(&self, r: usize) -> impl Iterator<Item = f64> + '_ {
        let limit = self.limit as i32;
        let all = (-limit..=limit).flat_map(move |y| (-limit..=limit).map(move |x| (x, y)));
        let near =
            move |(x, y): &(i32, i32)| f64::from(*x).hypot(f64::from(*y)).round() as usize == r;
        all.filter(near).map(|(x, y)| self.at(x, y))
    }

    /// The mean power in each ring around frequency 0, from 1 to the limit.
    pub fn radial(&self) -> Vec<(f64, f64)> {
        let mean = |r| {
            let (sum, count) = self.ring(r).fold((0.0, 0), |(s, c), p| (s + p, c + 1));
            sum / f64::from(count)
        };
        (1..=self.limit).map(|r| (r as f64, mean(r))).collect()
    }

    /// How much the power varies within each ring: its variance over its mean squared (Ulichney, *Digital halftoning*, 1987).
    ///
    /// 0 is the same in all directions; of m realisations even that leaves 1/m.
    pub fn anisotropy(&self) -> Vec<(f64, f64)> {
        let of = |(r, mean): (f64, f64)| {
            let ring: Vec<_> = self.ring(r as usize).collect();
            let squares: f64 = ring.iter().map(|p| (p - mean).powi(2)).sum();
            (
                r,
                squares / (ring.len() as f64 - 1.0) / (mean * mean).max(1e-12),
            )
        };
        self.radial().into_iter().map(of).collect()
    }
}

/// |Σ exp(−2πi f·p)|²/n of one realisation.
fn power(points: &[Vec2], limit: usize) -> Vec<f64> {
    let side = 2 * limit + 1;
    let mut sums = vec![[0.0, 0.0]; side * (limit + 1)];
    for p in points {
        let (x, y) = (waves(p.x.into(), limit), waves(p.y.into(), limit));
        for fy in 0..=limit {
            let [a, b] = y[fy + limit];
            for fx in 0..side {
                let [c, d] = x[fx];
                let sum = &mut sums[fy * side + fx];
                sum[0] += a * c - b * d;
                sum[1] += a * d + b * c;
            }
        }
    }
    let n = points.len().max(1) as f64;
    let half = |fx: usize, fy: usize| {
        let [re, im] = sums[fy * side + fx];
        (re * re + im * im) / n
    };
    // The power at −f is that at f.
    let at = |fx: usize, fy: usize| {
        if fy >= limit {
            half(fx, fy - limit)
        } else {
            half(side - 1 - fx, limit - fy)
        }
    };
    (0..side * side).map(|i| at(i % side, i / side)).collect()
}

/// exp(−2πi f x) for f from −limit to limit, as pairs.
fn waves(x: f64, limit: usize) -> Vec<[f64; 2]> {
    (0..=2 * limit)
        .map(|f| {
            let phase = -TAU * (f as f64 - limit as f64) * x;
            [phase.cos(), phase.sin()]
        })
        .collect()
}
