//! Decisions on a way: conditions, comparisons, choices, and several things of which one is enough.

use super::{Asks, Choice, Decision, Way};
use crate::explain::slip::{Comparison, Place, Slip};

impl Way {
    /// Whether a condition holds on which the calculation branches.
    #[track_caller]
    pub fn decides(&mut self, name: &'static str, holds: bool) -> bool {
        self.decide(name, holds, None)
    }

    /// Whether a number is less than another.
    #[track_caller]
    pub fn is_less(&mut self, name: &'static str, one: f64, other: f64) -> bool {
        self.compares(name, one, other, false)
    }

    /// Whether a number is another at most.
    #[track_caller]
    pub fn is_at_most(&mut self, name: &'static str, one: f64, other: f64) -> bool {
        self.compares(name, one, other, true)
    }

    /// Whether a number is 0.
    #[track_caller]
    pub fn is_zero(&mut self, name: &'static str, v: f64) -> bool {
        self.compares(name, v.abs(), 0.0, true)
    }

    /// Whether any of several things holds.
    #[track_caller]
    pub fn any(&mut self, name: &'static str, each: &[bool]) -> bool {
        let place = Place::here();
        let slips = self.slips.iter().flatten();
        let among = slips.filter_map(|slip| match slip {
            Slip::Among(at, of) if *at == place => Some(of(each)),
            _ => None,
        });
        let holds = each.contains(&true);
        let holds = among.fold(holds, |_, holds| holds);
        let asks = if each.len() > 1 {
            Asks::Several
        } else {
            Asks::One
        };
        self.settle(Decision::of(name, place, holds, asks), None)
    }

    /// Which of several things has the least number, the first of equal ones.
    #[track_caller]
    pub fn least(&mut self, name: &'static str, of: &[f64]) -> usize {
        let place = Place::here();
        self.count();
        let count = of.len();
        self.meets(|met| {
            if count > 1 && !met.choices.iter().any(|one| one.place == place) {
                met.choices.push(Choice { name, place, count });
            }
        });
        let slipped = self.slips.iter().flatten().find_map(|slip| match slip {
            Slip::Choice(at, pick) if *at == place && !of.is_empty() => Some(pick(of)),
            Slip::ChoiceBy { at, of: other } if *at == place => {
                Some(least(&self.last(*other, of.len())?))
            }
            _ => None,
        });
        slipped.unwrap_or_else(|| least(of))
    }

    #[track_caller]
    fn compares(&mut self, name: &'static str, one: f64, other: f64, equal_counts: bool) -> bool {
        let of = Comparison {
            one,
            other,
            equal_counts,
        };
        self.decide(name, of.holds(), Some(of))
    }

    #[track_caller]
    fn decide(&mut self, name: &'static str, holds: bool, of: Option<Comparison>) -> bool {
        let asks = if of.is_some() {
            Asks::Compared
        } else {
            Asks::One
        };
        self.settle(Decision::of(name, Place::here(), holds, asks), of)
    }

    /// What comes of a decision.
    fn settle(&mut self, decision: Decision, of: Option<Comparison>) -> bool {
        self.count();
        let (place, holds) = (decision.place, decision.held);
        self.meets(|met| decision.add_to(&mut met.decisions));
        if !self.is_slipped(place) {
            return holds;
        }
        let slips = self.slips.iter().flatten();
        slips.fold(holds, |holds, slip| slip.decided(place, holds, of))
    }
}

/// The place of the least number, the first of equal ones.
pub fn least(of: &[f64]) -> usize {
    let all = of.iter().enumerate();
    let least = all.min_by(|a, b| a.1.total_cmp(b.1));
    least.map_or(0, |(i, _)| i)
}
