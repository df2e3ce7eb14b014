//! Brackets that are forgotten, or too many: a factor that goes to one summand where it belongs to both, or to both where it belongs to one.

use super::operands::{Operand, Operation};
use crate::explain::slip::{Bracket, Place, Slip};

/// A value that goes into a step.
pub struct Input {
    /// The step whose value it is.
    pub of: Place,
    /// What that step is called.
    pub name: String,
    /// The step into which it goes.
    pub at: Place,
    /// How it goes in.
    pub how: Operand,
}

/// The slips with brackets: f·x + c for f·(x + c), or the other way round.
pub fn brackets(all: &[Input]) -> Vec<(Place, Operation)> {
    let factors = |at: Place| {
        let into = all.iter().filter(move |one| one.at == at);
        into.filter_map(|one| match one.how {
            Operand::Factor(power) if power.abs() == 1.0 => Some((one, power)),
            _ => None,
        })
    };
    let summands = |at: Place| {
        let into = all.iter().filter(move |one| one.at == at);
        into.filter_map(|one| match one.how {
            Operand::Summand(times) => Some((one, times)),
            Operand::Factor(_) => None,
        })
    };
    let goes_into = |of: Place, at: Place| all.iter().any(|one| one.of == of && one.at == at);
    let mut found = Vec::new();
    let mut add = |at, belongs, (summand, times): (&Input, f64), (factor, power): (&Input, f64)| {
        let name = words(belongs, (&summand.name, times), (&factor.name, power));
        let (summand, factor) = (summand.of, factor.of);
        let bracket = Bracket {
            summand,
            times,
            factor,
            power,
            belongs,
        };
        let slip = Slip::Bracket(at, bracket);
        let rank = 11;
        found.push((at, Operation { name, rank, slip }));
    };
    for into in all {
        let (x, at) = (into.of, into.at);
        match into.how {
            // f·(x + c), where the sum is a step.
            Operand::Factor(1.0) => {
                for factor in factors(at).filter(|(one, _)| one.of != x && !goes_into(one.of, x)) {
                    for summand in summands(x).filter(|(one, _)| one.of != factor.0.of) {
                        add(at, true, summand, factor);
                    }
                }
            }
            // f·x + c, where the product is a step.
            Operand::Summand(_) => {
                for factor in factors(x) {
                    let is_other = |(one, _): &(&Input, f64)| {
                        one.of != x && one.of != factor.0.of && !goes_into(one.of, x)
                    };
                    for summand in summands(at).filter(is_other) {
                        add(at, false, summand, factor);
                    }
                }
            }
            Operand::Factor(_) => {}
        }
    }
    found
}

/// What is done first, and what after it, that should come before.
fn words(belongs: bool, (summand, times): (&str, f64), (factor, power): (&str, f64)) -> String {
    let (adds, adding) = if times < 0.0 {
        ("subtracts", "subtracting")
    } else {
        ("adds", "adding")
    };
    let (multiplies, multiplying) = if power < 0.0 {
        ("divides", "dividing")
    } else {
        ("multiplies", "multiplying")
    };
    if belongs {
        format!("{multiplies} by “{factor}” before {adding} “{summand}”, as without brackets")
    } else {
        format!("{adds} “{summand}” before {multiplying} by “{factor}”, as with brackets")
    }
}
