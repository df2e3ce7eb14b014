//! Points: from what is known about each exercise of a hand-in to a grade, by the rules of the course.

use super::course::{Counted, Course, Late, Plan};
use super::hand_in::HandIn;
use super::record::{Marked, Standing};
use super::when::Timestamp;
use std::collections::{BTreeMap, BTreeSet};

/// What is known of the exercises of hand-ins: by the hand-in's fingerprint and the exercise.
pub type Known = BTreeMap<(String, String), Marked>;

/// What a student handed in, as far as grades need it.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// The student.
    pub student: String,
    /// The fingerprint of the hand-in; or why it is refused.
    pub print: Result<String, String>,
    /// Its language.
    pub language: String,
    /// The references in it.
    pub taken: BTreeSet<String>,
    /// What its text reaches for that no exercise needs.
    pub tries: BTreeSet<String>,
    /// What was left out of it.
    pub notes: Vec<String>,
    /// When it was handed in, if that is known.
    pub handed_in: Option<Timestamp>,
}

/// A student's grade.
#[derive(Clone, Debug, PartialEq)]
pub struct Grade {
    /// What was handed in.
    pub sheet: Sheet,
    /// By chapter.
    pub chapters: Vec<ChapterGrade>,
}

/// A student's grade in a chapter.
#[derive(Clone, Debug, PartialEq)]
pub struct ChapterGrade {
    /// The chapter's name.
    pub name: &'static str,
    /// The chapter's title.
    pub title: &'static str,
    /// The share that is lost because it came late.
    pub lost: f64,
    /// Days late, begun ones too.
    pub days_late: i64,
    /// What its points are multiplied by.
    pub weight: f64,
    /// Its exercises.
    pub exercises: Vec<ExerciseGrade>,
}

/// A student's grade in an exercise.
#[derive(Clone, Debug, PartialEq)]
pub struct ExerciseGrade {
    /// What it counts.
    pub counted: Counted,
    /// Whether its reference was taken.
    pub taken: bool,
    /// Points, before the chapter's loss and weight; `None` if it is not graded.
    pub points: Option<f64>,
    /// What is known; nothing of a hand-in that is refused, or of an exercise that was never asked.
    pub result: Option<Marked>,
}

impl Sheet {
    /// The sheet of a hand-in.
    pub fn of(hand_in: &HandIn, handed_in: Option<Timestamp>) -> Self {
        let content = hand_in.content.as_ref();
        let owned = |names: &BTreeSet<&str>| names.iter().map(|&name| name.to_owned()).collect();
        Self {
            student: hand_in.student.clone(),
            print: content
                .map(|content| content.print.clone())
                .map_err(Clone::clone),
            language: content
                .map_or("", |content| content.language.name())
                .to_owned(),
            taken: content.map_or_else(|_| BTreeSet::new(), |content| owned(&content.taken)),
            tries: content.map_or_else(|_| BTreeSet::new(), |content| owned(&content.tries)),
            notes: hand_in.notes.clone(),
            handed_in,
        }
    }
}

impl Grade {
    /// The grade of a hand-in.
    pub fn of(course: &Course, sheet: Sheet, known: &Known) -> Self {
        let chapters = course
            .chapters
            .iter()
            .map(|plan| chapter(course, plan, &sheet, known))
            .collect();
        Self { sheet, chapters }
    }

    /// Points in all; what is not graded counts nothing yet.
    pub fn points(&self) -> f64 {
        self.chapters.iter().map(ChapterGrade::points).sum()
    }

    /// Points that can be reached without a bonus.
    pub fn of_points(&self) -> f64 {
        self.chapters.iter().map(ChapterGrade::of_points).sum()
    }

    /// Whether everything is graded.
    pub fn is_complete(&self) -> bool {
        self.exercises().all(|exercise| exercise.points.is_some())
    }

    /// All exercises.
    pub fn exercises(&self) -> impl Iterator<Item = &ExerciseGrade> {
        self.chapters.iter().flat_map(|chapter| &chapter.exercises)
    }
}

impl ChapterGrade {
    /// Points, after what is lost because it came late.
    pub fn points(&self) -> f64 {
        let points = self.exercises.iter().filter_map(|exercise| exercise.points);
        self.weight * (1.0 - self.lost) * points.sum::<f64>()
    }

    /// Points that can be reached without a bonus.
    pub fn of_points(&self) -> f64 {
        let ordinary = self
            .exercises
            .iter()
            .filter(|exercise| !exercise.counted.bonus);
        self.weight
            * ordinary
                .map(|exercise| exercise.counted.points)
                .sum::<f64>()
    }
}

fn chapter(course: &Course, plan: &Plan, sheet: &Sheet, known: &Known) -> ChapterGrade {
    let days_late = plan
        .due
        .zip(sheet.handed_in)
        .map_or(0, |(due, came)| days_late(due, came, &course.late));
    let exercises = plan.exercises.iter().map(|counted| {
        let result = sheet
            .print
            .as_ref()
            .ok()
            .and_then(|print| known.get(&(print.clone(), counted.name.to_owned())));
        let taken = sheet.taken.contains(counted.name);
        let share = match result {
            _ if sheet.print.is_err() => Some(0.0),
            None => None,
            Some(result) => share(course, result),
        };
        let kept = if taken { 1.0 - course.solve.costs } else { 1.0 };
        ExerciseGrade {
            counted: counted.clone(),
            taken,
            points: share.map(|share| counted.points * share * kept),
            result: result.cloned(),
        }
    });
    ChapterGrade {
        name: plan.chapter.name,
        title: plan.chapter.title,
        lost: (course.late.per_day * days_late as f64).min(course.late.at_most),
        days_late,
        weight: plan.weight,
        exercises: exercises.collect(),
    }
}

/// Days late, begun ones too; none within the time that costs nothing.
fn days_late(due: Timestamp, came: Timestamp, late: &Late) -> i64 {
    const DAY: i64 = 86400;
    let seconds = came.seconds - due.seconds;
    if seconds <= late.grace {
        return 0;
    }
    seconds.div_euclid(DAY) + i64::from(seconds.rem_euclid(DAY) > 0)
}

/// The share of an exercise's points; `None` if nothing is known. A program that is right on the visible cases only may have their
/// answers by heart: it is paid for hidden ones alone.
fn share(course: &Course, result: &Marked) -> Option<f64> {
    let known = if result.right_on_visible_only() {
        result.visible
    } else {
        [0, 0]
    };
    let paid = |i: usize| result.right[i].saturating_sub(known[i]) as f64;
    let [right, asked] = [paid(0), paid(1)];
    match result.standing {
        Standing::Right => Some(1.0),
        Standing::Wrong if asked > 0.0 => Some(course.partial * right / asked),
        Standing::Wrong | Standing::NotStarted | Standing::NotBuilt => Some(0.0),
        Standing::NotGraded => None,
    }
}

/// Points as people write them: with at most two digits after the point.
pub fn points(points: f64) -> String {
    let text = format!("{points:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}
