//! The golden answers as files that people read: `golden/<chapter>/<exercise>.txt`.

use crate::examine::{Cases, Examiner, visible_rng};
use raybook_workbook::curriculum::CHAPTERS;
use std::fmt::Write;

/// An exercise's file below `golden/`, its text, and the cases in it.
pub fn page(examiner: &dyn Examiner) -> (String, String, Cases) {
    let name = examiner.name();
    let chapter = CHAPTERS.iter().find(|chapter| {
        chapter
            .exercises()
            .iter()
            .any(|exercise| exercise.name() == name)
    });
    let cases = examiner.cases(&mut visible_rng(name));
    let widest = cases
        .cases
        .iter()
        .map(|case| case.name.chars().count())
        .max()
        .unwrap_or(0);
    let mut text = format!("# {name}: {}\n", examiner.task());
    let _ = writeln!(text, "# asked:    {}", examiner.question_names().join(" "));
    let _ = writeln!(text, "# answered: {}", examiner.answer_names().join(" "));
    let _ = writeln!(
        text,
        "# Each line: the case's name | the question = the answer (= another that is right too). Written by `raybook bless`."
    );
    for case in &cases.cases {
        let _ = writeln!(
            text,
            "{:widest$} | {} = {}",
            case.name,
            case.question,
            case.answers.join(" = ")
        );
    }
    (
        format!("{}/{name}.txt", chapter.map_or("", |chapter| chapter.name)),
        text,
        cases,
    )
}
