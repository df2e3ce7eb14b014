//! `{{example sphere_hit}}`: what goes in and what comes out of one named case, as a table.

use crate::examine::{Case, Examiner, visible_rng};
use crate::layout::meanings;
use maud::html;

/// The table of the named case `name`, or of the first case where no name is given.
///
/// # Errors
/// If there is no such case.
pub(super) fn expand(examiner: &dyn Examiner, name: &str) -> Result<String, String> {
    let cases = examiner.cases(&mut visible_rng(examiner.name())).cases;
    let case = find(&cases, name).ok_or_else(|| {
        format!(
            "{} has no case `{name}`; see its file in golden/",
            examiner.name()
        )
    })?;
    let answer = &examiner.asked().answer;
    let [of_question, of_answer] = [examiner.asked().question, answer.kind].map(meanings);
    let meaning = |meanings: &[(_, &'static str)], name: &str, other| {
        let found = meanings.iter().find(|(field, _)| *field == name);
        found.map_or(other, |(_, meaning)| *meaning)
    };
    let asked = examiner.question_parts(&case.question);
    let answered = examiner.answer_parts(&case.answers[0]);
    let table = html! {
        table class="example" {
            caption { "The case “" (case.name) "” of " code { (examiner.name()) } }
            thead { tr { th { "in" } th { "value" } th { "meaning" } } }
            tbody { @for (name, value) in &asked { tr { td { code { (name) } } td { (short(value)) } td { (meaning(&of_question, name, "")) } } } }
            thead { tr { th { "out" } th { "value" } th { "meaning" } } }
            tbody { @for (i, (name, value)) in answered.iter().enumerate() { tr {
                td { code { (name) } } td { b { (short(value)) } } td { (meaning(&of_answer, name, if i == 0 { answer.meaning } else { "" })) }
            } } }
        }
    };
    Ok(table.into_string())
}

fn find<'a>(cases: &'a [Case], name: &str) -> Option<&'a Case> {
    match name {
        "" => cases.first(),
        name => cases.iter().find(|case| case.name == name),
    }
}

/// The first words of a value that is too long for a table.
pub(super) fn short(value: &str) -> String {
    const LONGEST: usize = 60;
    if value.chars().count() <= LONGEST {
        return value.to_owned();
    }
    let mut start: String = value.chars().take(LONGEST).collect();
    start.truncate(start.trim_end().rfind(' ').unwrap_or(start.len()));
    format!("{} …", start.trim_end())
}
