//! A class: everybody's grade, and what is known about the class as a whole; kept between commands in the folder of results.

use super::course::Course;
use super::grades::{Grade, Known, Sheet};
use super::items::{Item, items};
use super::similar::Pair;
use super::when::Timestamp;
use crate::lock::Lock;
use raybook::store::{self, StoreError};
use raybook_chapters::kit::untrusted::Untrusted;
use serde_json::{Map, Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::io::ErrorKind;
use std::path::Path;

/// What was handed in, and the exam it was asked: the last run's. Grades follow from it, the journal and the course file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Roll {
    /// By student.
    pub sheets: Vec<Sheet>,
    /// Which hand-ins are nearly identical.
    pub pairs: Vec<Pair>,
    /// For each exercise, the fingerprint of what results depend on besides hand-ins.
    pub editions: BTreeMap<String, String>,
    /// The fingerprint of the course key.
    pub key: String,
    /// The term.
    pub term: String,
}

/// A class with its grades.
pub struct Class<'a> {
    /// The course.
    pub course: &'a Course,
    /// Everybody's grade, in the order of their names.
    pub grades: Vec<Grade>,
    /// Which hand-ins are nearly identical.
    pub pairs: &'a [Pair],
    /// The exercises in the hands of the class.
    pub items: Vec<Item>,
    /// The fingerprint of the course key.
    pub key: &'a str,
    /// When the grades were made.
    pub when: Timestamp,
}

/// The file of the roll, and that of the grades as they were last written.
const ROLL: &str = "class.json";
const GRADES: &str = "grades.json";

/// The version of both files.
pub const VERSION: u32 = 1;

/// What is wrong with a file of another version.
const OTHER: &str = "another version of raybook wrote this file";

impl<'a> Class<'a> {
    /// The class of a roll.
    pub fn of(course: &'a Course, roll: &'a Roll, known: &Known) -> Self {
        let grades: Vec<_> = roll
            .sheets
            .iter()
            .map(|sheet| Grade::of(course, sheet.clone(), known))
            .collect();
        Self {
            course,
            items: items(&grades),
            grades,
            pairs: &roll.pairs,
            key: &roll.key,
            when: Timestamp::now(),
        }
    }
}

/// The points of a student as they were last written.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Written {
    /// In all.
    pub points: f64,
    /// That could be reached.
    pub of: f64,
    /// By exercise, before late days and weights.
    pub exercises: BTreeMap<String, f64>,
    /// Days late, by chapter.
    pub days_late: BTreeMap<String, i64>,
}

/// A folder of results that nobody else uses as long as this is held.
pub struct Results<'a> {
    /// The folder.
    pub folder: &'a Path,
    _lock: Lock,
}

impl<'a> Results<'a> {
    /// Takes the folder, which is made if need be.
    ///
    /// # Errors
    /// If it cannot be made, or another command uses it.
    pub fn take(folder: &'a Path) -> Result<Self, StoreError> {
        Ok(Self {
            folder,
            _lock: Lock::on(folder)?,
        })
    }

    /// Keeps the roll.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn keep(&self, roll: &Roll) -> Result<(), StoreError> {
        let pair = |pair: &Pair| json!([pair.students[0], pair.students[1], pair.share]);
        let value = json!({
            "version": VERSION, "key": roll.key, "term": roll.term, "editions": roll.editions,
            "students": roll.sheets.iter().map(sheet_to_json).collect::<Vec<_>>(),
            "similar": roll.pairs.iter().map(pair).collect::<Vec<_>>(),
        });
        store::write(&self.folder.join(ROLL), format!("{value:#}\n").as_bytes())
    }

    /// The roll that was kept.
    ///
    /// # Errors
    /// If there is none, or it cannot be read.
    pub fn roll(&self) -> Result<Roll, String> {
        let path = self.folder.join(ROLL);
        let shown = Untrusted::from(path.as_path());
        let bytes = store::read(&path).map_err(|error| match error.reason.kind() {
            ErrorKind::NotFound => format!("{shown}: there is none; `raybook grade` makes it"),
            _ => error.to_string(),
        })?;
        let damaged = || {
            format!(
                "{shown}: this file is damaged; `raybook grade` makes it anew, and grades nothing twice"
            )
        };
        let value: Value = serde_json::from_slice(&bytes).map_err(|_| damaged())?;
        if value["version"] != VERSION {
            return Err(format!("{shown}: {OTHER}; `raybook grade` makes it anew"));
        }
        roll_of(&value).ok_or_else(damaged)
    }

    /// Refuses the folder to another course key than its results were made with: with it everything would be graded again. `keys` are those
    /// of the journal, which has results before there is a roll.
    ///
    /// # Errors
    /// If it is another.
    pub fn only_for(&self, key: &str, keys: &BTreeSet<String>) -> Result<(), String> {
        // Where there is no roll that can be read, one is made anew.
        let of_roll = self.roll().ok().map(|roll| roll.key);
        match of_roll.iter().chain(keys).find(|other| *other != key) {
            Some(other) => Err(format!(
                "{}: these results were made with another course key (its fingerprint is {}, that of this key is {key}). Grade with that key, or into another folder (--out); remove this folder to grade everything again",
                Untrusted::from(self.folder),
                Untrusted::from(other.as_str())
            )),
            None => Ok(()),
        }
    }

    /// The points as they were last written, by student; nothing if there are none.
    ///
    /// # Errors
    /// If they cannot be read.
    pub fn written(&self) -> Result<BTreeMap<String, Written>, String> {
        let path = self.folder.join(GRADES);
        let bytes = match store::read(&path) {
            Err(error) if error.reason.kind() == ErrorKind::NotFound => return Ok(BTreeMap::new()),
            read => read.map_err(|error| error.to_string())?,
        };
        let value: Option<Value> = serde_json::from_slice(&bytes).ok();
        let value = value.unwrap_or_default();
        let wrong = |what: &str| {
            let shown = Untrusted::from(path.as_path());
            format!("{shown}: {what}; move it aside, and grades are written anew")
        };
        let students = value["students"].as_object();
        let students = students.ok_or_else(|| wrong("this file is damaged"))?;
        if value["version"] != VERSION {
            return Err(wrong(OTHER));
        }
        Ok(students
            .iter()
            .map(|(student, value)| (student.clone(), written_of(value)))
            .collect())
    }

    /// Remembers the points that are written.
    ///
    /// # Errors
    /// If they cannot be.
    pub fn remember(&self, class: &Class<'_>) -> Result<(), StoreError> {
        let students: Map<String, Value> = class
            .grades
            .iter()
            .map(|grade| {
                (
                    grade.sheet.student.clone(),
                    written_to_json(&Written::of(grade)),
                )
            })
            .collect();
        let value = json!({
            "version": VERSION, "raybook": env!("CARGO_PKG_VERSION"), "course": class.course.title, "term": class.course.term,
            "key": class.key, "when": class.when.to_string(), "students": students,
        });
        store::write(&self.folder.join(GRADES), format!("{value:#}\n").as_bytes())
    }
}

impl Written {
    /// The points of a grade.
    pub fn of(grade: &Grade) -> Self {
        let points = grade
            .exercises()
            .filter_map(|exercise| Some((exercise.counted.name.to_owned(), exercise.points?)));
        let late = grade.chapters.iter().filter(|chapter| chapter.lost > 0.0);
        Self {
            points: grade.points(),
            of: grade.of_points(),
            exercises: points.collect(),
            days_late: late
                .map(|chapter| (chapter.name.to_owned(), chapter.days_late))
                .collect(),
        }
    }
}

fn written_to_json(written: &Written) -> Value {
    json!({ "points": written.points, "of": written.of, "exercises": written.exercises, "days_late": written.days_late })
}

fn written_of(value: &Value) -> Written {
    let entries = |name: &str| value[name].as_object().into_iter().flatten();
    let numbers =
        entries("exercises").filter_map(|(name, value)| Some((name.clone(), value.as_f64()?)));
    let days =
        entries("days_late").filter_map(|(name, value)| Some((name.clone(), value.as_i64()?)));
    Written {
        points: value["points"].as_f64().unwrap_or(0.0),
        of: value["of"].as_f64().unwrap_or(0.0),
        exercises: numbers.collect(),
        days_late: days.collect(),
    }
}

fn sheet_to_json(sheet: &Sheet) -> Value {
    json!({
        "student": sheet.student, "print": sheet.print.as_ref().ok(), "refused": sheet.print.as_ref().err(),
        "language": sheet.language, "taken": sheet.taken, "tries": sheet.tries, "notes": sheet.notes,
        "handed_in": sheet.handed_in.map(|when| when.to_string()),
    })
}

fn roll_of(value: &Value) -> Option<Roll> {
    let words = |value: &Value| {
        value
            .as_array()
            .into_iter()
            .flatten()
            .filter_map(|word| Some(word.as_str()?.to_owned()))
            .collect::<Vec<_>>()
    };
    let sheet = |value: &Value| {
        Some(Sheet {
            student: value["student"].as_str()?.to_owned(),
            print: match value["print"].as_str() {
                Some(print) => Ok(print.to_owned()),
                None => Err(value["refused"].as_str()?.to_owned()),
            },
            language: value["language"].as_str()?.to_owned(),
            taken: words(&value["taken"]).into_iter().collect(),
            tries: words(&value["tries"]).into_iter().collect(),
            notes: words(&value["notes"]),
            handed_in: value["handed_in"]
                .as_str()
                .and_then(|text| text.parse().ok()),
        })
    };
    let pair = |value: &Value| {
        let student = |i: usize| Some(value[i].as_str()?.to_owned());
        Some(Pair {
            students: [student(0)?, student(1)?],
            share: value[2].as_f64()?,
        })
    };
    let editions = value["editions"].as_object()?.iter();
    Some(Roll {
        sheets: value["students"]
            .as_array()?
            .iter()
            .map(sheet)
            .collect::<Option<_>>()?,
        pairs: value["similar"]
            .as_array()?
            .iter()
            .map(pair)
            .collect::<Option<_>>()?,
        editions: editions
            .map(|(name, value)| Some((name.clone(), value.as_str()?.to_owned())))
            .collect::<Option<_>>()?,
        key: value["key"].as_str()?.to_owned(),
        term: value["term"].as_str()?.to_owned(),
    })
}
