//! What judges ask of all answers together: what chance hides in one of them shows in many.
//!
//! Each question here goes wrong by chance with a probability below 2e-8 at a right answer, if the answers follow from different seeds; at most
//! ten of them are asked of a pattern, so that a class of 500 meets one less than once in ten thousand times. Estimates are not judged together: a
//! question without a seed may be answered by the same random numbers each time, and then all of them are off to the same side.

use crate::Verdict;

/// Standard deviations by which a sum may be off: more have a probability of 4e-10 (Gauss), as the sums are of thousands of terms.
const DEVIATIONS: f64 = 6.25;

/// Of shorter lists, one number without its mirror image would hide that the others have theirs.
const LONG: usize = 16;

/// Whether the means of lists of uniform numbers are near ½, and no nearer than chance brings them.
///
/// # Errors
/// If all of them together are too far off, or those of twenty or more long lists are nearly all too near: the sum of the squares of n standard deviations is below
/// n/20 with a probability of 3e-10 for n = 20, and less for more.
pub fn balanced(what: &str, lists: impl Iterator<Item = Vec<f64>>) -> Verdict {
    let (mut sum, mut n, mut squares, mut count) = (0.0, 0.0, 0.0, 0.0);
    for list in lists.filter(|list| !list.is_empty()) {
        let (off, len) = (list.iter().map(|v| v - 0.5).sum::<f64>(), list.len() as f64);
        sum += off;
        n += len;
        if list.len() >= LONG {
            squares += 12.0 * off * off / len;
            count += 1.0;
        }
    }
    if sum.abs() > DEVIATIONS * f64::sqrt(n / 12.0) + 1.0 {
        return Err(format!(
            "the mean of {what} is {:.3}, and should be 0.5: it is not the same everywhere",
            0.5 + sum / n
        ));
    }
    if count >= 20.0 && squares < count / 20.0 {
        return Err(format!(
            "the means of {what} are all nearer to 0.5 than chance brings them, as if each point came with its mirror image"
        ));
    }
    Ok(())
}

/// Whether uniform numbers come near to both ends of [0, 1): that all of n keep 21/n away from an end has a probability of e^−21 = 8e-10.
///
/// # Errors
/// If they keep away from an end.
pub fn fills(what: &str, numbers: impl Iterator<Item = f64>) -> Verdict {
    const FREE: f64 = 21.0;
    let (mut least, mut most, mut n) = (1.0_f64, 0.0_f64, 0.0);
    for v in numbers {
        (least, most, n) = (least.min(v), most.max(v), n + 1.0);
    }
    if least.max(1.0 - most) > FREE / n {
        return Err(format!(
            "{what} is never below {least:.4} nor above {most:.4}: it is not the same everywhere from 0 to 1"
        ));
    }
    Ok(())
}

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
