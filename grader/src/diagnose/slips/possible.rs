//! The slips that the steps of a way allow: what people do wrong there, in words, and how common it is.

use super::habits::{AMONG, CHOICES, COMMON, EARLIER, NEAR, ORDERS, POWERS, ROUNDS, SIDES, limits};
use super::operands;
use super::{Slipped, id};
use crate::diagnose::evidence::{Evidence, stretches};
use crate::diagnose::function::FUNCTIONS;
use crate::explain::Explainer;
use crate::explain::slip::{Change, Slip};
use crate::explain::way::{Asks, Choice, Limit, Met, Spot, Step, Way};
use std::borrow::Cow;
use std::cmp::Reverse;

/// A slip is told only if nothing simpler explains the answers as well.
pub const RANK: u32 = 14;

/// A way with a slip may be this many times as long as the longest without, and this many steps longer.
const LONGER: (usize, usize) = (20, 1000);

/// No more steps than these, in all questions, are tried with slips: an estimate has a thousand times as many as a formula.
const LONG: usize = 300_000;

/// More questions than these tell nothing new about the form of a formula.
const QUESTIONS: usize = 6;

/// What a way comes by in these questions: at each place the first.
#[derive(Default)]
pub(super) struct Passed {
    /// Each with what leads on.
    pub steps: Vec<(Step, &'static str)>,
    met: Met,
    /// How well each question serves to try slips.
    serve: Vec<(Reverse<usize>, usize)>,
    /// The number of steps and decisions of the longest.
    longest: usize,
}

/// None if the way is too long.
pub(super) fn passed(
    explainer: &Explainer,
    number: usize,
    evidence: &Evidence<'_>,
) -> Option<Passed> {
    let mut passed = Passed::default();
    let mut length = 0;
    for item in &evidence.items {
        let mut way = Way::default();
        (explainer.work)(number, &item.question, &mut way);
        let walked = way.end();
        length += walked.length;
        passed.longest = passed.longest.max(walked.length);
        passed.serve.push(walked.serves());
        if length > LONG {
            return None;
        }
        let of_told = if number == 0 { TOLD } else { BY_HAND };
        let told = walked.steps.into_iter().map(|step| (step, of_told));
        let untold = walked.untold.into_iter().map(|step| (step, BY_HAND));
        for (step, hint) in told.chain(untold) {
            let mut known = passed.steps.iter();
            if !step.value.is_empty() && !known.any(|(one, _)| one.place == step.place) {
                passed.steps.push((step, hint));
            }
        }
        passed.met.add(walked.met);
    }
    Some(passed)
}

/// How long a way with a slip may be.
pub(super) fn longest(passed: &Passed) -> usize {
    LONGER.0 * passed.longest + LONGER.1
}

/// Every slip that the steps of one way allow in these questions.
pub(super) fn slips(
    explainer: &'static Explainer,
    number: usize,
    evidence: &Evidence<'_>,
) -> Vec<Slipped> {
    let Some(passed) = passed(explainer, number, evidence) else {
        return Vec::new();
    };
    let steps = &passed.steps;
    let mut all = Vec::new();
    let mut add = |name, hint: &str, rank, slip| {
        all.push(Slipped {
            name,
            hint: hint.to_owned(),
            rank: RANK + rank,
            explainer,
            way: number,
            id: id(&slip),
            slip,
            most: longest(&passed),
        });
    };
    let has_angles = steps.iter().any(|(step, _)| step.unit == "rad");
    // What is wrong in one case only, or one answer for all that are wrong, is a branch's, and by chance that of many a function; but not
    // of one that leaves most numbers as they are.
    let is_one = evidence.wrong == 1 || evidence.is_one_answer();
    // Yes and no, or one number or two, are explained by some rare function of some step by chance, and one yes or no by any.
    let rarest = match () {
        () if evidence.tells_much() => u32::MAX,
        () if evidence.tells_in_all() < 1.0 => 0,
        () => RAREST,
    };
    // Of yes and no a decision or a loop is rather wrong than a number.
    let seldom = if evidence.tells_much() { 0 } else { 2 };
    for (step, hint) in steps {
        let name = short(step);
        let at = step.place;
        let changes = changes(step, has_angles, is_one).filter(|(_, _, rank, _)| *rank <= rarest);
        for (what, leads_on, rank, change) in changes {
            let name = format!("goes wrong at the step “{name}”: {what}");
            let hint = leads_on.unwrap_or(hint);
            add(name, hint, rank + seldom, Slip::Value(at, change));
        }
        for (rank, what, from) in EARLIER {
            let name = format!("takes for “{name}” {what}");
            add(name, ROUND, *rank, Slip::Earlier(at, *from));
        }
        for (other, _) in steps {
            let fits = [1, step.value.len()].contains(&other.value.len());
            if other.place != at && fits {
                let of = short(other);
                let name = format!("takes the value of “{of}” where that of “{name}” belongs");
                let of = other.place;
                // What has another unit or another number of components is seldom taken by mistake.
                let is_alike = other.unit == step.unit && other.value.len() == step.value.len();
                let rank = if is_alike { 12 } else { 13 };
                let other = |only| Slip::Other { at, of, only };
                for (i, axis) in step.axes.iter().enumerate().filter(|_| is_alike) {
                    if rank + 2 <= rarest {
                        let name = format!("{name}, in {axis} only");
                        add(name, hint, rank + 2, other(Some(i)));
                    }
                }
                if rank <= rarest {
                    add(name, hint, rank, other(None));
                }
            }
        }
    }
    for Choice { name, place, count } in &passed.met.choices {
        let other = steps.iter().filter(|(of, _)| of.value.len() == *count);
        for (of, _) in other {
            let name = format!("goes by “{}” when it chooses {name}", short(of));
            let slip = Slip::ChoiceBy {
                at: *place,
                of: of.place,
            };
            add(name, CHOSEN, 12, slip);
        }
    }
    for Spot { name, place } in &passed.met.powers {
        for (of, _) in steps.iter().filter(|(of, _)| of.value.len() == 1) {
            for (inside, to) in [(false, "outside of"), (true, "inside")] {
                let name = format!("writes “{}” {to} the power “{name}”", short(of));
                let (at, of) = (*place, of.place);
                add(name, POWER, 12, Slip::Factor { at, of, inside });
            }
        }
    }
    let serving = stretches(evidence.items.len(), QUESTIONS, |i| passed.serve[i]);
    let questions = serving.into_iter().map(|i| &*evidence.items[i].question);
    let questions: Vec<_> = questions.collect();
    let named: Vec<_> = steps.iter().map(|(step, _)| step).collect();
    let tells = evidence.is_judged() && evidence.tells_much();
    for (at, operation) in operands::operations(explainer, number, &questions, &named, tells) {
        let (step, hint) = steps
            .iter()
            .find(|(step, _)| step.place == at)
            .expect("it is one of them");
        let name = format!(
            "goes wrong at the step “{}”: {}",
            short(step),
            operation.name
        );
        add(name, hint, operation.rank, operation.slip);
    }
    for (name, hint, rank, slip) in branches(&passed.met, evidence.wrong == 1) {
        add(name, hint, rank, slip);
    }
    all
}

/// The slips in decisions, loops and operations: each with what it does, as a verb, what leads on, and how common it is.
fn branches(met: &Met, is_one: bool) -> Vec<(String, &'static str, u32, Slip)> {
    let mut all = Vec::new();
    let rarest_side = if is_one { LAST_SIDE } else { u32::MAX };
    for one in &met.decisions {
        let (name, place) = (one.name, one.place);
        let mut add = |name, hint, rank, slip| all.push((name, hint, rank, slip));
        let mut turned = |name, rank, of| add(name, CONDITION, rank, Slip::Decision(place, of));
        let never = format!("never takes it into account when {name}");
        let always = format!("always goes on as if {name}");
        let other = format!("decides the other way round whether {name}");
        turned(never, LEFT_OUT, |_| false);
        turned(always, LEFT_OUT, |_| true);
        turned(other, LEFT_OUT + 1, |holds| !holds);
        if one.asks == Asks::Several {
            for (rank, what, of) in AMONG {
                let name = format!("{what} when it decides whether {name}");
                add(name, EACH, *rank, Slip::Among(place, *of));
            }
        }
        if one.asks == Asks::Compared {
            let tie = format!(
                "decides wrongly where both sides are equal whether {name}: < stands for ≤, or ≤ for <"
            );
            add(tie, CONDITION, 10, Slip::Tie(place));
            // Of one wrong answer some number to compare with makes any other.
            for (rank, what, of) in SIDES.iter().filter(|(rank, ..)| *rank <= rarest_side) {
                let sides = format!("{what} when it decides whether {name}");
                add(sides, CONDITION, *rank, Slip::Sides(place, *of));
            }
            for (rank, least) in (10..).zip(NEAR) {
                let near = format!(
                    "takes what is within {least}, or about that, for equal when it decides whether {name}"
                );
                add(near, CONDITION, rank, Slip::Near(place, least));
            }
        }
    }
    for Choice { name, place, .. } in &met.choices {
        for (rank, what, pick) in CHOICES {
            let name = format!("{what} when it chooses {name}");
            all.push((name, CHOSEN, *rank, Slip::Choice(*place, *pick)));
        }
    }
    for Spot { name, place } in &met.loops {
        for (rank, what, of) in ROUNDS {
            let slip = Slip::Rounds(*place, *of);
            all.push((format!("{what} {name}"), FORGOTTEN, *rank, slip));
        }
    }
    for Spot { name, place } in &met.orders {
        for (rank, what, of) in ORDERS {
            let slip = Slip::Ordered(*place, *of);
            all.push((what.replace("{}", name), ORDER, *rank, slip));
        }
    }
    for Limit {
        name,
        place,
        number,
    } in &met.limits
    {
        for (rank, other) in limits(*number) {
            let name = format!("takes {other} for {name}, which is {number}");
            all.push((name, LIMIT, rank, Slip::Limit(*place, other)));
        }
    }
    for Spot { name, place } in &met.operations {
        let slip = Slip::Forgotten(*place);
        all.push((format!("forgets {name}"), FORGOTTEN, LEFT_OUT, slip));
    }
    for Spot { name, place } in &met.powers {
        for (rank, what, of) in POWERS {
            let slip = Slip::Power(*place, *of);
            let name = format!("goes wrong at the step “{name}”: {what}");
            all.push((name, POWER, *rank, slip));
        }
    }
    all
}

/// The rank of the rarest change that is tried on answers which tell little.
const RAREST: u32 = 12;

/// The rank of the last of two sides that are compared without a number that is added.
const LAST_SIDE: u32 = 11;

/// The rank of a condition that is not asked, and of an operation that is forgotten: they are simpler than a value that does the same.
const LEFT_OUT: u32 = 8;

/// What leads on from a step that `raybook explain` tells.
const TOLD: &str = "`raybook explain` shows this step with its right value: print yours beside it.";

/// What leads on from a step that is not told.
const BY_HAND: &str =
    "Calculate this value by hand for the first wrong case, and print yours beside it.";

/// What leads on from a value that is not renewed.
const ROUND: &str =
    "Print this value in every round of your loop: is it calculated again before it is used?";

/// What leads on from a decision.
const CONDITION: &str =
    "Which of your conditions decides this? Print its two sides in the first wrong case.";

/// What leads on from a power.
const POWER: &str = "How does your language write a power, and what does it calculate first? Print the power by itself, with brackets round the exponent.";

/// What leads on from several things that are asked.
const EACH: &str = "Print for each of them in turn what your function finds: which of them are asked, and which of the findings is kept?";

/// What leads on from a choice.
const CHOSEN: &str = "Print, each time that your function chooses, the numbers by which it does, and what it takes: which of them should it be?";

/// What leads on from an order.
const ORDER: &str = "In which order does your function go through them, and in which should it? Print their numbers as it comes by.";

/// What leads on from a number that is written into the program.
const LIMIT: &str = "Which number stands in your program there, and which in the task? Is it compared by < or by ≤?";

/// What leads on from what is forgotten.
const FORGOTTEN: &str = "Go through the first wrong case by hand, line by line, and print what each line gives: which of them is not in your program?";

/// What people make of a step's value: in words, with a question that leads on if there is one, how common it is, and the
/// change itself.
fn changes(
    step: &Step,
    has_angles: bool,
    is_one: bool,
) -> impl Iterator<Item = (String, Option<&'static str>, u32, Change)> {
    let size = step.value.len();
    let common = COMMON.iter().filter(move |one| one.suits(size));
    let common = common.map(|one| (one.called(step.axes), None, one.rank, one.change));
    let functions = FUNCTIONS
        .iter()
        .filter(move |one| !is_one || one.is_selective())
        .filter(move |one| one.suits(&step.value, step.unit, has_angles));
    let functions = functions.map(|function| {
        let name = function.name.replace("the answer", "the value");
        let name = name.replace("returns", "takes");
        let change = Change::Each(function.of);
        (name, Some(function.hint), function.rank, change)
    });
    common.chain(functions)
}

/// The name of a step; without its numbers if it was made for one question.
pub(super) fn short(step: &Step) -> String {
    let name = step.name.trim_end_matches(" =");
    if matches!(step.name, Cow::Borrowed(_)) {
        return name.to_owned();
    }
    let parts = name.split(|c: char| c.is_ascii_digit());
    let parts: Vec<_> = parts.filter(|part| !part.is_empty()).collect();
    parts.join("…")
}
