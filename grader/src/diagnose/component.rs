//! One of the exercise's own mistakes, made in one number of the answer only: in a channel, or along an axis.

use super::evidence::{Evidence, Scope};
use super::fit::Explanation;
use raybook_workbook::kind::Kind;

/// Every own mistake in every single number of an answer that is a few numbers.
pub fn explanations(evidence: &Evidence<'_>) -> Vec<Explanation> {
    let examiner = evidence.examiner;
    let names: &[&str] = match examiner.asked().answer.kind {
        Kind::Numbers(numbers) => numbers.parts,
        Kind::Direction => &["x", "y", "z"],
        _ => return Vec::new(),
    };
    if evidence.scope != Scope::Whole {
        return Vec::new();
    }
    let in_one = |mistake: usize, number: usize| {
        let answers = evidence.items.iter().map(|item| {
            let mistaken = examiner.mistake_answers(mistake, &item.question)?;
            let mut answer = item.golden().to_vec();
            *answer.get_mut(number)? = *mistaken.get(number)?;
            Some(answer)
        });
        answers.collect()
    };
    let mut all = Vec::new();
    for (i, (name, hint)) in examiner.mistakes().into_iter().enumerate() {
        for (number, only) in names.iter().enumerate() {
            all.push(Explanation {
                name: format!("{name}, in {only} only"),
                hint: hint.to_owned(),
                rank: 15,
                fitted: 0,
                answers: in_one(i, number),
            });
        }
    }
    all
}
