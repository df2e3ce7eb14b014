//! What judges ask of all answers together: what chance hides in one of them shows in many.
//!
//! Each question here goes wrong by chance with a probability of at most 8e-10 at a right answer, if the answers follow from
//! different seeds. At most 21 of them are asked of a pattern, with 2e-8 in all; and they are asked of its cases, of these with
//! the first further questions, and seldom of up to three more rounds (see [`crate::further`]): 3e-8 for a pattern. The answer to
//! a case fails alone by chance with 4e-10 (`points.rs`), and one of a thousand points with 2e-8: 5e-8 in all; of further answers,
//! two have to. So of a class of 500, a right `random_pattern` or `jittered` fails less than once in ten thousand classes.
//! Estimates are judged together if one question has other answers each time: a question without a seed may be answered by the
//! same random numbers each time, and then all of them are off to the same side.

use crate::Verdict;
use glam::Vec2;
use rand::RngExt;
use raybook::math::pcg::Pcg;
use std::collections::{BTreeSet, HashMap};

/// Standard deviations by which a sum may be off: more have a probability of 4e-10 (Gauss), as the sums are of thousands of terms.
const DEVIATIONS: f64 = 6.25;

/// How far all answers together may be off: as far as chance brings them, or a share of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    share: f64,
}

impl Bounds {
    /// What is beyond them is wrong.
    pub const CHANCE: Self = Self { share: 1.0 };

    /// For the distribution of a thousand points, of which one case asks: 3.1 / √n is beyond them by chance with 8e-9.
    pub const LONG: Self = Self { share: 0.89 };

    /// What is beyond them, and is not wrong, is asked more: 2.5 standard deviations. Of right programs, one in eight or so is.
    pub const DOUBT: Self = Self { share: 0.4 };

    /// That share of a bound.
    pub fn of(self, bound: f64) -> f64 {
        self.share * bound
    }
}

/// Of shorter lists, one number without its mirror image would hide that the others have theirs.
const LONG: usize = 16;

/// Whether the means of lists of uniform numbers v are near ½, and no nearer than chance brings them, and that of (v − ½)² near 1/12. So
/// that of v² = (v − ½)² + v − ¼ is near ⅓.
///
/// # Errors
/// If all of them together are too far off, their middle or their spread, or those of twenty or more long lists are nearly all too near: the sum of the squares of n standard deviations is below
/// n/20 with a probability of 3e-10 for n = 20, and less for more.
pub fn balanced(what: &str, lists: impl Iterator<Item = Vec<f64>>, bounds: Bounds) -> Verdict {
    let (mut sum, mut spread, mut n, mut squares, mut count) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for list in lists.filter(|list| !list.is_empty()) {
        let (off, len) = (list.iter().map(|v| v - 0.5).sum::<f64>(), list.len() as f64);
        sum += off;
        spread += list.iter().map(|v| (v - 0.5).powi(2)).sum::<f64>() - len / 12.0;
        n += len;
        if list.len() >= LONG {
            squares += 12.0 * off * off / len;
            count += 1.0;
        }
    }
    let deviations = bounds.of(DEVIATIONS);
    if sum.abs() > deviations * f64::sqrt(n / 12.0) + 1.0 {
        return Err(format!(
            "the mean of {what} is {:.4}, and should be 0.5: it is not the same everywhere",
            0.5 + sum / n
        ));
    }
    // The variance of (v − ½)² is 1/80 − 1/144 = 1/180.
    if spread.abs() > deviations * f64::sqrt(n / 180.0) + 1.0 {
        let where_to = if spread > 0.0 { "0 and 1" } else { "0.5" };
        return Err(format!(
            "{what} is too often near {where_to}: it is not the same everywhere"
        ));
    }
    if count >= 20.0 && squares < count / 20.0 {
        return Err(format!(
            "the means of {what} are all nearer to 0.5 than chance brings them, as if each point came with its mirror image"
        ));
    }
    Ok(())
}

/// The widest gap between neighbours among numbers: where it begins and ends.
pub fn widest_gap(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    let mut sorted: Vec<_> = numbers.collect();
    sorted.sort_by(f64::total_cmp);
    let gaps = sorted.windows(2).map(|two| [two[0], two[1]]);
    gaps.max_by(|[a, b], [c, d]| (b - a).total_cmp(&(d - c)))
        .unwrap_or_default()
}

/// Whether uniform numbers fill [0, 1): that all of n keep 21/n away from an end has a probability of e^−21 = 8e-10, and as small is that of a
/// gap of (21 + ln n)/n in the midst of them: each of its n − 1 gaps is wider than g with the probability (1 − g)ⁿ (Fisher 1929).
///
/// # Errors
/// If they keep away from an end, or leave a gap.
pub fn fills(what: &str, numbers: impl Iterator<Item = f64>, bounds: Bounds) -> Verdict {
    const FREE: f64 = 21.0;
    let numbers: Vec<_> = numbers.collect();
    let n = numbers.len() as f64;
    let least = numbers.iter().copied().fold(1.0, f64::min);
    let most = numbers.iter().copied().fold(0.0, f64::max);
    if least.max(1.0 - most) > bounds.of(FREE) / n {
        return Err(format!(
            "{what} is never below {least:.4} nor above {most:.4}: it is not the same everywhere from 0 to 1"
        ));
    }
    let [from, to] = widest_gap(numbers.into_iter());
    if to - from > (bounds.of(FREE) + n.ln()) / n {
        return Err(format!(
            "{what} is never between {from:.4} and {to:.4}: it is not the same everywhere from 0 to 1"
        ));
    }
    Ok(())
}

/// Whether estimates scatter no more than chance lets them, by how many of their standard deviations each of them is off: the squares of n of
/// these have a sum with the χ² distribution, and the cube root of their mean is nearly normal (Wilson and Hilferty 1931). Who scatters less may
/// well: stratified estimates do.
///
/// # Errors
/// If all of them together scatter more.
pub fn scattered(what: &str, deviations: impl Iterator<Item = f64>, bounds: Bounds) -> Verdict {
    let squares: Vec<_> = deviations.map(|by| by * by).collect();
    let n = squares.len() as f64;
    let mean = squares.iter().sum::<f64>() / n;
    let variance = 2.0 / (9.0 * n);
    if mean.cbrt() > 1.0 - variance + bounds.of(DEVIATIONS) * variance.sqrt() {
        return Err(format!(
            "{what} scatter {:.1} times as much as those of so many samples may: are all of them random, and each taken once?",
            mean.sqrt()
        ));
    }
    Ok(())
}

/// Each number with the next: whether a generator's numbers hang together one after the other. All are uniform in [0, 1); `what`
/// says what a number is, and `next` of what the next number is.
///
/// # Errors
/// If their correlation is larger than chance makes it.
pub fn serial(
    what: &str,
    next: &str,
    lists: impl Iterator<Item = Vec<f64>>,
    bounds: Bounds,
) -> Verdict {
    let (mut sum, mut n) = (0.0, 0.0);
    for list in lists {
        for two in list.windows(2) {
            sum += (two[0] - 0.5) * (two[1] - 0.5);
            n += 1.0;
        }
    }
    // The products have the standard deviation 1/12, and neighbours among them do not go together.
    if sum.abs() > bounds.of(DEVIATIONS) / 12.0 * f64::sqrt(n) + 1.0 {
        let how = if sum > 0.0 { "near" } else { "opposite" };
        return Err(format!(
            "{what} is often {how} to that of {next}: they are not independent"
        ));
    }
    Ok(())
}

/// Of fewer points, a coordinate that comes again tells nothing.
const ENOUGH: usize = 8;

/// Seeds for further questions, three by three: the second is the first's neighbour, and the third differs in its upper half only. So who takes
/// half of a seed, or its lower 16 bits, gives the same points twice; no two are the same for a generator of 31 bits, as that of C's `rand` is
/// (none of the first 800 differ by 2³¹ or by 2³¹ − 1).
pub fn seeds(rng: &mut Pcg, count: u32) -> impl Iterator<Item = u32> {
    const APART: u32 = 0x6a09_e667; // √2 − 1, as 32 digits of 2
    const BESIDE: [u32; 3] = [0, 1, 1 << 16];
    let first: u32 = rng.random();
    let seed = move |i: u32| {
        first
            .wrapping_add((i / 3).wrapping_mul(APART))
            .wrapping_add(BESIDE[i as usize % 3])
    };
    (0..count).map(move |i| seed(i).max(1))
}

/// Who had which coordinate at place 0, 1, 4, 9, …: of hundreds of answers all pairs are too many to be compared number by number, and two
/// answers that are mostly the same are so at one of these places.
#[derive(Default)]
struct Landmarks(HashMap<(usize, usize, u32), Vec<usize>>);

impl Landmarks {
    /// The earlier answers with which these points have a landmark in common.
    fn meet(&mut self, answer: usize, points: &[Vec2]) -> BTreeSet<usize> {
        let mut met = BTreeSet::new();
        let squares = (0..).map(|root: usize| root * root);
        for place in squares.take_while(|&place| place < points.len()) {
            for (axis, number) in points[place].to_array().into_iter().enumerate() {
                let before = self.0.entry((place, axis, number.to_bits())).or_default();
                met.extend(before.iter());
                before.push(answer);
            }
        }
        met
    }
}

/// Whether points begin otherwise where only the seed is another, in at least one pair of answers: nothing if few pairs tell, or if lists of
/// other lengths begin otherwise, which may depend on the length.
fn depends_on_seed<Q>(
    answers: &[(Q, Vec<Vec2>)],
    same: impl Fn(&Q, &Q) -> bool,
    seed: impl Fn(&Q) -> u32,
) -> Option<bool> {
    /// Two seeds may have the part in common that counts, and of this many pairs not all have.
    const PAIRS: usize = 8;
    let (mut alike, mut is_unclear) = (0, false);
    for (i, (one, points)) in answers.iter().enumerate() {
        for (other, others) in &answers[..i] {
            let is_empty = points.is_empty() || others.is_empty();
            if is_empty || seed(one) == seed(other) || !same(one, other) {
                continue;
            }
            match points.first() == others.first() {
                true => alike += 1,
                false if points.len() == others.len() => return Some(true),
                false => is_unclear = true,
            }
        }
    }
    (alike >= PAIRS && !is_unclear).then_some(false)
}

/// How [`seeded`] begins its complaint.
pub const SEEDS: &str = "the seeds";

/// Whether answers to questions of which only the seed differs do differ, in each coordinate. `same` says of two of them whether all else is
/// the same. That half of eight or more numbers come again has a probability below 1e-14, also if only four digits are printed of them.
///
/// # Errors
/// If two are equal, or mostly equal along an axis.
pub fn seeded<Q>(
    answers: &[(Q, Vec<Vec2>)],
    same: impl Fn(&Q, &Q) -> bool + Copy,
    seed: impl Fn(&Q) -> u32 + Copy,
) -> Verdict {
    let mut landmarks = Landmarks::default();
    for (i, (one, points)) in answers.iter().enumerate() {
        for j in landmarks.meet(i, points) {
            let (other, others) = &answers[j];
            if seed(one) == seed(other) || !same(one, other) {
                continue;
            }
            let alike = points.len().min(others.len());
            let again = |axis: usize| {
                let pairs = points.iter().zip(others);
                pairs.filter(|(p, q)| p[axis] == q[axis]).count()
            };
            let [x, y] = [again(0), again(1)];
            let what = match () {
                () if alike >= 2 && x.min(y) == alike => match depends_on_seed(answers, same, seed)
                {
                    Some(true) => {
                        "points, and others do not: does your generator start from all of it?"
                    }
                    Some(false) => "points, as all others do: does your generator start from it?",
                    None => "points: does your generator start from it, and from all of it?",
                },
                () if alike >= ENOUGH && 2 * x >= alike => {
                    "x of points: does each coordinate's generator start from it?"
                }
                () if alike >= ENOUGH && 2 * y >= alike => {
                    "y of points: does each coordinate's generator start from it?"
                }
                () => continue,
            };
            return Err(format!(
                "{SEEDS} {} and {} give the same {what}",
                seed(other),
                seed(one)
            ));
        }
    }
    Ok(())
}
