//! A step whose value is multiplied by a number that nobody thought of, or to which one is added.

use super::possible::{RANK, longest, passed, short};
use super::{Slip, Slipped, id};
use crate::diagnose::evidence::Evidence;
use crate::diagnose::fit::factor::{factor, summand};
use crate::explain::slip::Fitted;
use crate::explain::way::Step;
use crate::explain::{Explainer, find};

/// Rarer than what people are known to do.
const RARE: u32 = RANK + 13;

/// Steps with a number that fits.
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
    let slipped = |(step, hint): &(Step, &'static str), fitted: Fitted| {
        let what = match fitted {
            Fitted::Times(by) => format!("takes {by} times the value"),
            Fitted::Plus(more) if more < 0.0 => format!("takes the value minus {}", -more),
            Fitted::Plus(more) => format!("takes the value plus {more}"),
        };
        let slip = Slip::Fitted(step.place, fitted);
        Slipped {
            name: format!("goes wrong at the step “{}”: {what}", short(step)),
            hint: (*hint).to_owned(),
            rank: RARE,
            explainer,
            way,
            slip,
            id: id(&slip),
            most,
        }
    };
    let answer = |step, fitted, k: usize| slipped(step, fitted).answer(&evidence.items[k].question);
    let times = passed.steps.iter().filter_map(|step| {
        let by = factor(evidence, &|by, k| answer(step, Fitted::Times(by), k));
        Some(slipped(step, Fitted::Times(by?)))
    });
    // What is added to a vector has a direction.
    let numbers = passed
        .steps
        .iter()
        .filter(|(step, _)| step.value.len() == 1);
    let plus = numbers.filter_map(|step| {
        let more = summand(evidence, &|more, k| answer(step, Fitted::Plus(more), k));
        Some(slipped(step, Fitted::Plus(more?)))
    });
    times.chain(plus).collect()
}
