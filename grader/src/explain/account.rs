//! The account of one case: everything that is known of it, before it is told.

use super::diagram::Diagram;
use super::parting::{Parting, partings};
use super::way::{Step, Way};
use super::{Shown, find};
use crate::ask::Said;
use crate::check::{Outcome, Report};
use crate::examine::Examiner;
use crate::json;
use crate::layout::meanings;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_workbook::curriculum::{CHAPTERS, Chapter};
use serde_json::{Value, json};
use std::path::Path;

/// A value by name, with what it means.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Named {
    /// Its name.
    pub name: String,
    /// Its words.
    pub words: Untrusted,
    /// Its meaning and its unit; may be empty.
    pub meaning: &'static str,
}

/// Everything that is known of one case of an exercise.
#[derive(Debug)]
pub struct Account<'a> {
    /// The exercise, all of whose cases were asked.
    pub report: &'a Report,
    /// The case.
    pub outcome: &'a Outcome,
    /// What is asked.
    pub asked: Vec<Named>,
    /// The student's answer; empty if there is none that can be read.
    pub yours: Vec<Named>,
    /// The right answer, or one of them.
    pub right: Vec<Named>,
    /// Whether many answers are right: random points, trees.
    pub many: bool,
    /// Where they part.
    pub partings: Vec<Parting>,
    /// The steps to the right answer; empty where none are known.
    pub steps: Vec<Step>,
    /// The drawing.
    pub diagram: Option<Diagram>,
    /// The chapter that derives it.
    pub chapter: Option<&'static Chapter>,
}

impl<'a> Account<'a> {
    /// The account of one outcome of a report.
    pub fn of(report: &'a Report, examiner: &dyn Examiner, outcome: &'a Outcome) -> Self {
        let asked = examiner.asked();
        let case = &outcome.case;
        let answer = case.answers.first().map_or("", String::as_str);
        let question = asked.read_question(&case.question).ok();
        let right = asked.read_answer(answer).ok();
        let said = match &outcome.reply.said {
            Said::Answer(answer) => Some(answer.unescaped()),
            _ => None,
        };
        let yours = said.and_then(|said| asked.read_answer(said).ok());
        let both = question.as_ref().zip(right.as_ref());
        let many =
            both.is_some_and(|(question, right)| !examiner.traits(question, right).is_empty());
        let partings = match (&right, &yours) {
            (Some(right), Some(yours)) => {
                partings(asked.answer.kind, asked.answer.name, right, yours)
            }
            _ => Vec::new(),
        };
        let explainer = find(asked.name);
        let steps = question.as_ref().zip(explainer);
        let steps = steps.map(|(question, explainer)| {
            let mut way = Way::default();
            (explainer.work)(0, question, &mut way);
            way.end().steps
        });
        let drawn = question.zip(right).zip(explainer);
        let diagram = drawn.and_then(|((question, right), explainer)| {
            let (question, right, yours) = (&question, &right, yours.as_deref());
            (explainer.draw)(Shown {
                question,
                right,
                yours,
            })
        });
        let holds = |chapter: &&Chapter| chapter.exercises().iter().any(|e| e.name == asked.name);
        let answered = |line: Option<&str>| {
            let parts = line
                .map(|line| examiner.answer_parts(line))
                .unwrap_or_default();
            named(parts, &[&asked.answer], asked.answer.kind)
        };
        Self {
            report,
            outcome,
            asked: named(examiner.question_parts(&case.question), &[], asked.question),
            yours: answered(said),
            right: answered(Some(answer)),
            many,
            partings,
            steps: steps.unwrap_or_default(),
            diagram,
            chapter: CHAPTERS.iter().find(holds),
        }
    }

    /// The account as data. `picture` is the file of the drawing.
    ///
    /// `case` is as in [`mod@json`]; a step is `name`, `value` (numbers) and `unit`, and one without numbers is a remark; a parting is
    /// `field`, `yours` and `right`, each `null` where it is not finite.
    pub fn json(&self, picture: Option<&Path>) -> Value {
        let named = |named: &[Named]| {
            let value = |Named {
                             name,
                             words,
                             meaning,
                         }: &Named| json!({ "name": name, "value": words.unescaped(), "meaning": meaning });
            named.iter().map(value).collect::<Vec<_>>()
        };
        let steps = self.steps.iter();
        let steps =
            steps.map(|step| json!({ "name": step.name, "value": step.value, "unit": step.unit }));
        let partings = self.partings.iter();
        let partings =
            partings.map(|p| json!({ "field": p.field, "yours": p.yours, "right": p.right }));
        json!({
            "version": json::VERSION, "exercise": self.report.exercise, "case": json::case(self.outcome),
            "asked": named(&self.asked), "yours": named(&self.yours), "right": named(&self.right),
            "partings": partings.collect::<Vec<_>>(), "steps": steps.collect::<Vec<_>>(),
            "diagnosis": self.report.diagnosis.as_ref().map(json::diagnosed),
            "picture": picture.map(|path| path.display().to_string()),
            "alt": self.diagram.as_ref().map(|diagram| &diagram.title),
            "chapter": self.chapter.map(|chapter| chapter.name),
        })
    }
}

/// Parts with the meanings of the fields of the same names: those of a kind, and more.
fn named(
    parts: Vec<(String, String)>,
    more: &[&raybook_workbook::kind::Field],
    kind: &'static raybook_workbook::kind::Kind,
) -> Vec<Named> {
    let mut fields = meanings(kind);
    fields.extend(more.iter().map(|field| (field.name, field.meaning)));
    let part = |(name, words): (String, String)| {
        let field = fields.iter().find(|(of, _)| *of == name);
        let meaning = field.map_or("", |(_, meaning)| *meaning);
        let words = words.into();
        Named {
            name,
            words,
            meaning,
        }
    };
    parts.into_iter().map(part).collect()
}
