//! A student's page: points, what is wrong, drawings of wrong cases and pictures of the answers, without a word about
//! hidden cases. It needs no other file.

use super::words;
use crate::attempt::attempt;
use crate::cases;
use crate::class::grades::{ChapterGrade, ExerciseGrade, Grade, points};
use crate::class::record::Standing;
use crate::class::roll::Class;
use crate::explain::diagram::Diagram;
use crate::explain::{Shown, find};
use maud::{Markup, html};
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_chapters::kit::{address, html};

/// The largest drawing, in bytes.
const LARGEST: usize = 32 << 10;

/// The drawings and pictures of a page together, in bytes: a page is mailed and printed.
const ROOM: usize = 256 << 10;

/// The page.
pub fn page(class: &Class<'_>, grade: &Grade) -> String {
    let student = Untrusted::from(grade.sheet.student.as_str());
    let (mut room, mut all_fit) = (ROOM, true);
    let mut fits = |figure: &Figure| {
        let left = room.checked_sub(figure.source.len());
        room = left.unwrap_or(room);
        all_fit &= left.is_some();
        left.is_some()
    };
    let mut chapters = Vec::new();
    for chapter in &grade.chapters {
        let figures = chapter.exercises.iter().flat_map(figures);
        chapters.push((chapter, figures.filter(&mut fits).collect::<Vec<_>>()));
    }
    let body = html! {
        h1 { (student) ": " (points(grade.points())) " of " (points(grade.of_points())) " points" }
        p { (Untrusted::from(class.course.title.as_str())) @if !class.course.term.is_empty() { ", " (Untrusted::from(class.course.term.as_str())) }
            ". Graded " (class.when) " by raybook " (env!("CARGO_PKG_VERSION")) "."
            @if let Some(when) = grade.sheet.handed_in { " Handed in " (when) "." } }
        @if let Err(why) = &grade.sheet.print { p { strong { "The hand-in cannot be graded: " (Untrusted::from(why.as_str())) "." } } }
        @else if !grade.is_complete() { p { strong { "Something could not be graded yet; it is no zero, and is tried again." } } }
        @for note in &grade.sheet.notes { p { (Untrusted::from(note.as_str())) "." } }
        @for (chapter, figures) in &chapters { (chapter_section(chapter, figures)) }
        @if !all_fit { p { "Drawings and pictures of other exercises are left out: the page would be too large." } }
    };
    html::page(
        &format!("{student}: {} points", points(grade.points())),
        &body,
    )
}

fn chapter_section(chapter: &ChapterGrade, figures: &[Figure]) -> Markup {
    html! { section {
        h2 { (chapter.title) ": " (points(chapter.points())) " of " (points(chapter.of_points())) }
        @if chapter.weight != 1.0 { p { "Its points count " (points(chapter.weight)) " times." } }
        @if chapter.lost > 0.0 { p { "Handed in " (chapter.days_late) @if chapter.days_late == 1 { " day" } @else { " days" } " late: "
            (points(100.0 * chapter.lost)) " % of the points are lost." } }
        (html::table(&format!("The exercises of {}", chapter.title), &html! {
            tr { th { "exercise" } th { "points" } th { "of" } th { "cases right" } th style="text-align:left" { "" } }
            @for exercise in &chapter.exercises { tr {
                td { code { (exercise.counted.name) } @if exercise.counted.bonus { " (bonus)" } }
                td { (exercise.points.map_or_else(|| "–".to_owned(), points)) }
                td { (points(exercise.counted.points)) }
                td { @if let Some(result) = exercise.result.as_ref().filter(|result| result.right[1] > 0 && result.standing != Standing::NotStarted) {
                    (result.right[0]) " of " (result.right[1]) } }
                td style="text-align:left" { @for line in words(exercise).lines() { (Untrusted::from(line)) br; } }
            } }
        }))
        @if !figures.is_empty() { div class="row" { @for figure in figures { figure {
            span class="picture" { img src=(figure.source) alt=(figure.alt); }
            figcaption { code { (figure.exercise) } ": " (figure.caption) }
        } } } }
    } }
}

/// What shows a wrong exercise.
struct Figure {
    exercise: &'static str,
    /// The bytes of it, as the address of a picture.
    source: String,
    alt: String,
    caption: &'static str,
}

/// The drawing of the wrong case of an exercise that is told, and the picture of its answers, as far as there are any.
fn figures(exercise: &ExerciseGrade) -> impl Iterator<Item = Figure> {
    let name = exercise.counted.name;
    let drawing = drawing(exercise).map(|drawing| Figure {
        exercise: name,
        source: address::of_bytes("image/svg+xml", drawing.svg().as_bytes()),
        alt: drawing.title,
        caption: "the wrong case that is told, and what your function answers.",
    });
    let picture = exercise
        .result
        .as_ref()
        .and_then(|result| result.picture.as_ref());
    let picture = picture.map(|[alt, png]| Figure {
        exercise: name,
        source: format!("data:image/png;base64,{png}"),
        alt: alt.clone(),
        caption: "the picture that your answers make, the right one, and the difference: orange where yours is too bright, blue where it is too dark. Where you have no answer, it is magenta.",
    });
    drawing.into_iter().chain(picture)
}

/// The drawing of the wrong visible case of an exercise that is told, where one says more than numbers.
fn drawing(exercise: &ExerciseGrade) -> Option<Diagram> {
    let [question, answer] = exercise.result.as_ref()?.shown.as_ref()?;
    let (examiner, explainer) = (
        cases::find(exercise.counted.name)?,
        find(exercise.counted.name)?,
    );
    let question = examiner.asked().read_question(question).ok()?;
    let right = examiner.reference(&question).ok()?;
    let yours = examiner.asked().read_answer(answer).ok();
    // An answer of a stranger's may be anything: no number in it may keep a class from its grades.
    let drawing = attempt(|| {
        (explainer.draw)(Shown {
            question: &question,
            right: &right,
            yours: yours.as_deref(),
        })
    });
    drawing
        .flatten()
        .filter(|drawing| drawing.svg().len() <= LARGEST)
}
