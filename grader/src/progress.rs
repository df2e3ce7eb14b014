//! What a student has finished, kept in the folder between checks.

use crate::check::{Report, State};
use crate::json;
use crate::lock::Lock;
use raybook::store::{self, StoreError};
use raybook_workbook::curriculum::{CHAPTERS, Chapter};
use serde_json::{Map, Value, json};
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// For each exercise that was checked, how it stood then.
#[derive(Clone, Debug, Default)]
pub struct Progress {
    /// By exercise: its state ("right", "wrong", "not started" or "waits"), what it waits for, how many cases were right, and how many were
    /// asked.
    exercises: Map<String, Value>,
}

/// Why the progress is not known.
#[derive(Debug, thiserror::Error)]
pub enum ProgressError {
    /// Its file cannot be read.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// Its file holds something else.
    #[error("{}: this file is damaged, {reason}; the next `raybook check` keeps it aside and begins a new one", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
}

impl Progress {
    /// The progress kept in a student's folder; empty if nothing has been checked there.
    ///
    /// # Errors
    /// If the file cannot be read, or is damaged.
    pub fn load(folder: &Path) -> Result<Self, ProgressError> {
        let path = path(folder);
        let bytes = match store::read(&path) {
            Err(error) if error.reason.kind() == ErrorKind::NotFound => return Ok(Self::default()),
            read => read?,
        };
        let exercises = match serde_json::from_slice(&bytes) {
            Ok(Value::Object(mut kept)) => kept.remove("exercises"),
            Ok(_) => None,
            Err(error) => {
                let reason = error.to_string();
                return Err(ProgressError::Damaged { path, reason });
            }
        };
        match exercises {
            Some(Value::Object(exercises)) => Ok(Self { exercises }),
            _ => Err(ProgressError::Damaged {
                path,
                reason: "there are no `exercises` in it".to_owned(),
            }),
        }
    }

    /// How an exercise stood when it was last checked; none if it never was.
    pub fn state(&self, exercise: &str) -> Option<State> {
        let standing = self.exercises.get(exercise)?;
        let waits_for = standing["waits_for"].as_str().unwrap_or_default();
        json::state(standing["state"].as_str()?, waits_for)
    }

    /// Whether an exercise was right when it was last checked.
    pub fn is_right(&self, exercise: &str) -> bool {
        self.state(exercise) == Some(State::Right)
    }

    /// The first exercise of the course that was not right when it was last checked, or never was.
    pub fn first_open(&self) -> Option<&'static str> {
        let mut all = CHAPTERS.iter().flat_map(Chapter::exercises);
        let open = all.find(|exercise| !self.is_right(exercise.name));
        open.map(|exercise| exercise.name)
    }

    /// Adds these reports to the progress kept in a student's folder, whatever other checks do there at the same time. A damaged
    /// file is kept aside, and its new name is returned.
    ///
    /// # Errors
    /// If the file cannot be read, kept aside or written.
    pub fn remember<'a>(
        folder: &Path,
        reports: impl Iterator<Item = &'a Report>,
    ) -> Result<Option<PathBuf>, StoreError> {
        let path = path(folder);
        let _lock = Lock::on(&folder.join(KEPT))?;
        let (mut progress, aside) = match Self::load(folder) {
            Ok(progress) => (progress, None),
            Err(ProgressError::Store(error)) => return Err(error),
            Err(ProgressError::Damaged { .. }) => {
                let aside = unused(&path.with_extension("json.damaged"));
                fs::rename(&path, &aside).map_err(StoreError::of(&path, "keep this file aside"))?;
                (Self::default(), Some(aside))
            }
        };
        let standings = reports.map(|report| (report.exercise.to_owned(), standing(report)));
        progress.exercises.extend(standings);
        let text = format!("{:#}\n", json!({ "exercises": progress.exercises }));
        store::write(&path, text.as_bytes())?;
        Ok(aside)
    }
}

/// How an exercise stands.
fn standing(report: &Report) -> Value {
    let state = report.state();
    let (state, waits_for) = json::state_name(&state);
    json!({ "state": state, "waits_for": waits_for, "right": report.right(), "asked": report.cases.len() })
}

/// The folder in a workbook for what is not the student's.
pub const KEPT: &str = ".raybook";

fn path(folder: &Path) -> PathBuf {
    folder.join(KEPT).join("progress.json")
}

/// The path, or with `.2`, `.3`, … after it the first at which there is nothing yet.
pub fn unused(path: &Path) -> PathBuf {
    let mut free = path.to_owned();
    let mut number = 1;
    while free.symlink_metadata().is_ok() {
        number += 1;
        let mut name = path.as_os_str().to_owned();
        name.push(format!(".{number}"));
        free = PathBuf::from(name);
    }
    free
}
