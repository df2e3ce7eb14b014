//! What an exercise asks: task, place, words, an example, the number of cases.

use crate::examine::{Examiner, visible_rng};
use crate::library;

/// The description of an exercise for people.
pub fn describe(examiner: &dyn Examiner) -> String {
    let name = examiner.name();
    let cases = examiner.cases(&mut visible_rng(name)).cases;
    let mut lines = vec![name.to_owned(), format!("  {}", examiner.task())];
    lines.extend(library::place(name).map(|file| format!("  Write it in {file}.")));
    lines.extend([
        String::new(),
        "  A question is the name and these words, on one line:".to_owned(),
        format!("    {name} {}", examiner.asked().question_names().join(" ")),
    ]);
    if cases.iter().any(|case| case.question.contains("inf")) {
        lines.push("  Numbers may be `inf` or `-inf`: in C++ read a word and call `std::stod`; `std::cin >> x` does not read them.".to_owned());
    }
    let answer = examiner.asked().answer_names().join(" ");
    lines.extend(match answer.strip_prefix("none | ") {
        Some(answer) => [
            "  An answer is `= none`, or `=` and these words:".to_owned(),
            format!("    = {answer}"),
        ],
        None => [
            "  An answer is `=` and these words:".to_owned(),
            format!("    = {answer}"),
        ],
    });
    if let Some(case) = cases.first() {
        lines.extend([
            format!("  For example ({}):", case.name),
            format!("    {name} {}", case.question),
            format!("    = {}", case.answers[0]),
        ]);
    }
    lines.extend([
        String::new(),
        format!(
            "  {} cases are visible; `raybook check {name}` asks them.",
            cases.len()
        ),
        String::new(),
    ]);
    lines.join("\n")
}
