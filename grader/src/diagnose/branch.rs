//! The branch of the calculation that all wrong answers have in common, and no right one: what is left to say where no mistake gives
//! the same answers, and where there are none because the program stops with an error.

use super::{Beside, Diagnosis, number::short};
use crate::attempt::attempt;
use crate::examine::{Case, Examiner};
use crate::explain::find;
use crate::explain::slip::Place;
use crate::explain::way::{Decision, Way};

/// A branch is told if this many answers are right: with all wrong, nothing sets it apart. If no answers are there to see, or the same
/// one again and again, that is told with it; else as many answers must be right as are wrong, for a branch that nearly all questions
/// take tells nothing.
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

/// The last decision that the questions with a wrong answer have in common, and no others; some of those take it the other way.
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
            let decisions = way.end().met.decisions;
            Walk { decisions, right }
        })
    };
    let each = cases.iter().zip(answers);
    let walks: Option<Vec<_>> = each.map(|(case, (_, right))| walk(case, *right)).collect();
    let (right, wrong): (Vec<_>, Vec<_>) = walks?.into_iter().partition(|walk| walk.right);
    let texts = answers.iter().filter(|(_, right)| !right);
    let texts: Vec<_> = texts.map(|(text, _)| text.as_deref()).collect();
    let silent = texts.iter().all(Option::is_none);
    let same = always(&texts).filter(|_| !is_right_elsewhere(cases, answers));
    let is_seen = silent || same.is_some();
    let least = if is_seen {
        RIGHT
    } else {
        RIGHT.max(wrong.len())
    };
    if right.len() < least || wrong.is_empty() {
        return None;
    }
    let outcomes = wrong[0].decisions.iter().rev();
    let mut outcomes = outcomes.flat_map(|one| [(one, true), (one, false)]);
    let (decision, holds) = outcomes.find(|(one, holds)| {
        let takes = |walk: &Walk| walk.takes(one.place, *holds);
        // Who comes to a decision and goes the other way tells more than who never comes to it.
        let differs = |walk: &Walk| walk.takes(one.place, !holds);
        wrong.iter().all(takes) && !right.iter().any(takes) && right.iter().any(differs)
    })?;
    let when = &decision.name;
    let name = match (silent, &same, holds) {
        (true, _, true) => format!("comes to no answer when {when}, and only then"),
        (true, _, false) => format!("comes to an answer only when {when}"),
        (_, Some(same), true) => format!("returns {same} when {when}, whatever else is asked"),
        (_, Some(same), false) => format!("returns {same} unless {when}"),
        (_, None, true) => format!("is wrong when {when}, and only then"),
        (_, None, false) => format!("is right only when {when}"),
    };
    Some(Diagnosis {
        name,
        hint: HINT.to_owned(),
        part: None,
        // No answer is there to see, or the same answer; what makes an answer wrong is not.
        certain: is_seen && wrong.len() > 1,
        explained: wrong.len(),
        wrong: wrong.len(),
        further: 0,
        shown: None,
        beside: Beside::Apart,
        also: Vec::new(),
    })
}

/// Whether one answer is due to all of the wrong cases, and what is answered there is right elsewhere: of yes and no, a wrong one is
/// always the other, which tells nothing.
fn is_right_elsewhere(cases: &[Case], answers: &[(Option<String>, bool)]) -> bool {
    let each = || cases.iter().zip(answers);
    let wrong: Vec<_> = each().filter(|(_, (_, right))| !right).collect();
    let mut others = each().filter(|(_, (_, right))| *right);
    let Some((case, (got, _))) = wrong.first() else {
        return false;
    };
    let is_one = wrong.iter().all(|(one, _)| one.answers == case.answers);
    is_one && others.any(|(_, (text, _))| text == got)
}

/// A short answer that all of them are.
fn always(answers: &[Option<&str>]) -> Option<String> {
    /// More words are not read at a glance.
    const WORDS: usize = 6;
    let words = |text: &str| -> Vec<String> {
        let word = |word: &str| word.parse().map_or_else(|_| word.to_owned(), short);
        text.split_whitespace().map(word).collect()
    };
    let first = words((*answers.first()?)?);
    let mut all = answers.iter();
    let same = all.all(|text| text.is_some_and(|text| words(text) == first));
    (same && first.len() <= WORDS).then(|| first.join(" "))
}
