//! `spend_budget`: random questions, judge and mistakes.

use crate::upon::changed;
use crate::{Flaw, Graded, Mistake, Verdict, sample};
use rand::RngExt;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch23_adaptive::SpendBudget;

/// How much larger than the least the sum may be: whole numbers can be rounded in more than one way.
const SLACK: f64 = 0.03;

/// Σ σ²/n.
fn variance(deviations: &[f32], counts: &[u32]) -> f64 {
    let each = deviations.iter().zip(counts);
    each.map(|(d, n)| f64::from(*d).powi(2) / f64::from(*n))
        .sum()
}

/// How a budget is spent; one field wrong is a mistake.
#[derive(Clone, Copy)]
struct How {
    /// What of a pixel's deviation its share is in proportion to.
    weight: fn(deviation: f32) -> f32,
    /// The pixels' shares before they are rounded; the weights are given for the deviations.
    shares: fn(q: &SpendBudget) -> Vec<f32>,
    /// A share as a whole number.
    rounded: fn(share: f32) -> f32,
    /// The pixels that get what rounding leaves of the budget, in turn. One alone pays what is too much, too.
    rest: Turns,
    /// What a pixel gets in the end.
    count: fn(count: u32, least: u32) -> u32,
}

/// Some of the pixels whose shares are rounded.
type Turns = fn(q: &SpendBudget, shares: &[f32]) -> Vec<usize>;

/// As it should be: another way to round is as good.
const WELL: How = How {
    weight: |deviation| deviation,
    shares: |q| shared(q, q.deviations.len()),
    rounded: down,
    rest: |_, shares| (0..shares.len()).collect(),
    count: |count, _| count,
};

/// What each pixel gets, rightly but for what is changed.
fn spent(q: &SpendBudget, change: fn(&mut How)) -> Vec<u32> {
    let how = changed(WELL, change);
    let weights = q.deviations.iter().copied().map(how.weight);
    let shares = (how.shares)(&SpendBudget {
        deviations: weights.collect(),
        ..q.clone()
    });
    let rounded = shares.iter().map(|share| (how.rounded)(*share) as u32);
    let mut counts: Vec<_> = rounded.collect();
    let left = i64::from(q.budget) - counts.iter().copied().map(i64::from).sum::<i64>();
    match (how.rest)(q, &shares)[..] {
        [one] => counts[one] = (i64::from(counts[one]) + left).max(0) as u32,
        ref turns => {
            let turns = turns.iter().cycle().take(left.max(0) as usize);
            turns.for_each(|i| counts[*i] += 1);
        }
    }
    let counts = counts.into_iter();
    counts.map(|count| (how.count)(count, q.least)).collect()
}

/// In proportion to the deviations, and the minimum where that would be less (Neyman 1934). As what the minimum takes from the others may make their
/// shares too small as well, it is looked for such shares again and again: this number of times at most.
fn shared(q: &SpendBudget, looks: usize) -> Vec<f32> {
    let least = q.least as f32;
    let mut shares = Vec::new();
    let mut is_quiet = vec![false; q.deviations.len()];
    for _ in 0..=looks {
        let pixels = || q.deviations.iter().zip(&is_quiet);
        let sum: f32 = pixels().filter(|(_, quiet)| !**quiet).map(|(d, _)| d).sum();
        if sum <= 0.0 {
            return vec![q.budget as f32 / q.deviations.len() as f32; q.deviations.len()];
        }
        let quiet = pixels().filter(|(_, quiet)| **quiet).count() as f32;
        let factor = (q.budget as f32 - quiet * least) / sum;
        let share = |(d, quiet): (&f32, &bool)| if *quiet { least } else { factor * d };
        shares = pixels().map(share).collect();
        let quiet: Vec<_> = shares.iter().map(|n| *n <= least).collect();
        if quiet == is_quiet {
            break;
        }
        is_quiet = quiet;
    }
    shares
}

/// `floor` for each pixel, and the rest of the budget in proportion to the deviations.
fn above(floor: u32, q: &SpendBudget) -> Vec<f32> {
    let sum: f32 = q.deviations.iter().sum();
    let rest = (q.budget - floor * q.deviations.len() as u32) as f32;
    let share = |d: &f32| if sum > 0.0 { d / sum } else { 0.0 };
    let shares = q.deviations.iter().map(share);
    shares.map(|share| floor as f32 + share * rest).collect()
}

fn in_proportion(q: &SpendBudget) -> Vec<f32> {
    above(0, q)
}

fn least_first(q: &SpendBudget) -> Vec<f32> {
    above(q.least, q)
}

/// Half of the budget equally, and the other half in proportion; no less than the minimum.
fn half_equally(q: &SpendBudget) -> Vec<f32> {
    let (pixels, sum) = (q.deviations.len() as f32, q.deviations.iter().sum::<f32>());
    let half = 0.5 * q.budget as f32;
    let share = |d: &f32| {
        let own = if sum > 0.0 {
            half * d / sum
        } else {
            half / pixels
        };
        (half / pixels + own).max(q.least as f32)
    };
    q.deviations.iter().map(share).collect()
}

/// Rounds down; a share just below a whole number, by rounding, counts as that number.
fn down(share: f32) -> f32 {
    (share + 1e-4).floor()
}

/// Nobody gets the rest.
const LOST: Turns = |_, _| Vec::new();

/// Those get it that lost most by being rounded down.
const BY_REMAINDERS: Turns = |_, shares| {
    let lost = |i: &usize| shares[*i] - down(shares[*i]);
    let mut turns: Vec<_> = (0..shares.len()).collect();
    turns.sort_by(|one, other| lost(other).total_cmp(&lost(one)));
    turns
};

/// The last pixel gets it.
const TO_THE_LAST: Turns = |_, shares| (0..shares.len()).next_back().into_iter().collect();

/// The pixel of the largest deviation gets it; of equal ones the first.
const TO_THE_NOISIEST: Turns = |q, _| {
    let largest = q.deviations.iter().copied().fold(0.0, f32::max);
    let noisiest = q.deviations.iter().position(|d| *d == largest);
    noisiest.into_iter().collect()
};

impl Graded for SpendBudget {
    fn random(rng: &mut Pcg) -> SpendBudget {
        let pixels = rng.random_range(3..=9);
        let deviation = |_| 0.02 * 50.0_f32.powf(sample::number(rng, 0.0, 1.0));
        let deviations = (0..pixels).map(deviation).collect();
        let least = rng.random_range(2..=6);
        SpendBudget {
            deviations,
            least,
            budget: pixels * (least + rng.random_range(8..=30)) + rng.random_range(0..pixels),
        }
    }

    /// By the sum of the variances: another way to round is as good.
    fn judge(q: &SpendBudget, golden: &Vec<u32>, got: &Vec<u32>) -> Verdict {
        if got.len() != q.deviations.len() {
            return Err(format!(
                "there are {} counts for {} pixels",
                got.len(),
                q.deviations.len()
            ));
        }
        if let Some(i) = got.iter().position(|n| *n < q.least) {
            return Err(format!(
                "pixel {} gets {} samples; the least is {}",
                i + 1,
                got[i],
                q.least
            ));
        }
        let spent: u64 = got.iter().map(|n| u64::from(*n)).sum();
        let budget = u64::from(q.budget);
        if spent != budget {
            let much = if spent > budget {
                "too many"
            } else {
                "too few"
            };
            return Err(format!(
                "{spent} samples are spent, which is {much}; the budget is {budget}"
            ));
        }
        let (best, yours) = (
            variance(&q.deviations, golden),
            variance(&q.deviations, got),
        );
        if yours > (1.0 + SLACK) * best + 1e-12 {
            let worse = 100.0 * (yours / best - 1.0);
            return Err(format!(
                "the sum of σ²/n is {worse:.0} % larger than it could be"
            ));
        }
        Ok(())
    }

    fn traits(q: &SpendBudget, got: &Vec<u32>) -> Vec<f64> {
        let sum = got.iter().map(|n| f64::from(*n)).sum::<f64>();
        let budget = f64::from(q.budget.max(1));
        let shares = got.iter().map(|n| f64::from(*n) / budget);
        let pairs = || {
            shares
                .clone()
                .zip(q.deviations.iter().map(|s| f64::from(*s)))
        };
        let loudest = f64::from(q.deviations.iter().copied().fold(0.0, f32::max)).max(1e-9);
        vec![
            sum / budget,
            f64::from(got.iter().copied().min().unwrap_or(0)) / f64::from(q.least.max(1)) * 0.1,
            shares.clone().fold(0.0, f64::max),
            pairs().map(|(n, s)| n * s / loudest).sum(),
            shares.clone().map(|n| n * n).sum(),
        ]
    }

    const FIXED: &'static [&'static str] = &["budget", "least", "deviations"];

    const FLAWS: &'static [Flaw] = &[
        Flaw {
            complaint: "counts for",
            name: "gives another number of counts than there are pixels",
            hint: "How many pixels are there, and how many numbers do you return?",
        },
        Flaw {
            complaint: "; the least is",
            name: "gives some pixels fewer samples than the minimum",
            hint: "Does each of your pixels get its minimum, even a pixel whose samples are all alike?",
        },
        Flaw {
            complaint: "which is too many",
            name: "spends more than the budget",
            hint: "Add up your samples: is the sum the budget? Does the minimum come out of the budget or on top of it, and which way do you round?",
        },
        Flaw {
            complaint: "which is too few",
            name: "does not spend all of the budget",
            hint: "Add up your samples: is the sum the budget? Which pixels get what is lost by rounding down?",
        },
        Flaw {
            complaint: "larger than it could be",
            name: "does not share in proportion to the deviation, the minimum included",
            hint: "Twice the deviation wants twice the samples. A pixel that gets the minimum although its share would be smaller takes from the others: do you share again what is left for them?",
        },
    ];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "gives all pixels the same",
            hint: "A pixel whose samples are all alike: what does it gain by another one?",
            answer: |q| spent(q, |how| how.weight = |_| 1.0),
        },
        Mistake {
            name: "shares by the variance",
            hint: "Twice the deviation: does that want twice the samples, or four times as many? Try two pixels by hand.",
            answer: |q| {
                spent(q, |how| {
                    (how.weight, how.shares) = (|d: f32| d * d, least_first);
                })
            },
        },
        Mistake {
            name: "shares by the root of the deviation",
            hint: "Twice the deviation: does that want twice the samples, or fewer? Try two pixels by hand.",
            answer: |q| spent(q, |how| (how.weight, how.shares) = (f32::sqrt, least_first)),
        },
        Mistake {
            name: "shares without the minimum, so that quiet pixels get too little",
            hint: "Does each of your pixels get its minimum?",
            answer: |q| spent(q, |how| how.shares = in_proportion),
        },
        Mistake {
            name: "gives each pixel its minimum, and shares only the rest in proportion",
            hint: "Two pixels, one with twice the deviation of the other, and a small minimum: has the noisier one twice the samples, all counted?",
            answer: |q| spent(q, |how| how.shares = least_first),
        },
        Mistake {
            name: "gives each pixel its minimum, and shares only the rest in proportion (the largest remainders rounded up)",
            hint: "Two pixels, one with twice the deviation of the other, and a small minimum: has the noisier one twice the samples, all counted?",
            answer: |q| {
                spent(q, |how| {
                    (how.shares, how.rest) = (least_first, BY_REMAINDERS);
                })
            },
        },
        Mistake {
            name: "gives all that is left beyond the minimum to the pixel of the largest deviation",
            hint: "When the worst pixel has ten times as many samples as the others, is it still the worst?",
            answer: |q| {
                spent(q, |how| {
                    how.shares = |q| vec![q.least as f32; q.deviations.len()];
                    how.rest = TO_THE_NOISIEST;
                })
            },
        },
        Mistake {
            name: "loses what it rounds down",
            hint: "Add up your samples: is the sum the budget?",
            answer: |q| spent(q, |how| (how.shares, how.rest) = (least_first, LOST)),
        },
        Mistake {
            name: "gives all that rounding leaves to the last pixel",
            hint: "Each share was rounded down by less than one sample: how many of the samples left over should one pixel get?",
            answer: |q| spent(q, |how| how.rest = TO_THE_LAST),
        },
        Mistake {
            name: "raises shares to the minimum without taking that from the others",
            hint: "Add up your samples: is the sum the budget? Who pays for a quiet pixel's minimum?",
            answer: |q| spent(q, |how| (how.shares, how.count) = (in_proportion, u32::max)),
        },
        Mistake {
            name: "raises shares to the minimum without taking that from the others, and gives away what rounding leaves only where the budget is not spent yet",
            hint: "Add up your samples: is the sum the budget? Who pays for a quiet pixel's minimum?",
            answer: |q| {
                spent(q, |how| {
                    how.shares = |q| {
                        let raised = in_proportion(q).into_iter();
                        raised.map(|share| share.max(q.least as f32)).collect()
                    };
                    how.rest = BY_REMAINDERS;
                })
            },
        },
        Mistake {
            name: "gives each pixel its minimum on top of the budget",
            hint: "Add up your samples: is the sum the budget?",
            answer: |q| {
                spent(q, |how| {
                    (how.shares, how.count) =
                        (in_proportion, |count: u32, least: u32| count + least);
                })
            },
        },
        Mistake {
            name: "rounds each share down, raised to the minimum without taking that from the others",
            hint: "Add up your samples: is the sum the budget? Who pays for a quiet pixel's minimum?",
            answer: |q| {
                spent(q, |how| {
                    (how.shares, how.rest, how.count) = (in_proportion, LOST, u32::max);
                })
            },
        },
        Mistake {
            name: "rounds each share to the nearest number",
            hint: "Add up your samples: is the sum the budget? A half up here and a half down there need not cancel.",
            answer: |q| spent(q, |how| (how.rounded, how.rest) = (f32::round, LOST)),
        },
        Mistake {
            name: "rounds each share up",
            hint: "Add up your samples: is the sum the budget?",
            answer: |q| spent(q, |how| (how.rounded, how.rest) = (f32::ceil, LOST)),
        },
        Mistake {
            name: "rounds each share down, and loses the rest",
            hint: "Add up your samples: is the sum the budget?",
            answer: |q| spent(q, |how| (how.rounded, how.rest) = (f32::floor, LOST)),
        },
        Mistake {
            name: "shares in inverse proportion to the deviation",
            hint: "Twice the deviation: does that want more samples, or fewer?",
            answer: |q| {
                spent(q, |how| {
                    (how.weight, how.shares) = (|d: f32| 1.0 / d.max(1e-6), least_first);
                })
            },
        },
        Mistake {
            name: "returns the counts by size, the least first",
            hint: "To which pixel belongs the first of your counts, if you sort them?",
            answer: |q| {
                let mut counts = Self::right(q);
                counts.sort_unstable();
                counts
            },
        },
        Mistake {
            name: "returns the counts by size, the largest first",
            hint: "To which pixel belongs the first of your counts, if you sort them?",
            answer: |q| {
                let mut counts = Self::right(q);
                counts.sort_unstable_by(|a, b| b.cmp(a));
                counts
            },
        },
        Mistake {
            name: "gives only the minimum where all deviations are 0",
            hint: "Of a picture whose samples are all alike, is the budget spent too?",
            answer: |q| {
                if q.deviations.iter().all(|d| *d == 0.0) {
                    vec![q.least; q.deviations.len()]
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "gives all that rounding leaves to the pixel of the largest deviation",
            hint: "Each share was rounded by less than one sample: how many of the samples left over should one pixel get?",
            answer: |q| spent(q, |how| how.rest = TO_THE_NOISIEST),
        },
        Mistake {
            name: "gives all that rounding leaves to the first pixel",
            hint: "Each share was rounded by less than one sample: how many of the samples left over should one pixel get?",
            answer: |q| {
                spent(q, |how| {
                    how.rest = |_, shares| (0..shares.len().min(1)).collect();
                })
            },
        },
        Mistake {
            name: "rounds each share to the nearest number, and lets the last pixel have or pay the difference",
            hint: "Does the last pixel keep its minimum when it pays for what was rounded up?",
            answer: |q| spent(q, |how| (how.rounded, how.rest) = (f32::round, TO_THE_LAST)),
        },
        Mistake {
            name: "looks only once for pixels that get the minimum",
            hint: "A pixel that gets the minimum leaves less for the others: may another one fall below the minimum by that?",
            answer: |q| spent(q, |how| how.shares = |q| shared(q, 1)),
        },
        Mistake {
            name: "looks only once for pixels whose share is below the minimum, and raises those that fall below it later on top of the budget",
            hint: "A pixel that gets the minimum leaves less for the others: may another one fall below the minimum by that?",
            answer: |q| {
                spent(q, |how| {
                    how.shares = |q| {
                        let raised = shared(q, 1).into_iter();
                        raised.map(|share| share.max(q.least as f32)).collect()
                    };
                })
            },
        },
        Mistake {
            name: "rounds down where all deviations are 0, and loses the rest",
            hint: "Of a picture whose samples are all alike, is the whole budget spent too?",
            answer: |q| {
                if q.deviations.iter().all(|d| *d == 0.0) {
                    spent(q, |how| how.rest = LOST)
                } else {
                    Self::right(q)
                }
            },
        },
        Mistake {
            name: "returns only what each pixel gets beyond the minimum",
            hint: "Add up your samples: is the sum the budget?",
            answer: |q| {
                let counts = Self::right(q).into_iter();
                counts.map(|n| n.saturating_sub(q.least)).collect()
            },
        },
        Mistake {
            name: "shares by the variance (the minimum taken into account)",
            hint: "Twice the deviation: does that want four times the samples? Try two pixels by hand.",
            answer: |q| Self::misread(q, |q| q.deviations.iter_mut().for_each(|d| *d *= *d)),
        },
        Mistake {
            name: "shares by the root of the deviation (the minimum taken into account)",
            hint: "Twice the deviation: does that want twice the samples? Try two pixels by hand.",
            answer: |q| Self::misread(q, |q| q.deviations.iter_mut().for_each(|d| *d = d.sqrt())),
        },
        Mistake {
            name: "shares by the variance (the minimum taken into account, and the largest remainders rounded up)",
            hint: "Twice the deviation: does that want four times the samples? Try two pixels by hand.",
            answer: |q| {
                spent(q, |how| {
                    (how.weight, how.rest) = (|d: f32| d * d, BY_REMAINDERS);
                })
            },
        },
        Mistake {
            name: "shares by the variance (the minimum taken into account, and what rounding leaves given to the first pixels)",
            hint: "Twice the deviation: does that want four times the samples? Try two pixels by hand.",
            answer: |q| spent(q, |how| how.weight = |d| d * d),
        },
        Mistake {
            name: "shares by the root of the deviation (the minimum taken into account, and the largest remainders rounded up)",
            hint: "Twice the deviation: does that want twice the samples? Try two pixels by hand.",
            answer: |q| spent(q, |how| (how.weight, how.rest) = (f32::sqrt, BY_REMAINDERS)),
        },
        Mistake {
            name: "shares by the root of the deviation (the minimum taken into account, and what rounding leaves given to the first pixels)",
            hint: "Twice the deviation: does that want twice the samples? Try two pixels by hand.",
            answer: |q| spent(q, |how| how.weight = f32::sqrt),
        },
        Mistake {
            name: "gives each further sample to the pixel with the largest σ²/n, not to the one whose σ²/n it lowers most",
            hint: "Two pixels have the same σ²/n, one of 2 samples and one of 20: for which of them does another sample lower it more?",
            answer: |q| {
                spent(q, |how| {
                    how.shares = |q| one_by_one(q, |d, n| d * d / n);
                })
            },
        },
        Mistake {
            name: "gives each further sample to the pixel whose σ/√n it lowers most, not to the one whose σ²/n it lowers most",
            hint: "Of which numbers is the sum to be the least: of standard errors, or of their squares?",
            answer: |q| {
                spent(q, |how| {
                    how.shares =
                        |q| one_by_one(q, |d, n| d * (1.0 / n.sqrt() - 1.0 / (n + 1.0).sqrt()));
                })
            },
        },
        Mistake {
            name: "shares half of the budget equally, and the other half in proportion",
            hint: "Two pixels without a minimum, one with twice the deviation of the other: has the noisier one twice the samples?",
            answer: |q| {
                spent(q, |how| {
                    (how.shares, how.rest) = (half_equally, BY_REMAINDERS);
                })
            },
        },
        Mistake {
            name: "shares by σ^(2/3) (the minimum taken into account), for which the sum of the standard errors is least",
            hint: "Of which numbers is the sum to be the least: of standard errors, or of their squares?",
            answer: |q| {
                Self::misread(q, |q| {
                    q.deviations.iter_mut().for_each(|d| *d = d.powf(2.0 / 3.0));
                })
            },
        },
        Mistake {
            name: "shares by σ^(2/3) (the minimum taken into account, and the largest remainders rounded up), for which the sum of the standard errors is least",
            hint: "Of which numbers is the sum to be the least: of standard errors, or of their squares?",
            answer: |q| {
                spent(q, |how| {
                    (how.weight, how.rest) = (|d: f32| d.powf(2.0 / 3.0), BY_REMAINDERS);
                })
            },
        },
    ];
}

/// The minimum for each pixel, and each further sample to the one that has it most urgently by its deviation and its samples; of equal ones to
/// the first.
fn one_by_one(q: &SpendBudget, urgency: fn(d: f64, n: f64) -> f64) -> Vec<f32> {
    /// More samples are not handed out one by one: a misread question may have any budget.
    const MOST: u32 = 100_000;
    let mut counts = vec![q.least; q.deviations.len()];
    let urgent = |d: &f32, n: u32| urgency(f64::from(*d), f64::from(n).max(1e-9));
    let mut urgencies: Vec<_> = q.deviations.iter().map(|d| urgent(d, q.least)).collect();
    for _ in 0..q.budget.saturating_sub(counts.iter().sum()).min(MOST) {
        let most = urgencies.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let Some(i) = urgencies.iter().position(|one| *one == most) else {
            break;
        };
        counts[i] += 1;
        urgencies[i] = urgent(&q.deviations[i], counts[i]);
    }
    counts.into_iter().map(|count| count as f32).collect()
}
