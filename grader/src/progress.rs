//! What a student has finished, kept in the folder between checks.

use crate::check::Report;
use crate::json;
use raybook::image::file;
use serde_json::{Map, Value, json};
use std::path::{Path, PathBuf};
use std::{fs, io};

/// For each exercise that was checked, how it stood then.
#[derive(Clone, Debug, Default)]
pub struct Progress {
    /// By exercise: its state ("right", "wrong", "not started" or "waits"), how many cases were right, and how many were asked.
    exercises: Map<String, Value>,
}

impl Progress {
    /// The progress kept in a student's folder; empty if there is none, or if it cannot be read (it is only a memory).
    pub fn load(folder: &Path) -> Self {
        let text = fs::read_to_string(path(folder)).unwrap_or_default();
        let mut kept: Value = serde_json::from_str(&text).unwrap_or_default();
        let exercises = match kept.get_mut("exercises").map(Value::take) {
            Some(Value::Object(exercises)) => exercises,
            _ => Map::new(),
        };
        Self { exercises }
    }

    /// Whether an exercise was right when it was last checked.
    pub fn is_right(&self, exercise: &str) -> bool {
        self.exercises
            .get(exercise)
            .is_some_and(|standing| standing["state"] == "right")
    }

    /// Adds these reports to the progress kept in a student's folder.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn remember<'a>(
        folder: &Path,
        reports: impl Iterator<Item = &'a Report>,
    ) -> io::Result<()> {
        let mut progress = Self::load(folder);
        progress
            .exercises
            .extend(reports.map(|report| (report.exercise.to_owned(), standing(report))));
        progress.save(folder)
    }

    /// Keeps the progress in a student's folder.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn save(&self, folder: &Path) -> io::Result<()> {
        let text = format!("{:#}", json!({ "exercises": self.exercises }));
        file::write_whole(&path(folder), format!("{text}\n").as_bytes())
    }
}

/// How an exercise stands.
fn standing(report: &Report) -> Value {
    let (state, _) = json::state_name(&report.state());
    json!({ "state": state, "right": report.right(), "asked": report.cases.len() })
}

fn path(folder: &Path) -> PathBuf {
    folder.join(".raybook").join("progress.json")
}
