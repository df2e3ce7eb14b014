//! A student's work on one page that needs no other file: verdicts, what explains the wrong ones, pictures, and costs.

pub mod cost;
mod map;
mod pictures;

use crate::check::{Mark, Outcome, Report, State};
use crate::dress::Dress;
use crate::examine::Examiner;
use crate::explain::account::Account;
use crate::explain::tell;
use crate::picture::words;
use crate::progress::Progress;
use crate::{cases, feedback, json};
use cost::Cost;
use maud::{Markup, html};
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_chapters::kit::{address, html};
use raybook_workbook::curriculum::{CHAPTERS, Chapter};

/// What stands on the page.
#[derive(Debug)]
pub struct Page<'a> {
    /// What was checked: a folder, or a program.
    pub whose: Untrusted,
    /// The exercises that were checked.
    pub reports: &'a [Report],
    /// What searches cost.
    pub costs: &'a [Cost],
    /// How the exercises stood when they were last checked, if that is kept.
    pub progress: Option<&'a Progress>,
    /// Why the program could not be asked the last time, in lines that can be shown.
    pub error: Option<&'a str>,
}

impl Page<'_> {
    /// The page as HTML.
    pub fn html(&self) -> String {
        let right = self
            .reports
            .iter()
            .filter(|report| is_right(report))
            .count();
        let title = match self.error {
            Some(_) => "the program could not be asked".to_owned(),
            None => format!("{right} of {} exercises are right", self.reports.len()),
        };
        let [cases_right, cases_asked] = cases_of(self.reports);
        let body = html! {
            header {
                h1 { "My rays" }
                p { code { (self.whose) } ": " strong { (right) " of " (self.reports.len()) " exercises are right" } ", " (cases_right) " of "
                    (cases_asked) " cases. Made by raybook " (env!("CARGO_PKG_VERSION")) "." }
                @if let Some(error) = self.error { (refused(error, self.reports)) }
                (map::of(self))
            }
            main {
                @for chapter in CHAPTERS.iter().filter(|chapter| self.of(chapter).next().is_some()) { (self.section(chapter)) }
            }
        };
        html::page(&title, &body)
    }

    /// What was checked of a chapter, in its order.
    fn of<'a>(&'a self, chapter: &'a Chapter) -> impl Iterator<Item = &'a Report> {
        let find = |name| self.reports.iter().find(|report| report.exercise == name);
        let exercises = chapter.exercises().iter();
        exercises.filter_map(move |exercise| find(exercise.name))
    }

    fn section(&self, chapter: &Chapter) -> Markup {
        let right = self.of(chapter).filter(|report| is_right(report)).count();
        let title = format!("{}-title", chapter.name);
        html! { section id=(chapter.name) aria-labelledby=(title) {
            h2 id=(title) { (chapter.number()) " " (chapter.title) ": " (right) " of " (self.of(chapter).count()) " right" }
            @for report in self.of(chapter) { (exercise(report)) }
            @for cost in self.costs.iter().filter(|cost| self.of(chapter).any(|report| report.exercise == cost.exercise)) { (cost_of(cost)) }
        } }
    }
}

fn is_right(report: &Report) -> bool {
    report.state() == State::Right
}

/// Why the program could not be asked.
fn refused(error: &str, before: &[Report]) -> Markup {
    html! { section role="alert" {
        h2 { "Your program could not be asked" }
        pre tabindex="0" { (error) }
        @if !before.is_empty() { p { "What is below was checked before." } }
    } }
}

/// How many cases are right, and how many were asked.
fn cases_of(reports: &[Report]) -> [usize; 2] {
    reports.iter().fold([0, 0], |[right, asked], report| {
        [right + report.right(), asked + report.cases.len()]
    })
}

fn exercise(report: &Report) -> Markup {
    let state = report.state();
    let (word, _) = json::state_name(&state);
    let counts = format!(
        "{} of {} cases right{}",
        report.right(),
        report.cases.len(),
        words::but(report)
    );
    html! { article {
        h3 { code { (report.exercise) } ": " (word) }
        @match &state {
            State::NotStarted => {}
            State::WaitsFor(name) => p { "It calls " code { (name) } ", which is not written yet." },
            State::Right | State::Wrong => p { (counts) "." },
        }
        @if let (Some((outcome, _)), Some(examiner)) = (report.shown_wrong(), cases::find(report.exercise)) { (wrong(report, outcome, examiner)) }
        @for (number, picture) in report.pictures.iter().enumerate() { (pictures::of(report.exercise, number, picture)) }
    } }
}

/// What explains the wrong answers, and the first of them in full.
fn wrong(report: &Report, outcome: &Outcome, examiner: &dyn Examiner) -> Markup {
    let account = Account::of(report, examiner, outcome);
    let Mark::Wrong(why) = &outcome.verdict else {
        return html! {};
    };
    html! {
        p { "Case " (outcome.case.number) ", " (Untrusted::from(outcome.case.name.as_str())) ": " (why) (outcome.reply.said.help()) "." }
        @for line in feedback::diagnosis(report, Dress::default()) { p { (line.trim()) } }
        details id={ (report.exercise) "-case" } {
            summary { "This case in full" }
            (in_full(&account))
        }
        (drawing(&account))
    }
}

/// A case as `raybook explain` tells it, with its drawing.
pub fn explained(account: &Account<'_>) -> Markup {
    html! { (in_full(account)) (drawing(account)) }
}

fn in_full(account: &Account<'_>) -> Markup {
    html! { pre tabindex="0" { (tell::lines(account, Dress::default()).join("\n")) } }
}

fn drawing(account: &Account<'_>) -> Markup {
    html! { @if let Some(diagram) = &account.diagram { figure style="max-width: 760px" {
        img src=(address::of_bytes("image/svg+xml", diagram.svg().as_bytes())) alt=(diagram.title);
    } } }
}

fn cost_of(cost: &Cost) -> Markup {
    let plot = cost.plot();
    html! { article {
        h3 { "What " code { (cost.exercise) } " costs" }
        p { (cost.words()) }
        figure style="max-width: 760px" { img src=(address::of_bytes("image/svg+xml", plot.svg().as_bytes())) alt={ (plot.title) ". " (cost.words()) }; }
    } }
}
