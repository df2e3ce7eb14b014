//! A number that fits: a factor, an offset, a power, a bound, digits.

use super::{Maker, common, line};
use crate::diagnose::number::{is_known, named, short};
use crate::layout::each;

impl Maker<'_, '_> {
    /// A constant factor.
    pub(super) fn factor(&mut self) {
        let ratios: Vec<_> = self
            .pairs
            .iter()
            .filter_map(|pair| {
                let most =
                    |a: &usize, b: &usize| pair.base[*a].abs().total_cmp(&pair.base[*b].abs());
                let largest = (0..pair.base.len()).max_by(most)?;
                let ratio = pair.got[largest] / pair.base[largest];
                (pair.base[largest] != 0.0 && ratio.is_finite()).then_some(ratio)
            })
            .collect();
        let Some(factor) = common(&ratios).filter(|c| (c - 1.0).abs() > 1e-4 && c.abs() > 1e-12)
        else {
            return;
        };
        let name = format!("returns {} times {}", named(factor), self.of);
        let rank = if is_known(factor) { 9 } else { 17 };
        let hint = "Write down the formula with units: which constant factor is missing, is there twice, or stands on the wrong side of the fraction line?";
        let make = move |_: usize, v: &mut [f64]| each(v, |v| *v *= factor);
        self.try_one(rank, 1, name, hint, &make);
    }

    /// A constant that is added.
    pub(super) fn offset(&mut self) {
        let len = self.pairs[0].base.len();
        let offsets: Vec<_> = (0..len)
            .map(|k| {
                let off: Vec<_> = self
                    .pairs
                    .iter()
                    .map(|pair| pair.got[k] - pair.base[k])
                    .collect();
                let zeros = off.iter().filter(|v| v.abs() < 1e-6).count();
                if 5 * zeros >= 4 * off.len() {
                    Some(0.0)
                } else {
                    common(&off)
                }
            })
            .collect();
        let Some(offsets) = offsets.into_iter().collect::<Option<Vec<_>>>() else {
            return;
        };
        if offsets.iter().all(|v| v.abs() < 1e-7) {
            return;
        }
        let hint = if self.is_whole() {
            "Do you count from 0 or from 1, and is the last one counted?"
        } else {
            "Put in a simple case, zeros and ones, and calculate by hand: which term is too much, or missing?"
        };
        let sign = |v: f64| {
            if v < 0.0 {
                format!("{} too little", named(-v))
            } else {
                format!("{} too much", named(v))
            }
        };
        let name = if offsets
            .iter()
            .all(|v| (v - offsets[0]).abs() < 1e-3 * v.abs())
        {
            match (self.is_whole(), offsets[0]) {
                (true, 1.0) => format!("counts {} from 1 instead of 0: one too much", self.of),
                (true, -1.0) => format!("counts {} one too little", self.of),
                _ => format!("returns {} for {}", sign(offsets[0]), self.of),
            }
        } else {
            let axes = self.axes().iter().zip(&offsets).filter(|(_, v)| **v != 0.0);
            let each: Vec<_> = axes
                .map(|(axis, v)| format!("{axis} {}", sign(*v)))
                .collect();
            format!("returns {} with {}", self.of, each.join(", "))
        };
        let make = move |_: usize, v: &mut [f64]| {
            v.iter_mut().zip(&offsets).for_each(|(v, off)| *v += off);
        };
        self.try_one(16, 1, name, hint, &make);
    }

    /// A power, with a factor.
    pub(super) fn power(&mut self) {
        if self.is_vector() || self.is_whole() {
            return;
        }
        let mut points = Vec::new();
        for pair in &self.pairs {
            for (b, g) in pair.base.iter().zip(&pair.got) {
                if *b > 1e-9 && *g > 1e-9 && b.is_finite() && g.is_finite() {
                    points.push((b.ln(), g.ln()));
                }
            }
        }
        let Some((slope, shift)) = line(&points) else {
            return;
        };
        if (slope - 1.0).abs() < 5e-3 || slope.abs() < 5e-2 {
            return;
        }
        let factor = if shift.abs() < 5e-3 { 1.0 } else { shift.exp() };
        let times = if factor == 1.0 {
            String::new()
        } else {
            format!(", times {}", named(factor))
        };
        let name = format!("raises {} to the power of {}{times}", self.of, short(slope));
        let make = move |_: usize, v: &mut [f64]| {
            each(v, |v| *v = factor * v.max(0.0).powf(slope));
        };
        self.try_one(
            18,
            2,
            name,
            "To which power does each quantity stand in the formula? Check it by its units.",
            &make,
        );
    }

    /// a times the answer plus b.
    pub(super) fn affine(&mut self) {
        if self.is_vector() {
            return;
        }
        let mut points = Vec::new();
        for pair in &self.pairs {
            let both = pair.base.iter().copied().zip(pair.got.iter().copied());
            points.extend(both.filter(|(b, g)| b.is_finite() && g.is_finite()));
        }
        let Some((slope, shift)) = line(&points) else {
            return;
        };
        if (slope - 1.0).abs() < 1e-3 || shift.abs() < 1e-3 || slope.abs() < 1e-3 {
            return;
        }
        let sign = if shift < 0.0 { "minus" } else { "plus" };
        let name = format!(
            "returns {} times {} {sign} {}",
            named(slope),
            self.of,
            named(shift.abs())
        );
        let make = move |_: usize, v: &mut [f64]| each(v, |v| *v = slope * *v + shift);
        self.try_one(
            19,
            2,
            name,
            "In which range should the answer be, and in which is yours?",
            &make,
        );
    }

    /// The same number wherever the right one is beyond it.
    pub(super) fn cut(&mut self) {
        let got: Vec<_> = self
            .pairs
            .iter()
            .flat_map(|pair| pair.base.iter().zip(&pair.got))
            .collect();
        let changed = |(b, g): &&(&f64, &f64)| (*b - *g).abs() > 1e-5 + 1e-3 * b.abs();
        let at: Vec<f64> = got.iter().filter(changed).map(|(_, g)| **g).collect();
        let Some(limit) = at.first().copied().filter(|v| v.is_finite()) else {
            return;
        };
        if at
            .iter()
            .any(|v| (v - limit).abs() > 1e-6 * limit.abs().max(1e-6))
        {
            return;
        }
        let bases: Vec<f64> = got.iter().filter(changed).map(|(b, _)| **b).collect();
        let name =
            |verb: &str| format!("never returns {verb} than {} for {}", short(limit), self.of);
        if bases.iter().all(|b| *b > limit) {
            let make = move |_: usize, v: &mut [f64]| each(v, |v| *v = v.min(limit));
            self.try_one(
                14,
                1,
                name("more"),
                "Is there an upper limit to what is asked for?",
                &make,
            );
        } else if bases.iter().all(|b| *b < limit) {
            let make = move |_: usize, v: &mut [f64]| each(v, |v| *v = v.max(limit));
            self.try_one(
                14,
                1,
                name("less"),
                "Is there a lower limit to what is asked for?",
                &make,
            );
        }
        let name = format!(
            "returns {} for {}, whatever is asked",
            short(limit),
            self.of
        );
        let make = move |_: usize, v: &mut [f64]| v.fill(limit);
        self.try_one(
            13,
            1,
            name,
            "Does your function return what it calculates?",
            &make,
        );
    }

    /// Too few printed digits.
    pub(super) fn digits(&mut self) {
        if self.is_whole() {
            return;
        }
        // A program that prints more digits in any answer, even a right one, does not print too few.
        let items = self.evidence.items.iter();
        let words = || items.clone().flat_map(|item| item.text.split_whitespace());
        let behind = |word: &str| word.split_once('.').map_or(0, |(_, digits)| digits.len());
        let decimals = words().map(behind).max().unwrap_or(0).min(6);
        let unit = 10_f64.powi(decimals as i32);
        let hint = "How many digits does your program print? Seven that count are enough for any answer here.";
        let make = move |_: usize, v: &mut [f64]| {
            each(v, |v| *v = (*v * unit).round() / unit);
        };
        self.try_one(
            8,
            0,
            format!("prints too few digits: only {decimals} behind the decimal point"),
            hint,
            &make,
        );
        let make = move |_: usize, v: &mut [f64]| {
            each(v, |v| *v = (*v * unit).trunc() / unit);
        };
        self.try_one(
            9,
            0,
            format!("cuts off all digits but {decimals} behind the decimal point"),
            hint,
            &make,
        );
        let most = words().map(counting).max().unwrap_or(0);
        for digits in most.max(1)..4 {
            let make = move |_: usize, v: &mut [f64]| {
                for v in v {
                    let text = format!("{:.*e}", digits - 1, *v);
                    *v = text.parse().unwrap_or(*v);
                }
            };
            self.try_one(
                9,
                0,
                format!("prints too few digits: only {digits} that count"),
                hint,
                &make,
            );
        }
    }
}

/// The number of digits of a printed number that count: those from the first that is not 0 on, without the exponent.
fn counting(word: &str) -> usize {
    let number = word.split(['e', 'E']).next().unwrap_or_default();
    let digits = number.chars().filter(char::is_ascii_digit);
    digits.skip_while(|digit| *digit == '0').count()
}
