//! Results for programs: JSON of a stated version.
//!
//! ```json
//! { "version": 1, "right": 1, "of": 2, "exercises": [ {
//!     "exercise": "ray_at", "state": "right" | "wrong" | "not started" | "waits", "waits_for": null | "name",
//!     "right": 40, "asked": 40, "picture": null | "file",
//!     "pictures": [ { "name": "…", "alt": "…", "right": 3450, "of": 3452, "undecided": 4, "error": 0.01, "passed": true } ],
//!     "diagnosis": null | { "name": "…", "hint": "…", "explained": 37, "wrong": 40, "further": 16,
//!         "certain": true, "part": null | "…", "also": [ …as this, and "beside": "apart" | "together" | "instead" | "shown" ] },
//!     "smallest": null | { …a case, the wrong one that is told, with a simpler question… },
//!     "cases": [ { "number": 1, "name": "…", "verdict": "right" | "wrong" | "not started", "why": null | "…",
//!         "question": "…", "answers": ["…"], "got": null | "…", "printed": "…", "stderr": "…" } ] } ] }
//! ```
//!
//! The state is right if all cases are right and all pictures are passed. `pictures` is empty where none is wanted and the pixels that
//! are asked all the same are right. `further` counts the further wrong answers that a mistake in doubt explains, which were asked for to
//! be sure.
//!
//! Fields may be added within a version; none is removed or changes its meaning.

use crate::ask::Said;
use crate::check::{Mark, Outcome, Report, State};
use crate::diagnose::{Beside, Diagnosis};
use crate::picture::triple::Triple;
use raybook_chapters::kit::untrusted::is_hidden;
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::PathBuf;

/// The version of the format.
pub const VERSION: u32 = 1;

/// The reports, each with the file of its pictures.
pub fn results(reports: &[(Report, Option<PathBuf>)]) -> Value {
    let right = reports
        .iter()
        .filter(|(report, _)| report.state() == State::Right)
        .count();
    let exercises: Vec<_> = reports
        .iter()
        .map(|(report, picture)| exercise(report, picture.as_ref()))
        .collect();
    json!({ "version": VERSION, "right": right, "of": reports.len(), "exercises": exercises })
}

/// The text of a value. What a terminal would not show as a character is written as its number, which JSON alone asks only of
/// the first 32.
pub fn text(value: &Value) -> String {
    let text = format!("{value:#}");
    let mut visible = String::with_capacity(text.len());
    for c in text.chars() {
        if c != '\n' && is_hidden(c) {
            for unit in c.encode_utf16(&mut [0; 2]) {
                let _ = write!(visible, "\\u{unit:04x}");
            }
        } else {
            visible.push(c);
        }
    }
    visible
}

/// The state in one word or two, and what it waits for.
pub fn state_name(state: &State) -> (&'static str, Option<&str>) {
    match state {
        State::Right => ("right", None),
        State::Wrong => ("wrong", None),
        State::NotStarted => ("not started", None),
        State::WaitsFor(name) => ("waits", Some(name)),
    }
}

/// The state of a name, and of what it waits for; none if the name means none.
pub fn state(name: &str, waits_for: &str) -> Option<State> {
    let waits = State::WaitsFor(waits_for.to_owned());
    let mut all = [State::Right, State::Wrong, State::NotStarted, waits].into_iter();
    all.find(|state| state_name(state).0 == name)
}

fn exercise(report: &Report, picture: Option<&PathBuf>) -> Value {
    let state = report.state();
    let (state, waits_for) = state_name(&state);
    let cases: Vec<_> = report.cases.iter().map(case).collect();
    let diagnosis = report.diagnosis.as_ref().map(diagnosed);
    json!({
        "exercise": report.exercise, "state": state, "waits_for": waits_for,
        "right": report.right(), "asked": report.cases.len(),
        "picture": picture.map(|path| path.display().to_string()),
        "pictures": report.pictures.iter().map(score).collect::<Vec<_>>(),
        "diagnosis": diagnosis, "smallest": report.smallest.as_ref().map(case), "cases": cases,
    })
}

/// A diagnosis beside another one.
fn also(d: &Diagnosis) -> Value {
    let mut also = diagnosed(d);
    also["beside"] = match d.beside {
        Beside::Apart => "apart",
        Beside::Together => "together",
        Beside::Instead => "instead",
        Beside::Shown => "shown",
    }
    .into();
    also
}

/// A diagnosis.
pub fn diagnosed(d: &Diagnosis) -> Value {
    json!({
        "name": d.name, "hint": d.hint, "explained": d.explained, "wrong": d.wrong, "further": d.further, "certain": d.certain, "part": d.part,
        "also": d.also.iter().map(also).collect::<Vec<_>>(),
    })
}

fn score(picture: &Triple) -> Value {
    let score = &picture.score;
    json!({
        "name": picture.name, "alt": picture.alt, "right": score.right, "of": score.of,
        "undecided": score.undecided, "error": score.error, "passed": score.passed(),
    })
}

/// A case.
pub fn case(outcome: &Outcome) -> Value {
    let (verdict, why) = match &outcome.verdict {
        Mark::Right => ("right", None),
        Mark::NotStarted => ("not started", None),
        Mark::Wrong(why) => ("wrong", Some(why)),
    };
    let got = match &outcome.reply.said {
        Said::Answer(answer) => Some(answer.unescaped()),
        _ => None,
    };
    json!({
        "number": outcome.case.number, "name": outcome.case.name, "verdict": verdict, "why": why,
        "question": outcome.case.question, "answers": outcome.case.answers, "got": got,
        "printed": outcome.reply.printed.stdout.unescaped(), "stderr": outcome.reply.printed.stderr.unescaped(),
    })
}
