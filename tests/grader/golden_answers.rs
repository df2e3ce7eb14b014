//! The golden answers that are kept are those of today.

use raybook_grader::golden;
use std::fs;

/// Questions by their text, answers by the judge: another machine's `powf` may round otherwise.
#[test]
fn the_golden_answers_are_those_of_today() {
    for examiner in raybook_grader::cases::all() {
        let path = golden::path(examiner.name());
        let (text, set) = golden::page(examiner).expect("the named cases can be read");
        let kept =
            fs::read_to_string(raybook_common::project("golden").join(&path)).unwrap_or_default();
        let stale = format!(
            "golden/{path} is stale; `cargo run --release -- bless` writes it: read the difference"
        );
        assert_eq!(kept.lines().count(), text.lines().count(), "{stale}");
        let questions = |text: &str| {
            text.lines()
                .map(|line| line.split(" = ").next().map(str::to_owned))
                .collect::<Vec<_>>()
        };
        assert!(questions(&kept) == questions(&text), "{stale}");
        let answered = kept.lines().filter(|line| !line.starts_with('#'));
        for (line, case) in answered.zip(set.cases) {
            let golden: Vec<_> = line.split(" = ").skip(1).map(str::to_owned).collect();
            assert_eq!(
                examiner.judge(&case.question, &golden, &case.answers[0]),
                Ok(()),
                "{stale}: {line}"
            );
        }
    }
}
