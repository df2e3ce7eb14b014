//! A step whose value is multiplied by a number that nobody thought of.

use super::possible::{RANK, longest, passed, short};
use super::{Slip, Slipped, id};
use crate::diagnose::evidence::Evidence;
use crate::diagnose::fit::factor::factor;
use crate::explain::way::Step;
use crate::explain::{Explainer, find};

/// Rarer than what people are known to do.
const RARE: u32 = RANK + 13;

/// Steps whose values are multiplied by a number that fits.
pub fn fitted(evidence: &Evidence<'_>) -> Vec<Slipped> {
    let Some(explainer) = find(evidence.examiner.name()) else {
        return Vec::new();
    };
    let of_way = |way| fitted_on(explainer, way, evidence);
    (0..explainer.ways).flat_map(of_way).collect()
}

fn fitted_on(explainer: &'static Explainer, way: usize, evidence: &Evidence<'_>) -> Vec<Slipped> {
    let Some(passed) = passed(explainer, way, evidence) else {
        return Vec::new();
    };
    let most = longest(&passed);
    let fitted = |(step, hint): &(Step, &'static str)| {
        let slipped = |by: f64| Slipped {
            name: format!(
                "goes wrong at the step “{}”: takes {by} times the value",
                short(step)
            ),
            hint: (*hint).to_owned(),
            rank: RARE,
            explainer,
            way,
            slip: Slip::Scaled(step.place, by),
            id: id(&Slip::Scaled(step.place, by)),
            most,
        };
        let answer = |by: f64, k: usize| slipped(by).answer(&evidence.items[k].question);
        factor(evidence, &answer).map(slipped)
    };
    passed.steps.iter().filter_map(fitted).collect()
}
