//! What a student has finished, kept in the folder between checks.

use crate::check::Report;
use crate::json;
use raybook::image::file;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::{fs, io};

/// For each exercise that was checked, how it stood then.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Progress {
    /// By exercise.
    pub exercises: BTreeMap<String, Standing>,
}

/// How an exercise stood when it was last checked.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Standing {
    /// "right", "wrong", "not started" or "waits".
    pub state: String,
    /// Cases that were right.
    pub right: usize,
    /// Cases that were asked.
    pub asked: usize,
}

impl Progress {
    /// The progress kept in a student's folder; empty if there is none, or if it cannot be read (it is only a memory).
    pub fn load(folder: &Path) -> Self {
        let text = fs::read_to_string(path(folder)).unwrap_or_default();
        serde_json::from_str(&text).unwrap_or_default()
    }

    /// Whether an exercise was right when it was last checked.
    pub fn is_right(&self, exercise: &str) -> bool {
        self.exercises
            .get(exercise)
            .is_some_and(|standing| standing.state == "right")
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
            .extend(reports.map(|report| (report.exercise.to_owned(), Standing::of(report))));
        progress.save(folder)
    }

    /// Keeps the progress in a student's folder.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn save(&self, folder: &Path) -> io::Result<()> {
        let text = serde_json::to_string_pretty(self).map_err(io::Error::other)?;
        file::write_whole(&path(folder), format!("{text}\n").as_bytes())
    }
}

impl Standing {
    fn of(report: &Report) -> Self {
        let state = json::state_name(&report.state()).0.to_owned();
        Self {
            state,
            right: report.right(),
            asked: report.cases.len(),
        }
    }
}

fn path(folder: &Path) -> PathBuf {
    folder.join(".raybook").join("progress.json")
}
