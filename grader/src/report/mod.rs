//! A student's work on one page that needs no other file: verdicts, what explains the wrong ones, pictures, and costs.

pub mod cost;

use crate::check::{Outcome, Report, State, Verdict};
use crate::dress::Dress;
use crate::examine::Examiner;
use crate::explain::account::Account;
use crate::explain::tell;
use crate::{base64, cases, feedback, json, pictured};
use cost::Cost;
use maud::{Markup, html};
use raybook_chapters::kit::html;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_workbook::curriculum::{CHAPTERS, Chapter};

/// An exercise that was checked, with the PNG file of its pictures if it has any: a row of three for each, the student's, the right
/// one and the difference.
pub type Checked = (Report, Option<Vec<u8>>);

/// The page. `whose` is what was checked: a folder, or a program.
pub fn page(whose: &Untrusted, all: &[Checked], costs: &[Cost]) -> String {
    let reports = || all.iter().map(|(report, _)| report);
    let right = reports()
        .filter(|report| report.state() == State::Right)
        .count();
    let [cases_right, cases_asked] = cases_of(reports());
    let chapters = || {
        CHAPTERS
            .iter()
            .filter(|chapter| of(chapter, all).next().is_some())
    };
    let body = html! {
        header {
            h1 { "My rays" }
            p { code { (whose) } ": " strong { (right) " of " (all.len()) " exercises are right" } ", " (cases_right) " of " (cases_asked)
                " cases. Made by raybook " (env!("CARGO_PKG_VERSION")) "." }
            nav aria-label="Chapters" { @for chapter in chapters() {
                a href={ "#" (chapter.name) } { (chapter.number()) " " (chapter.title) " " (standing(chapter, all)) } " "
            } }
        }
        main {
            @for chapter in chapters() { section id=(chapter.name) aria-labelledby={ (chapter.name) "-title" } {
                h2 id={ (chapter.name) "-title" } { (chapter.number()) " " (chapter.title) ": " (standing(chapter, all)) " right" }
                @for (report, picture) in of(chapter, all) { (exercise(report, picture.as_deref())) }
                @for cost in costs.iter().filter(|cost| chapter.exercises().iter().any(|e| e.name == cost.exercise)) { (cost_of(cost)) }
            } }
        }
    };
    html::page(
        &format!("{right} of {} exercises are right", all.len()),
        &body,
    )
}

/// How many cases are right, and how many were asked.
fn cases_of<'a>(reports: impl Iterator<Item = &'a Report>) -> [usize; 2] {
    reports.fold([0, 0], |[right, asked], report| {
        [right + report.right(), asked + report.cases.len()]
    })
}

/// What was checked of a chapter.
fn of<'a>(chapter: &Chapter, all: &'a [Checked]) -> impl Iterator<Item = &'a Checked> {
    let names: Vec<_> = chapter.exercises().iter().map(|e| e.name).collect();
    all.iter()
        .filter(move |(report, _)| names.contains(&report.exercise))
}

/// How many exercises of a chapter are right: "2 of 3".
fn standing(chapter: &Chapter, all: &[Checked]) -> String {
    let right = of(chapter, all)
        .filter(|(report, _)| report.state() == State::Right)
        .count();
    format!("{right} of {}", of(chapter, all).count())
}

fn exercise(report: &Report, picture: Option<&[u8]>) -> Markup {
    let state = report.state();
    let (word, _) = json::state_name(&state);
    let counts = format!(
        "{} of {} cases right{}",
        report.right(),
        report.cases.len(),
        pictured::but(report)
    );
    html! { article {
        h3 { code { (report.exercise) } ": " (word) }
        @match &state {
            State::NotStarted => {}
            State::WaitsFor(name) => p { "It calls " code { (name) } ", which is not written yet." },
            State::Right | State::Wrong => p { (counts) "." },
        }
        @if let (Some((outcome, _)), Some(examiner)) = (report.first_wrong(), cases::find(report.exercise)) { (wrong(report, outcome, examiner)) }
        @if let Some(png) = picture { figure {
            img src=(base64::uri("image/png", png)) alt=(alt(report));
            figcaption { "Left yours, in the middle the right one, right the difference: orange where yours is too bright, blue where it is too dark." }
        } }
    } }
}

/// What explains the wrong answers, and the first of them in full.
fn wrong(report: &Report, outcome: &Outcome, examiner: &dyn Examiner) -> Markup {
    let account = Account::of(report, examiner, outcome);
    let Verdict::Wrong(why) = &outcome.verdict else {
        return html! {};
    };
    html! {
        p { "Case " (outcome.case.number) ", " (Untrusted::from(outcome.case.name.as_str())) ": " (why) "." }
        @for line in feedback::diagnosis(report, Dress::default()) { p { (line.trim()) } }
        details {
            summary { "This case in full" }
            pre style="overflow-x: auto" tabindex="0" { (tell::lines(&account, Dress::default()).join("\n")) }
        }
        @if let Some(diagram) = &account.diagram { figure style="max-width: 760px" {
            img src=(base64::uri("image/svg+xml", diagram.svg().as_bytes())) alt=(diagram.title);
        } }
    }
}

/// What the pictures show, and how much of it differs.
fn alt(report: &Report) -> String {
    let of_one = |picture: &crate::triple::Triple| {
        let (wrong, of) = (picture.score.wrong(), picture.score.of);
        format!("{}: {wrong} of {of} pixels are wrong.", picture.alt)
    };
    report
        .pictures
        .iter()
        .map(of_one)
        .collect::<Vec<_>>()
        .join(" ")
}

fn cost_of(cost: &Cost) -> Markup {
    let plot = cost.plot();
    html! { article {
        h3 { "What " code { (cost.exercise) } " costs" }
        p { (cost.words()) }
        figure style="max-width: 760px" { img src=(base64::uri("image/svg+xml", plot.svg().as_bytes())) alt={ (plot.title) ". " (cost.words()) }; }
    } }
}
