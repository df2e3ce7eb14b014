//! Comparing answers where the program does not: number by number, within a tolerance.

use crate::Verdict;
use crate::judge;
use glam::Vec3;
use raybook_workbook::kind::Kind;
use raybook_workbook::row::Numbers;

/// Compares the next value of an answer with that of the right one.
///
/// # Errors
/// How they differ.
pub(super) fn compare(
    kind: &Kind,
    name: &str,
    tolerance: f32,
    golden: &mut Numbers<'_>,
    got: &mut Numbers<'_>,
) -> Verdict {
    match kind {
        Kind::Number => {
            let [golden, got] = [golden.number() as f32, got.number() as f32];
            let within = tolerance * golden.abs().max(1.0);
            judge::number_within(name, "", golden, got, within)
        }
        Kind::Whole => {
            let [golden, got] = [golden.number(), got.number()];
            if golden == got {
                Ok(())
            } else {
                Err(format!("{name} is {got}, and should be {golden}"))
            }
        }
        Kind::Numbers(parts) => parts.parts.iter().try_for_each(|part| {
            let name = format!("{name}.{part}");
            compare(&Kind::Number, &name, tolerance, golden, got)
        }),
        Kind::Direction => {
            let [golden, got] = [vector(golden), vector(got)];
            judge::direction(name, golden, got)
        }
        Kind::Optional(kind) => match [golden.number(), got.number()].map(|there| there != 0.0) {
            [false, false] => Ok(()),
            [true, true] => compare(kind, name, tolerance, golden, got),
            [true, false] => Err(format!("{name} is none, and there is one")),
            [false, true] => Err(format!("there is no {name}: the answer is none")),
        },
        Kind::List(kind) => {
            let [count, got_count] = [golden.number(), got.number()];
            if count != got_count {
                return Err(format!(
                    "{name} has {got_count} values, and should have {count}"
                ));
            }
            (1..=count as u32).try_for_each(|i| {
                let name = format!("{name} number {i}");
                compare(kind, &name, tolerance, golden, got)
            })
        }
        // No declaration has such an answer.
        Kind::Record(_) | Kind::Choice(_) => Ok(()),
    }
}

fn vector(numbers: &mut Numbers<'_>) -> Vec3 {
    Vec3::from_array([(); 3].map(|()| numbers.number() as f32))
}
