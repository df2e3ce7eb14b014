//! A distance that does not count, moved to the end of the interval instead of ruled out.

use super::{explanation, made};
use crate::diagnose::evidence::{Evidence, Scope};
use crate::diagnose::fit::{Answers, Explanation};
use crate::diagnose::search::called;
use crate::layout::{layout, parts};
use raybook_workbook::kind::Kind;

/// Of an exercise that asks for a distance in an interval, or for none.
pub fn explanations(evidence: &Evidence<'_>, base: &Answers) -> Option<Explanation> {
    let asked = evidence.examiner.asked();
    let is_interval =
        |kind: &Kind| matches!(kind, Kind::Numbers(numbers) if numbers.name == "Interval");
    let mut all = parts(asked.question, "question").into_iter();
    let within = all.position(|part| part.list.is_none() && is_interval(part.kind))?;
    let distance = evidence.parts.iter().position(|part| part.name == "t")?;
    if !matches!(asked.answer.kind, Kind::Optional(_)) || evidence.scope != Scope::Whole {
        return None;
    }
    let clamped = |i: usize, _: &[f64]| {
        let mut question = evidence.items[i].question.clone();
        let ends = layout(asked.question, &question)
            .of_part(within)
            .next()?
            .range();
        let [min, max] = question[ends.clone()].try_into().ok()?;
        question[ends].copy_from_slice(&[f64::NEG_INFINITY, f64::INFINITY]);
        let mut answer = called(asked, &question)?;
        let fields = layout(asked.answer.kind, &answer);
        for t in fields.of_part(distance) {
            answer[t.start] = answer[t.start].max(min).min(max);
        }
        Some(answer)
    };
    Some(explanation(
        11,
        "moves a distance outside of the interval to its end, where there is no answer",
        "A hit that lies before min or behind max: is it nearer than it is, or does it not count?",
        made(base, clamped),
    ))
}
