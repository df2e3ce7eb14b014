//! Which mistake a student made.

use crate::examine::{Case, Examiner};

/// A mistake that explains wrong answers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnosis {
    /// What the mistake does.
    pub name: &'static str,
    /// A sentence that leads on.
    pub hint: &'static str,
    /// How many of the wrong answers are the mistake's.
    pub explained: usize,
    /// How many answers are wrong.
    pub wrong: usize,
}

/// The mistake whose answers these are.
///
/// `answers` holds, for each case, what the student answered (`None` for no answer) and whether it was right.
/// A mistake is the one if it explains at least four in five of the wrong answers; of several, the one that agrees with
/// most of all answers, so that it explains the right ones too.
pub fn diagnose(
    examiner: &dyn Examiner,
    cases: &[Case],
    answers: &[(Option<String>, bool)],
) -> Option<Diagnosis> {
    let wrong = answers.iter().filter(|(_, right)| !right).count();
    let candidate = |(i, (name, hint)): (usize, (&'static str, &'static str))| {
        let agrees = |case: &Case, answer: &Option<String>| {
            let mistaken = examiner.mistaken(i, &case.question);
            mistaken.is_some_and(|mistaken| {
                answer
                    .as_ref()
                    .is_some_and(|got| alike(&mistaken, got, examiner.alike()))
            })
        };
        let agreed: Vec<_> = cases
            .iter()
            .zip(answers)
            .map(|(case, (answer, right))| (agrees(case, answer), *right))
            .collect();
        let explained = agreed
            .iter()
            .filter(|&&(agrees, right)| agrees && !right)
            .count();
        let all = agreed.iter().filter(|(agrees, _)| *agrees).count();
        (5 * explained >= 4 * wrong && explained > 0).then_some((
            all,
            Diagnosis {
                name,
                hint,
                explained,
                wrong,
            },
        ))
    };
    let candidates = examiner
        .mistakes()
        .into_iter()
        .enumerate()
        .filter_map(candidate);
    let mut best: Option<(usize, Diagnosis)> = None;
    for (all, diagnosis) in candidates {
        if best.as_ref().is_none_or(|(most, _)| all > *most) {
            best = Some((all, diagnosis));
        }
    }
    best.map(|(_, diagnosis)| diagnosis)
}

/// Two rows with the same words, up to the rounding of numbers: a wrong answer has no judge.
fn alike(one: &str, other: &str, relative: f32) -> bool {
    let (one, other): (Vec<_>, Vec<_>) = (
        one.split_whitespace().collect(),
        other.split_whitespace().collect(),
    );
    let close = |(a, b): (&&str, &&str)| match (a.parse::<f32>(), b.parse::<f32>()) {
        (Ok(a), Ok(b)) if a.is_finite() && b.is_finite() => {
            (a - b).abs() <= 1e-5 + relative * a.abs().max(b.abs())
        }
        (Ok(a), Ok(b)) => a == b || (a.is_nan() && b.is_nan()),
        _ => a == b,
    };
    one.len() == other.len() && one.iter().zip(&other).all(close)
}
