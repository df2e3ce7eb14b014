//! One of the exercise's own mistakes, made in one number of the answer only: in a channel, or along an axis.

use super::evidence::{Evidence, Scope};
use super::fit::Explanation;
use raybook_workbook::kind::Kind;

/// An own mistake in one number.
pub struct InOne {
    mistake: usize,
    number: usize,
    name: String,
    hint: &'static str,
}

/// Every own mistake in every single number of an answer that is a few numbers.
pub fn all(evidence: &Evidence<'_>) -> Vec<InOne> {
    let examiner = evidence.examiner;
    let names: &[&str] = match examiner.asked().answer.kind {
        Kind::Numbers(numbers) => numbers.parts,
        Kind::Direction => &["x", "y", "z"],
        _ => return Vec::new(),
    };
    if evidence.scope != Scope::Whole {
        return Vec::new();
    }
    let mut all = Vec::new();
    for (mistake, (name, hint)) in examiner.mistakes().into_iter().enumerate() {
        for (number, only) in names.iter().enumerate() {
            let name = format!("{name}, in {only} only");
            all.push(InOne {
                mistake,
                number,
                name,
                hint,
            });
        }
    }
    all
}

impl InOne {
    /// What it answers to question k.
    pub fn answer(&self, evidence: &Evidence<'_>, k: usize) -> Option<Vec<f64>> {
        let item = &evidence.items[k];
        let mistaken = evidence.mistaken(self.mistake, k)?;
        let mut answer = item.golden().to_vec();
        *answer.get_mut(self.number)? = *mistaken.get(self.number)?;
        Some(answer)
    }

    /// What is told of it; its answers are asked for one by one.
    pub fn explanation(&self) -> Explanation {
        Explanation {
            name: self.name.clone(),
            hint: self.hint.to_owned(),
            rank: 15,
            fitted: 0,
            answers: Vec::new(),
        }
    }
}
