//! The steps of a calculation, one after the other, as somebody writes them down who does it by hand.

mod decide;
mod step;
mod walked;

use super::slip::{Place, Slip, end_if_endless};
pub use decide::least;
use glam::{DVec2, DVec3};
use std::borrow::Cow;
use std::ops::Range;
use step::Colour;
pub use step::{Axes, Step, Value, words};
pub use walked::{Asks, Choice, Decision, Limit, Met, Spot, Walked};

/// The steps up to now. Each method writes a value down and gives it back, so that what is told is what is calculated with.
#[derive(Debug, Default)]
pub struct Way {
    steps: Vec<Step>,
    untold: Vec<Step>,
    met: Met,
    slips: [Option<Slip>; 2],
    /// Where these are made: most steps are elsewhere, and are many millions.
    slipped_at: [Option<Place>; 2],
    /// Whether no slip looks back at the steps, which then are not written down.
    is_blind: bool,
    /// The steps of the right way, for a slip that takes the value of one that comes later.
    ahead: Vec<Step>,
    looks_ahead: bool,
    /// The values that a step had in the rounds up to now, for a slip that takes one of them.
    before: Vec<Vec<f64>>,
    is_watched: bool,
    calculated: usize,
    /// The number of steps with which it ends, come to its end or not.
    most: Option<usize>,
}

impl Way {
    /// A way on which a slip is made.
    pub fn with(slip: Slip) -> Self {
        Self::of_slips([Some(slip), None])
    }

    /// A way on which a slip is made that takes the value of a step which comes later: that of the right way.
    pub fn with_ahead(slip: Slip, right: Walked) -> Self {
        Self {
            ahead: right.steps.into_iter().chain(right.untold).collect(),
            ..Self::with(slip)
        }
    }

    /// The same way, given up after this number of steps and decisions.
    #[must_use]
    pub fn no_longer_than(self, most: usize) -> Self {
        let most = Some(most);
        Self { most, ..self }
    }

    /// Whether a slip wanted the value of a step to which the way had not come, and the way is short: one of many rounds is not gone twice.
    pub fn looks_ahead(&self) -> bool {
        /// Steps and decisions of a short way.
        const SHORT: usize = 200;
        self.looks_ahead && self.calculated <= SHORT
    }

    /// A way on which two slips are made.
    pub fn with_both(slips: [Slip; 2]) -> Self {
        Self::of_slips(slips.map(Some))
    }

    fn of_slips(slips: [Option<Slip>; 2]) -> Self {
        let mut made = slips.iter().flatten();
        Self {
            slips,
            slipped_at: slips.map(|slip| Some(slip?.place())),
            is_blind: !made.any(Slip::looks_back),
            ..Self::default()
        }
    }

    /// A way on which a slip is made, with all its steps.
    pub fn watched(slip: Slip) -> Self {
        Self {
            is_watched: true,
            is_blind: false,
            ..Self::with(slip)
        }
    }

    /// A number.
    #[track_caller]
    pub fn number(
        &mut self,
        name: impl Into<Cow<'static, str>>,
        unit: &'static str,
        v: f64,
    ) -> f64 {
        self.add(name, unit, v, true)
    }

    /// A vector.
    #[track_caller]
    pub fn vector(
        &mut self,
        name: impl Into<Cow<'static, str>>,
        unit: &'static str,
        v: DVec3,
    ) -> DVec3 {
        self.add(name, unit, v, true)
    }

    /// A colour: light, or a share of light, in red, green and blue.
    #[track_caller]
    pub fn colour(&mut self, name: &'static str, unit: &'static str, v: DVec3) -> DVec3 {
        self.add(name, unit, Colour(v), true).0
    }

    /// A colour that is not worth a line of its own.
    #[track_caller]
    pub fn colour_part(&mut self, name: &'static str, v: DVec3) -> DVec3 {
        self.add(name, "", Colour(v), false).0
    }

    /// Two numbers that belong together.
    #[track_caller]
    pub fn pair(
        &mut self,
        name: impl Into<Cow<'static, str>>,
        unit: &'static str,
        v: DVec2,
    ) -> DVec2 {
        self.add(name, unit, v, true)
    }

    /// What goes into the next step without being worth a line of its own: a number that is given, a factor, a part of a formula.
    #[track_caller]
    pub fn part<V: Value>(&mut self, name: &'static str, v: V) -> V {
        self.add(name, "", v, false)
    }

    /// A sentence, where the calculation branches.
    #[track_caller]
    pub fn remark(&mut self, sentence: impl Into<Cow<'static, str>>) {
        self.count();
        if !self.is_blind {
            self.steps.push(Step {
                name: sentence.into(),
                value: Vec::new(),
                unit: "",
                axes: &[],
                place: Place::here(),
                is_told: true,
            });
        }
    }

    /// What an operation, "to take the absolute value", makes of a value.
    #[track_caller]
    pub fn made<V>(&mut self, name: &'static str, from: V, made: V) -> V {
        let place = Place::here();
        self.count();
        self.meets(|met| Spot { name, place }.add_to(&mut met.operations));
        let forgets = |slip: &Slip| matches!(slip, Slip::Forgotten(at) if *at == place);
        if self.slips.iter().flatten().any(forgets) {
            from
        } else {
            made
        }
    }

    /// A power: not a step by itself, but what is written into one.
    #[track_caller]
    pub fn power(&mut self, name: &'static str, base: f64, exponent: f64) -> f64 {
        let place = Place::here();
        self.count();
        self.meets(|met| Spot { name, place }.add_to(&mut met.powers));
        let slip = self.slips.iter().flatten().find_map(|slip| match slip {
            Slip::Power(at, of) if *at == place => Some(of(base, exponent)),
            Slip::Factor { at, of, inside } if *at == place => {
                let factor = *self.last(*of, 1)?.first()?;
                Some(if *inside {
                    (base * factor).powf(exponent) / factor
                } else {
                    (base / factor).powf(exponent) * factor
                })
            }
            _ => None,
        });
        slip.unwrap_or_else(|| base.powf(exponent))
    }

    /// The rounds of a loop through this number of things, "the axes": 0, 1, 2 and so on.
    #[track_caller]
    pub fn rounds(&mut self, name: &'static str, count: usize) -> Range<usize> {
        let place = Place::here();
        self.count();
        self.meets(|met| Spot { name, place }.add_to(&mut met.loops));
        let slips = self.slips.iter().flatten();
        slips.fold(0..count, |rounds, slip| match slip {
            Slip::Rounds(at, of) if *at == place => of(rounds),
            _ => rounds,
        })
    }

    /// Several things, "the children", in the order in which they are gone through.
    #[track_caller]
    pub fn in_order<T>(&mut self, name: &'static str, things: Vec<T>) -> Vec<T> {
        let place = Place::here();
        self.count();
        if things.len() > 1 {
            self.meets(|met| Spot { name, place }.add_to(&mut met.orders));
        }
        let slip = self.slips.iter().flatten().find_map(|slip| match slip {
            Slip::Ordered(at, of) if *at == place => Some(of),
            _ => None,
        });
        let Some(of) = slip else { return things };
        let order = of(things.len());
        let mut things: Vec<_> = things.into_iter().map(Some).collect();
        let taken = order.into_iter().filter_map(|i| things.get_mut(i)?.take());
        taken.collect()
    }

    /// A whole number that is no part of the question, but written into the program: "the most children of a branch".
    #[track_caller]
    pub fn limit(&mut self, name: &'static str, number: usize) -> usize {
        let place = Place::here();
        self.count();
        self.meets(|met| {
            if !met.limits.iter().any(|one| one.place == place) {
                met.limits.push(Limit {
                    name,
                    place,
                    number,
                });
            }
        });
        let slip = self.slips.iter().flatten().find_map(|slip| match slip {
            Slip::Limit(at, other) if *at == place => Some(*other),
            _ => None,
        });
        slip.unwrap_or(number)
    }

    /// Calculates what is not told.
    pub fn silently<R>(&mut self, calculate: impl FnOnce(&mut Self) -> R) -> R {
        let told = self.steps.len();
        let result = calculate(self);
        for step in self.steps.drain(told..) {
            // Who makes a slip knows the places already.
            let is_new = self.slips[0].is_none() || self.is_watched;
            if is_new && !self.untold.iter().any(|one| one.place == step.place) {
                self.untold.push(step);
            }
        }
        result
    }

    /// Calculates for each of many alike, and tells the steps of the first only.
    pub fn of_first<T, R>(
        &mut self,
        all: impl IntoIterator<Item = T>,
        mut calculate: impl FnMut(&mut Self, T) -> R,
    ) -> Vec<R> {
        let mut is_first = true;
        let each = |one| {
            if std::mem::take(&mut is_first) {
                calculate(self, one)
            } else {
                self.silently(|way| calculate(way, one))
            }
        };
        all.into_iter().map(each).collect()
    }

    /// A round of a loop in which nothing is written down, of as many as a step before it says: a slip there may make them endless.
    pub fn goes_on(&mut self) {
        self.count();
    }

    /// Notes what it comes by. Who makes a slip knows that already.
    fn meets(&mut self, note: impl FnOnce(&mut Met)) {
        if self.slips[0].is_none() {
            note(&mut self.met);
        }
    }

    fn count(&mut self) {
        self.calculated += 1;
        if self.slips[0].is_some() {
            end_if_endless(self.calculated, self.most);
        }
    }

    /// Whether a slip is made at a place.
    fn is_slipped(&self, place: Place) -> bool {
        let [one, other] = self.slipped_at;
        matches!(one, Some(at) if at == place) || matches!(other, Some(at) if at == place)
    }

    /// The number of steps and decisions up to now.
    pub fn length(&self) -> usize {
        self.calculated
    }

    /// What the way leaves behind.
    pub fn end(mut self) -> Walked {
        let untold = self.steps.extract_if(.., |step| !step.is_told);
        self.untold.extend(untold);
        Walked {
            steps: self.steps,
            untold: self.untold,
            met: self.met,
            length: self.calculated,
        }
    }

    /// The last value of a step, as `size` numbers: its own if it has as many, or its only number for each.
    fn last(&self, of: Place, size: usize) -> Option<Vec<f64>> {
        let mut past = self.steps.iter().rev();
        let last = past.find(|step| step.place == of);
        let last = last.or_else(|| self.ahead.iter().find(|step| step.place == of))?;
        match last.value.as_slice() {
            [one] => Some(vec![*one; size]),
            value => (value.len() == size).then(|| value.to_vec()),
        }
    }

    /// What a slip makes of the value of the step at a place.
    fn slipped<V: Value>(&mut self, v: V, place: Place, slip: Slip) -> V {
        match slip {
            Slip::Value(at, change) if at == place => {
                let mut value = v.numbers();
                change.make(&mut value);
                v.with(&value)
            }
            Slip::Other { at, of, only } if at == place => {
                self.mixed(v, of, only, |_, other| other)
            }
            Slip::Earlier(at, from) if at == place => {
                let round = self.before.len();
                self.before.push(v.numbers());
                v.with(&self.before[from(round)])
            }
            Slip::Bracket(at, bracket) if at == place => {
                let value = v.numbers();
                let size = value.len();
                let operands = [bracket.summand, bracket.factor].map(|of| self.last(of, size));
                let [Some(summand), Some(factor)] = operands else {
                    return v;
                };
                let each = value.iter().zip(summand.iter().zip(&factor));
                let each = each.map(|(v, (summand, factor))| bracket.of(*v, *summand, *factor));
                v.with(&each.collect::<Vec<_>>())
            }
            Slip::Fitted(at, fitted) if at == place => {
                let value: Vec<_> = v.numbers().iter().map(|v| fitted.of(*v)).collect();
                v.with(&value)
            }
            Slip::Mix { at, of, how, only } if at == place => {
                self.mixed(v, of, only, |v, other| how.of(v, other))
            }
            _ => v,
        }
    }

    /// A value, all of whose numbers, or one only, are mixed with those of another step.
    fn mixed<V: Value>(
        &mut self,
        v: V,
        of: Place,
        only: Option<usize>,
        mix: impl Fn(f64, f64) -> f64,
    ) -> V {
        let mut value = v.numbers();
        let others = self.last(of, value.len());
        self.looks_ahead |= others.is_none();
        let others = others.into_iter().flatten();
        for (i, (v, other)) in value.iter_mut().zip(others).enumerate() {
            if only.is_none_or(|only| only == i) {
                *v = mix(*v, other);
            }
        }
        v.with(&value)
    }

    #[track_caller]
    fn add<V: Value>(
        &mut self,
        name: impl Into<Cow<'static, str>>,
        unit: &'static str,
        mut v: V,
        is_told: bool,
    ) -> V {
        self.count();
        let place = Place::here();
        if self.is_slipped(place) {
            for slip in self.slips.into_iter().flatten() {
                v = self.slipped(v, place, slip);
            }
        }
        if !self.is_blind {
            self.steps.push(Step {
                name: name.into(),
                value: v.numbers(),
                unit,
                axes: V::AXES,
                place,
                is_told,
            });
        }
        v
    }
}
