//! The power spectrum: which waves a pattern takes for other waves (aliases).

use crate::kit::of_each::of_each;
use crate::lab::errors::student_t;
use crate::lab::subject::Subject;
use glam::Vec2;
use std::f64::consts::TAU;

/// Groups of realisations, from whose differences the confidence follows.
const BATCHES: u64 = 10;

/// The mean power at all whole frequencies up to a limit.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum {
    /// The highest frequency along each axis, in waves across the square.
    pub limit: usize,
    /// Row by row, from −limit to limit along both axes.
    power: Vec<f64>,
    /// The same without each of the batches of realisations; none if there is only one.
    without: Vec<Vec<f64>>,
}

/// A curve over the frequency, and how well it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Known {
    /// Waves across the square.
    pub frequency: f64,
    /// What was measured.
    pub value: f64,
    /// Half of the 95 % confidence interval of the value.
    pub within: f64,
}

impl Spectrum {
    /// |Σ exp(−2πi f·p)|²/n, the mean over realisations.
    ///
    /// Independent points have 1 at every whole frequency but 0. Where the power is 0, a wave of that frequency disappears in the
    /// mean, as it should; where the power is high, the wave turns up as another wave.
    pub fn of(subject: &Subject, n: usize, limit: usize, realisations: u64) -> Self {
        let side = 2 * limit + 1;
        let realisations = subject.realisations(n, realisations);
        let count = BATCHES.min(realisations);
        let batch = |i: u64| {
            let numbers = (i * realisations / count)..((i + 1) * realisations / count);
            let size = (numbers.end - numbers.start) as f64;
            let mut sum = vec![0.0; side * side];
            for number in numbers {
                add_power(&mut sum, &subject.points(n, number), limit);
            }
            (size, sum)
        };
        // Summed in order: the same on any number of threads.
        let batches = of_each(count as usize, |i| batch(i as u64));
        let mut total = vec![0.0; side * side];
        for (_, sum) in &batches {
            total
                .iter_mut()
                .zip(sum)
                .for_each(|(total, sum)| *total += sum);
        }
        let all = realisations as f64;
        let rest = |(size, sum): &(f64, Vec<f64>)| {
            let rest = total.iter().zip(sum);
            rest.map(|(total, sum)| (total - sum) / (all - size))
                .collect()
        };
        let without = if count > 1 {
            batches.iter().map(rest).collect()
        } else {
            Vec::new()
        };
        let power = total.into_iter().map(|sum| sum / all.max(1.0)).collect();
        Self {
            limit,
            power,
            without,
        }
    }

    /// The power at a frequency, each of −limit … limit.
    pub fn at(&self, x: i32, y: i32) -> f64 {
        let (limit, side) = (self.limit as i32, 2 * self.limit + 1);
        self.power[(y + limit) as usize * side + (x + limit) as usize]
    }

    /// The mean power in each ring around frequency 0, from r − ½ to r + ½, for r from 1 to the limit.
    pub fn radial(&self) -> Vec<Known> {
        self.known(|[count, sum, _]| sum / count)
    }

    /// How much the power varies within each ring: its variance over its mean squared (Ulichney, *Digital halftoning*, 1987).
    ///
    /// 0 means that the power is the same in all directions; with m realisations, chance alone gives 1/m.
    pub fn anisotropy(&self) -> Vec<Known> {
        self.known(|[count, sum, squares]| {
            let mean = sum / count;
            let variance = (squares - sum * mean) / (count - 1.0);
            variance.max(0.0) / (mean * mean).max(1e-12)
        })
    }

    /// A number for every ring, computed from the number of frequencies in the ring, the sum of their powers, and the sum of the
    /// squared powers. Its confidence interval is found by the jackknife (Tukey 1958): from the numbers without each of the
    /// batches.
    fn known(&self, of: impl Fn([f64; 3]) -> f64) -> Vec<Known> {
        let values =
            |power: &[f64]| -> Vec<f64> { rings(power, self.limit).into_iter().map(&of).collect() };
        let without: Vec<_> = self.without.iter().map(|power| values(power)).collect();
        let batches = without.len() as f64;
        let t = student_t(without.len().saturating_sub(1)).unwrap_or(0.0);
        let within = |i: usize| {
            let mean = without.iter().map(|values| values[i]).sum::<f64>() / batches;
            let squares = without.iter().map(|values| (values[i] - mean).powi(2));
            t * (squares.sum::<f64>() * (batches - 1.0) / batches).sqrt()
        };
        let known = |(i, value)| Known {
            frequency: i as f64 + 1.0,
            value,
            within: if without.is_empty() { 0.0 } else { within(i) },
        };
        values(&self.power)
            .into_iter()
            .enumerate()
            .map(known)
            .collect()
    }
}

/// For every ring from 1 to the limit: the number of frequencies in it, the sum of their powers, and the sum of the squared
/// powers.
fn rings(power: &[f64], limit: usize) -> Vec<[f64; 3]> {
    let side = 2 * limit + 1;
    let mut rings = vec![[0.0; 3]; limit + 1];
    for (i, p) in power.iter().enumerate() {
        let [x, y] = [i % side, i / side].map(|at| at as f64 - limit as f64);
        if let Some(ring) = rings.get_mut(x.hypot(y).round() as usize) {
            *ring = [ring[0] + 1.0, ring[1] + p, ring[2] + p * p];
        }
    }
    rings.split_off(1)
}

/// Adds |Σ exp(−2πi f·p)|²/n of one realisation.
fn add_power(power: &mut [f64], points: &[Vec2], limit: usize) {
    let side = 2 * limit + 1;
    let mut sums = vec![[0.0, 0.0]; side * (limit + 1)];
    for p in points {
        let (x, y) = (waves(p.x.into(), limit), waves(p.y.into(), limit));
        for (row, [a, b]) in sums.chunks_exact_mut(side).zip(&y[limit..]) {
            for (sum, [c, d]) in row.iter_mut().zip(&x) {
                sum[0] += a * c - b * d;
                sum[1] += a * d + b * c;
            }
        }
    }
    let n = points.len().max(1) as f64;
    for (i, [re, im]) in sums.into_iter().enumerate() {
        let one = (re * re + im * im) / n;
        let (fx, fy) = (i % side, i / side);
        power[(fy + limit) * side + fx] += one;
        if fy > 0 {
            power[(limit - fy) * side + side - 1 - fx] += one; // the power at −f is the power at f
        }
    }
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
