//! Whether the mean of random numbers is what it should be: by independent batches, and with seeds that never change.

use raybook::math::pcg::{self, Pcg};

/// Number of batches: enough for their mean to be normally distributed, and to know how much it scatters.
pub const BATCHES: u64 = 32;

/// How far a mean may be away, in its standard errors. With 32 batches chance alone does that once in 50 000 times
/// (Student's t with 31 degrees of freedom); and as the seeds are fixed, it would have been seen.
pub const LIMIT: f64 = 5.0;

/// A mean, and how much it scatters.
#[derive(Clone, Copy, Debug)]
pub struct Mean {
    /// The mean.
    pub mean: f64,
    /// Its standard error.
    pub error: f64,
}

impl Mean {
    /// Of numbers that are independent of each other.
    pub fn of(numbers: &[f64]) -> Self {
        let n = numbers.len() as f64;
        let mean = numbers.iter().sum::<f64>() / n;
        let squares: f64 = numbers.iter().map(|x| (x - mean).powi(2)).sum();
        Self {
            mean,
            error: (squares / (n - 1.0) / n).sqrt(),
        }
    }

    /// Of batches of `samples` samples, each batch with random numbers of its own.
    pub fn sampled(seed: u64, samples: u32, mut sample: impl FnMut(&mut Pcg) -> f32) -> Self {
        let batches: Vec<_> = (0..BATCHES)
            .map(|batch| {
                let mut rng = pcg::stream(seed, batch);
                let sum: f64 = (0..samples).map(|_| f64::from(sample(&mut rng))).sum();
                sum / f64::from(samples)
            })
            .collect();
        Self::of(&batches)
    }

    /// How many standard errors the mean is away; what `f32` rounds does not count.
    pub fn z(&self, exact: f64) -> f64 {
        (self.mean - exact) / self.error.max(2e-6 * exact.abs())
    }

    /// Fails if the mean is not this number, or is not known to 1 %, which would prove little.
    #[track_caller]
    pub fn assert_is(&self, exact: f64, what: &str) {
        assert!(
            self.error <= 0.01 * exact.abs(),
            "{what}: {self:?} is too vague to say anything of {exact}"
        );
        let z = self.z(exact);
        assert!(
            z.abs() < LIMIT,
            "{what}: {self:?} should be {exact}: {z:.1} standard errors"
        );
    }

    /// Fails if two means cannot be of the same number.
    #[track_caller]
    pub fn assert_same(&self, other: &Self, what: &str) {
        let z = (self.mean - other.mean) / self.error.hypot(other.error).max(1e-9);
        assert!(
            z.abs() < LIMIT,
            "{what}: {self:?} and {other:?} are {z:.1} standard errors apart"
        );
    }
}

/// The slope of the line through points (x, y) by least squares, and its standard error.
pub fn slope(points: &[(f64, f64)]) -> (f64, f64) {
    let n = points.len() as f64;
    let mean = |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / n;
    let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
    let spread = mean(&|p| (p.0 - x).powi(2));
    let slope = mean(&|p| (p.0 - x) * (p.1 - y)) / spread;
    let off = mean(&|p| (p.1 - y - slope * (p.0 - x)).powi(2));
    (slope, (off / spread / (n - 2.0).max(1.0)).sqrt())
}
