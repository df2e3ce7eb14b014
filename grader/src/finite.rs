//! Whether an answer is made of finite numbers: none is NaN, and infinite is only what is infinite in the right answer too.
//!
//! A judge compares; but what it adds up, takes the largest of, or divides by may swallow an infinity, or compare as false.

use crate::Verdict;
use crate::seen::Seen;
use raybook_workbook::kind::{Field, Kind, VECTOR};
use raybook_workbook::row::Numbers;
use std::fmt::Display;

/// That every number of an answer is finite, but for fields that are infinite in the right answer to the same question.
///
/// # Errors
/// Which number is NaN or infinite.
pub fn finite(field: &Field, golden: &[f64], got: &[f64]) -> Verdict {
    let seen = Seen::in_rows(field.kind, [golden]);
    all(field.kind, &field.name, &seen, &mut Numbers::of(got))
}

fn all(kind: &Kind, name: &dyn Display, seen: &Seen, numbers: &mut Numbers<'_>) -> Verdict {
    match kind {
        Kind::Number | Kind::Whole => number(name, seen, numbers.number()),
        Kind::Numbers(parts) => parts
            .parts
            .iter()
            .try_for_each(|part| number(&format_args!("{name}.{part}"), seen, numbers.number())),
        Kind::Direction => all(&Kind::Numbers(VECTOR), name, seen, numbers),
        Kind::Optional(_) if numbers.number() == 0.0 => Ok(()),
        Kind::Optional(kind) => all(kind, name, &seen.of[0], numbers),
        Kind::List(kind) => (0..numbers.number() as u32)
            .try_for_each(|i| all(kind, &format_args!("{name}[{i}]"), &seen.of[0], numbers)),
        Kind::Record(record) => {
            let mut fields = record.fields.iter().zip(&seen.of);
            fields.try_for_each(|(field, seen)| {
                let name = format_args!("{name}.{}", field.name);
                all(field.kind, &name, seen, numbers)
            })
        }
        Kind::Choice(choices) => {
            let i = numbers.number() as usize;
            match (choices.get(i), seen.of.get(i)) {
                (Some((_, kind)), Some(seen)) => all(kind, name, seen, numbers),
                _ => Ok(()),
            }
        }
    }
}

fn number(name: &dyn Display, seen: &Seen, got: f64) -> Verdict {
    let right = got.is_finite()
        || (got == f64::INFINITY && seen.infinite)
        || (got == f64::NEG_INFINITY && seen.minus_infinite);
    if right {
        Ok(())
    } else {
        Err(format!("{name} is {got}, and should be a finite number"))
    }
}
