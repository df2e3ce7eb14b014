//! What goes into a step, found by trying: if twice the value of another step makes a step twice as large, it is a factor; if a little
//! more of it makes it as much larger, a summand. So slips in one operation have their names without a word in any exercise.

use super::brackets::{Input, brackets};
use super::possible::short;
use crate::attempt::attempt;
use crate::explain::Explainer;
use crate::explain::slip::{Change, Mixed, Place, Slip};
use crate::explain::way::{Step, Walked, Way};

/// How a value goes into a step, in every question that was tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operand {
    /// As a factor with this power: 1; −1 for a divisor; 2 for a square.
    Factor(f64),
    /// As a summand with this factor: 1; −1 if it is subtracted.
    Summand(f64),
}

/// A slip in one operation: what it does, how common it is, and the slip.
pub struct Operation {
    /// What is done at the step, as a verb.
    pub name: String,
    /// How common it is.
    pub rank: u32,
    /// The slip itself.
    pub slip: Slip,
}

/// What a value is moved by to see who moves with it.
const MOVED: f64 = 0.25;

/// The slips with the values that go into each of the steps by an operation of its own. Of two values the one that goes into fewer
/// steps comes first: it is nearer to the step, and what goes into it is in the step through it. Where the answers tell much, also those
/// with values that do not belong into a step which is made of others.
pub fn operations(
    explainer: &Explainer,
    way: usize,
    questions: &[&[f64]],
    steps: &[&Step],
    tells: bool,
) -> Vec<(Place, Operation)> {
    let walk = |question: &[f64], mut steps: Way| {
        attempt(|| {
            (explainer.work)(way, question, &mut steps);
            steps.end()
        })
    };
    let plain: Vec<_> = questions.iter().map(|q| walk(q, Way::default())).collect();
    let (mut all, mut made) = (Vec::new(), Vec::new());
    for of in steps {
        let changed = |change| -> Vec<_> {
            let slip = Slip::Value(of.place, Change::Each(change));
            let each = questions.iter().map(|q| walk(q, Way::watched(slip)));
            each.collect()
        };
        let (doubled, moved) = (changed(|v| 2.0 * v), changed(|v| v + MOVED));
        let (mut touched, mut found) = (0, Vec::new());
        for at in steps.iter().filter(|at| at.place != of.place) {
            let values = |walks| values(walks, at.place);
            let (base, doubled, moved) = (values(&plain), values(&doubled), values(&moved));
            if base != doubled || base != moved {
                touched += 1;
                made.push(at.place);
            }
            if ![1, at.value.len()].contains(&of.value.len()) {
                continue;
            }
            let operand = power(&base, &doubled).map(Operand::Factor);
            let operand = operand.or_else(|| factor(&base, &moved).map(Operand::Summand));
            found.extend(operand.map(|operand| (*at, operand)));
        }
        all.push((touched, *of, found));
    }
    all.sort_by_key(|(touched, ..)| *touched);
    let mut operations = Vec::new();
    for (_, of, found) in &all {
        for (at, operand) in found {
            for (name, rank, how) in operand.slips(&short(of)) {
                let mut add = |name: String, rank, only| {
                    let of = of.place;
                    let at = at.place;
                    let slip = Slip::Mix { at, of, how, only };
                    operations.push((at, Operation { name, rank, slip }));
                };
                for (i, axis) in at.axes.iter().enumerate() {
                    add(format!("{name}, in {axis} only"), rank + 3, Some(i));
                }
                add(name, rank, None);
            }
        }
    }
    let goes_in = |(_, of, found): &(usize, &Step, Vec<(&Step, Operand)>)| {
        let (of, name) = (of.place, short(of));
        let into = found.iter().map(move |(at, how)| Input {
            of,
            name: name.clone(),
            at: at.place,
            how: *how,
        });
        into.collect::<Vec<_>>()
    };
    let all: Vec<_> = all.iter().flat_map(goes_in).collect();
    operations.extend(brackets(&all));
    for at in steps.iter().filter(|at| tells && made.contains(&at.place)) {
        let others = steps.iter().filter(|of| of.place != at.place);
        let slips = others.flat_map(|of| foreign(at, of));
        operations.extend(slips.map(|slip| (at.place, slip)));
    }
    operations
}

/// What is done at a step with the value of another that does not belong into it.
fn foreign(at: &Step, of: &Step) -> Vec<Operation> {
    /// The rank of these slips.
    const SELDOM: u32 = 13;
    let name = short(of);
    let is_alike = of.unit == at.unit && of.value.len() == at.value.len();
    let is_pure = of.unit.is_empty() && of.value.len() == 1;
    let fits = [1, at.value.len()].contains(&of.value.len());
    let times = |power| Mixed::Times { power, by: 1.0 };
    let all = [
        (fits, format!("multiplies by “{name}” too"), times(1.0)),
        (fits, format!("divides by “{name}” too"), times(-1.0)),
        (is_alike, format!("adds “{name}” too"), Mixed::Plus(1.0)),
        (
            is_alike,
            format!("subtracts “{name}” too"),
            Mixed::Plus(-1.0),
        ),
        (
            is_pure,
            format!("raises to the power of “{name}” too"),
            Mixed::Raised,
        ),
    ];
    let slip = |(_, name, how)| Operation {
        name,
        rank: SELDOM,
        slip: Slip::Mix {
            at: at.place,
            of: of.place,
            how,
            only: None,
        },
    };
    all.into_iter()
        .filter(|(fits, ..)| *fits)
        .map(slip)
        .collect()
}

/// The numbers of one question's walk at one step, at all times that it is gone; none if the walk does not end.
type Numbers = Option<Vec<f64>>;

fn values(walks: &[Option<Walked>], place: Place) -> Vec<Numbers> {
    let of_walk = |walked: &Walked| {
        let steps = walked.steps.iter().chain(&walked.untold);
        let steps = steps.filter(|step| step.place == place);
        steps.flat_map(|step| step.value.iter().copied()).collect()
    };
    walks
        .iter()
        .map(|walked| walked.as_ref().map(of_walk))
        .collect()
}

/// The pairs of numbers before and after a change, in the questions whose walks go the same way.
fn pairs<'a>(base: &'a [Numbers], changed: &'a [Numbers]) -> impl Iterator<Item = (f64, f64)> + 'a {
    let each = base.iter().zip(changed);
    let both = each.filter_map(|(base, changed)| Some((base.as_ref()?, changed.as_ref()?)));
    let same = both.filter(|(base, changed)| base.len() == changed.len());
    same.flat_map(|(base, changed)| base.iter().copied().zip(changed.iter().copied()))
}

/// The power with which a step grows if a value doubles; none if it has none.
fn power(base: &[Numbers], doubled: &[Numbers]) -> Option<f64> {
    let mut power = None;
    for (before, after) in pairs(base, doubled) {
        if before == 0.0 && after == 0.0 {
            continue;
        }
        let halves = (2.0 * (after / before).log2()).round();
        let exact = before * (0.5 * halves).exp2();
        let is_power =
            halves != 0.0 && halves.abs() <= 8.0 && (exact - after).abs() <= 1e-6 * after.abs();
        if !is_power || power.is_some_and(|power| power != 0.5 * halves) {
            return None;
        }
        power = Some(0.5 * halves);
    }
    power
}

/// How many times a value's move a step moves; none if that is not always the same.
fn factor(base: &[Numbers], moved: &[Numbers]) -> Option<f64> {
    let mut first = None;
    for (before, after) in pairs(base, moved) {
        let factor = (after - before) / MOVED;
        let allowed = 1e-6 * (1.0 + before.abs());
        let first = *first.get_or_insert(factor);
        if !factor.is_finite() || (factor - first).abs() > allowed {
            return None;
        }
    }
    first.filter(|factor| factor.abs() > 1e-3)
}

impl Operand {
    /// What people do wrong with it: in words, how common it is, and how it goes into the step beside what is right.
    fn slips(self, name: &str) -> Vec<(String, u32, Mixed)> {
        match self {
            Self::Factor(power) => factor_slips(power, name),
            Self::Summand(factor) => summand_slips(factor, name),
        }
    }
}

fn factor_slips(power: f64, name: &str) -> Vec<(String, u32, Mixed)> {
    let times = |power: f64| Mixed::Times { power, by: 1.0 };
    let what = match power.abs() {
        1.0 => format!("“{name}”"),
        2.0 => format!("the square of “{name}”"),
        0.5 => format!("the square root of “{name}”"),
        power => format!("the power {power} of “{name}”"),
    };
    let [without, inverted, twice] = if power > 0.0 {
        [
            format!("leaves out the factor {what}"),
            format!("divides by {what} instead of multiplying by it"),
            format!("multiplies by {what} twice"),
        ]
    } else {
        [
            format!("does not divide by {what}"),
            format!("multiplies by {what} instead of dividing by it"),
            format!("divides by {what} twice"),
        ]
    };
    let mut slips = vec![
        (without, 9, times(-power)),
        (inverted, 9, times(-2.0 * power)),
        (twice, 12, times(power)),
    ];
    if power.abs() == 1.0 {
        let added = if power > 0.0 {
            format!("adds “{name}” instead of multiplying by it")
        } else {
            format!("subtracts “{name}” instead of dividing by it")
        };
        slips.push((added, 11, Mixed::Added(power)));
        let root = format!("takes the square root of “{name}” there");
        slips.push((root, 12, times(-0.5 * power)));
    } else {
        let plain = format!("takes “{name}” instead of {what}");
        slips.push((plain, 9, times(power.signum() - power)));
    }
    if power.abs() >= 2.0 {
        // Of high powers one less is as often written as one more; of a square the number itself, as above.
        let less = (power.abs() > 2.0).then_some((-1.0, 10));
        for (more, rank) in less.into_iter().chain([(1.0, 12)]) {
            let other = power.abs() + more;
            let name = format!("takes the power {other} of “{name}” instead of {what}");
            slips.push((name, rank, times(more * power.signum())));
        }
    }
    if power == 2.0 {
        let doubled = format!("takes twice “{name}” instead of its square");
        let how = Mixed::Times {
            power: -1.0,
            by: 2.0,
        };
        slips.push((doubled, 10, how));
    }
    slips
}

fn summand_slips(factor: f64, name: &str) -> Vec<(String, u32, Mixed)> {
    let [turned, twice] = if factor > 0.0 {
        [
            format!("subtracts “{name}” instead of adding it"),
            format!("adds “{name}” twice"),
        ]
    } else {
        [
            format!("adds “{name}” instead of subtracting it"),
            format!("subtracts “{name}” twice"),
        ]
    };
    let mut slips = vec![
        (
            format!("leaves out the summand “{name}”"),
            9,
            Mixed::Plus(-factor),
        ),
        (turned, 9, Mixed::Plus(-2.0 * factor)),
        (twice, 12, Mixed::Plus(factor)),
    ];
    let done = if factor > 0.0 {
        "adding"
    } else {
        "subtracting"
    };
    let multiplied = format!("multiplies by “{name}” instead of {done} it");
    slips.push((multiplied, 11, Mixed::Multiplied(factor)));
    if (factor.abs() - 1.0).abs() > 1e-3 {
        let bare = format!("takes “{name}” without its factor");
        slips.push((bare, 10, Mixed::Plus(factor.signum() - factor)));
    }
    slips
}
