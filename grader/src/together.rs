//! What judges ask of all answers together: what chance hides in one of them shows in many.
//!
//! Each question here goes wrong by chance with a probability below 2e-8 at a right answer (see [`crate::cases`]' points); three
//! to six of them are asked of a student who is right everywhere, so that a class of 500 meets one less than once in ten thousand times.

use crate::Verdict;

/// Standard deviations by which a sum may be off: more have a probability of 4e-10 (Gauss), as the sums are of thousands of terms.
const DEVIATIONS: f64 = 6.25;

/// Each number with the next: whether a generator's numbers hang together one after the other. All are uniform in [0, 1).
///
/// # Errors
/// If their correlation is larger than chance makes it.
pub fn serial(what: &str, lists: impl Iterator<Item = Vec<f64>>) -> Verdict {
    let (mut sum, mut n) = (0.0, 0.0);
    for list in lists {
        for two in list.windows(2) {
            sum += (two[0] - 0.5) * (two[1] - 0.5);
            n += 1.0;
        }
    }
    // The products have the standard deviation 1/12, and neighbours among them do not go together.
    if sum.abs() > DEVIATIONS / 12.0 * f64::sqrt(n) + 1.0 {
        let how = if sum > 0.0 { "near" } else { "opposite" };
        return Err(format!(
            "{what} of one point is often {how} to that of the next: they are not independent"
        ));
    }
    Ok(())
}

/// Estimates of numbers that are known: whether their mean is off. Each has its number, the standard deviation of an estimate, and what the
/// known number may itself be off.
///
/// # Errors
/// If the mean is more than chance explains.
pub fn unbiased(what: &str, estimates: impl Iterator<Item = Estimate>) -> Verdict {
    let (mut off, mut variance, mut slack, mut sum) = (0.0, 0.0, 0.0, 0.0);
    for one in estimates {
        off += one.got - one.exact;
        variance += one.deviation * one.deviation;
        slack += one.slack;
        sum += one.exact;
    }
    if off.abs() > DEVIATIONS * variance.sqrt() + slack {
        let percent = 100.0 * off / sum;
        let side = if off > 0.0 { "large" } else { "small" };
        return Err(format!(
            "{what} is {:.1} % too {side} in the mean: no single answer shows it, all of them do",
            percent.abs()
        ));
    }
    Ok(())
}

/// An estimate of a number that is known.
#[derive(Clone, Copy, Debug)]
pub struct Estimate {
    /// The number.
    pub exact: f64,
    /// Its estimate.
    pub got: f64,
    /// The standard deviation of a right estimate.
    pub deviation: f64,
    /// How far the number itself may be off.
    pub slack: f64,
}

/// Whether answers to questions of which only the seed differs do differ. `same` says of two of them whether all else is the same.
///
/// # Errors
/// If two are equal.
pub fn seeded<Q, A: PartialEq>(
    answers: &[(Q, Vec<A>)],
    same: impl Fn(&Q, &Q) -> bool,
    seed: impl Fn(&Q) -> u32,
) -> Verdict {
    for (i, (one, points)) in answers.iter().enumerate() {
        for (other, others) in &answers[..i] {
            let alike = points.len().min(others.len());
            let differ = seed(one) != seed(other) && alike >= 2;
            if differ && same(one, other) && points[..alike] == others[..alike] {
                return Err(format!(
                    "the seeds {} and {} give the same points: what does your generator start from?",
                    seed(other),
                    seed(one)
                ));
            }
        }
    }
    Ok(())
}
