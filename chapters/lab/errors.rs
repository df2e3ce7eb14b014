//! The error of the mean over a pattern's points, and how fast it falls.

use crate::kit::of_each::of_each;
use crate::lab::integrands::Integrand;
use crate::lab::subject::Subject;

/// Number of functions of a class that each realisation of a pattern sees.
pub const EACH: usize = 8;

/// From this number of samples on an error is taken to fall by a power law.
pub const ASYMPTOTIC: usize = 64;

/// The errors of many draws, each of a function and of a realisation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Error {
    /// How many samples.
    pub n: usize,
    /// Half of the draws have a smaller error.
    pub median: f64,
    /// A tenth of the draws have a smaller error.
    pub low: f64,
    /// A tenth of the draws have a larger error.
    pub high: f64,
    /// The root of the mean squared error.
    pub rms: f64,
}

impl Error {
    /// An error that is known as a single number.
    pub fn exactly(n: usize, error: f64) -> Self {
        let [median, low, high, rms] = [error; 4];
        Self {
            n,
            median,
            low,
            high,
            rms,
        }
    }

    /// The errors of some draws.
    fn of(n: usize, mut errors: Vec<f64>) -> Self {
        errors.sort_by(f64::total_cmp);
        let last = errors.len().saturating_sub(1) as f64;
        let at = |share: f64| errors.get((share * last).round() as usize).copied();
        let squares: f64 = errors.iter().map(|e| e * e).sum();
        Self {
            n,
            median: at(0.5).unwrap_or(0.0),
            low: at(0.1).unwrap_or(0.0),
            high: at(0.9).unwrap_or(0.0),
            rms: (squares / errors.len().max(1) as f64).sqrt(),
        }
    }
}

/// The errors of n points for several classes of functions: realisation number k sees the k-th [`EACH`] functions of every class.
pub fn errors(subject: &Subject, n: usize, classes: &[Vec<Integrand>], draws: usize) -> Vec<Error> {
    let of_one = |k: usize| {
        let points = subject.points(n, k as u64);
        let of_class = |class: &Vec<Integrand>| -> Vec<f64> {
            let seen = class.iter().skip(k * EACH).take(EACH);
            seen.map(|f| f.error(&points).abs()).collect()
        };
        classes.iter().map(of_class).collect::<Vec<_>>()
    };
    let all = of_each(draws, of_one);
    let class = |i: usize| all.iter().flat_map(|one| one[i].iter().copied()).collect();
    (0..classes.len()).map(|i| Error::of(n, class(i))).collect()
}

/// The slope of a line through points, with its confidence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// b in error ∝ nᵇ.
    pub slope: f64,
    /// Half of the 95 % confidence interval of b, if only chance bends the curve.
    pub within: f64,
}

/// The slope of the medians on logarithmic axes, by least squares, where there are at least [`ASYMPTOTIC`] samples; None for fewer than
/// three numbers of samples.
pub fn slope(errors: &[Error]) -> Option<Slope> {
    let far = errors
        .iter()
        .filter(|e| e.n >= ASYMPTOTIC && e.median > 0.0);
    let points: Vec<_> = far.map(|e| ((e.n as f64).ln(), e.median.ln())).collect();
    let count = points.len() as f64;
    let t = student_t(points.len().checked_sub(2)?)?;
    let x = points.iter().map(|p| p.0).sum::<f64>() / count;
    let y = points.iter().map(|p| p.1).sum::<f64>() / count;
    let spread: f64 = points.iter().map(|p| (p.0 - x).powi(2)).sum();
    let slope = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>() / spread;
    let off: f64 = points
        .iter()
        .map(|p| (p.1 - y - slope * (p.0 - x)).powi(2))
        .sum();
    let within = t * (off / (count - 2.0) / spread).sqrt();
    Some(Slope { slope, within })
}

/// The 97.5 % quantile of Student's t distribution with `freedom` degrees of freedom; None for 0.
pub fn student_t(freedom: usize) -> Option<f64> {
    const QUANTILES: [f64; 10] = [
        12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228,
    ];
    let i = freedom.checked_sub(1)?;
    Some(QUANTILES.get(i).copied().unwrap_or(2.0))
}
