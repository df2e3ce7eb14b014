//! The branch of the calculation that all wrong answers have in common, and no right one: what is left to say where no mistake gives
//! the same answers, and where there are none because the program stops with an error.

use super::Diagnosis;
use crate::attempt::attempt;
use crate::examine::{Case, Examiner};
use crate::explain::find;
use crate::explain::slip::Place;
use crate::explain::way::{Decision, Way};

/// A branch is told if this many answers are right: with all wrong, nothing sets it apart.
const RIGHT: usize = 3;

/// What leads on.
const HINT: &str = "Go through the first of these questions by hand, line by line. Is there a line for this case at all?";

/// A question on its way: the decisions, and whether its answer is right.
struct Walk {
    decisions: Vec<Decision>,
    right: bool,
}

impl Walk {
    /// Whether a decision went this way, and never the other.
    fn takes(&self, place: Place, holds: bool) -> bool {
        let mut all = self.decisions.iter();
        let one = all.find(|one| one.place == place);
        one.is_some_and(|one| {
            if holds {
                one.held
            } else {
                one.failed && !one.held
            }
        })
    }
}

/// The last decision that the questions with a wrong answer have in common, and no others.
pub fn search(
    examiner: &dyn Examiner,
    cases: &[Case],
    answers: &[(Option<String>, bool)],
) -> Option<Diagnosis> {
    let asked = examiner.asked();
    let explainer = find(asked.name)?;
    let walk = |case: &Case, right: bool| {
        let question = asked.read_question(&case.question).ok()?;
        attempt(|| {
            let mut way = Way::default();
            (explainer.work)(0, &question, &mut way);
            let decisions = way.end().decisions;
            Walk { decisions, right }
        })
    };
    let each = cases.iter().zip(answers);
    let walks: Option<Vec<_>> = each.map(|(case, (_, right))| walk(case, *right)).collect();
    let (right, wrong): (Vec<_>, Vec<_>) = walks?.into_iter().partition(|walk| walk.right);
    if right.len() < RIGHT || wrong.is_empty() {
        return None;
    }
    let outcomes = wrong[0].decisions.iter().rev();
    let mut outcomes = outcomes.flat_map(|one| [(one, true), (one, false)]);
    let (decision, holds) = outcomes.find(|(one, holds)| {
        let takes = |walk: &Walk| walk.takes(one.place, *holds);
        wrong.iter().all(takes) && !right.iter().any(takes)
    })?;
    let silent = answers.iter().all(|(text, right)| *right || text.is_none());
    let name = match (silent, holds) {
        (true, true) => format!("gives no answer when {}, and only then", decision.name),
        (true, false) => format!("answers only when {}", decision.name),
        (false, true) => format!("is wrong when {}, and only then", decision.name),
        (false, false) => format!("is right only when {}", decision.name),
    };
    Some(Diagnosis {
        name,
        hint: HINT.to_owned(),
        part: None,
        // No answer is there to see; what makes an answer wrong is not.
        certain: silent && wrong.len() > 1,
        explained: wrong.len(),
        wrong: wrong.len(),
        also: Vec::new(),
    })
}
