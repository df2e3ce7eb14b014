//! The exam of a class: the same hidden cases for everybody, and what its results depend on besides the hand-ins.

use super::course::Course;
use super::record::Record;
use crate::examine::{Case, CasesError, Examiner};
use crate::fingerprint::{self, hex};
use crate::hidden::Key;
use hmac::{Hmac, KeyInit, Mac};
use rayon::prelude::*;
use sha2::Sha256;
use std::collections::BTreeMap;

/// The student of the hidden cases of a class: all are asked the same. `raybook check --student class` asks them too.
pub const CLASS: &str = "class";

/// What is asked of everybody.
pub struct Exam {
    /// The exercises, in the order of the course, with their cases.
    pub(super) asked: Vec<(&'static dyn Examiner, Vec<Case>)>,
    /// For each, the fingerprint of what its result depends on besides the hand-in.
    pub(super) editions: BTreeMap<&'static str, String>,
    /// The fingerprint of the key.
    pub key: String,
}

impl Exam {
    /// The exam of a course: its exercises with their hidden cases.
    ///
    /// # Errors
    /// If the reference of an exercise has no answer.
    pub fn new(
        course: &Course,
        examiners: &[&'static dyn Examiner],
        key: &str,
    ) -> Result<Self, CasesError> {
        let of_class = Key {
            course: key.to_owned(),
            term: course.term.clone(),
            student: CLASS.to_owned(),
        };
        let asked = examiners.par_iter().map(|examiner| {
            let cases = examiner.try_cases(&mut of_class.rng(examiner.name()))?;
            Ok((*examiner, cases.cases))
        });
        let key = fingerprint(key);
        let edition = |examiner: &&'static dyn Examiner| {
            let limits = format!("{:?}", course.limits.asking());
            let memory = course.limits.memory.to_string();
            let parts = [
                env!("CARGO_PKG_VERSION"),
                &key,
                &course.term,
                &limits,
                &memory,
                examiner.golden(),
            ];
            let edition = fingerprint::of(parts.map(str::as_bytes), 16);
            (examiner.name(), edition)
        };
        Ok(Self {
            asked: asked.collect::<Result<_, CasesError>>()?,
            editions: examiners.iter().map(edition).collect(),
            key,
        })
    }

    /// Whether a record is of this exam.
    pub fn holds(&self, record: &Record) -> bool {
        self.editions.get(record.exercise.as_str()) == Some(&record.edition)
    }

    /// For each exercise, the fingerprint of what its result depends on besides the hand-in.
    pub fn editions(&self) -> BTreeMap<String, String> {
        let editions = self.editions.iter();
        editions
            .map(|(name, edition)| ((*name).to_owned(), edition.clone()))
            .collect()
    }

    /// The fingerprint of what an exercise's result depends on besides the hand-in.
    pub fn edition(&self, exercise: &str) -> Option<&str> {
        self.editions.get(exercise).map(String::as_str)
    }
}

/// The first digits of a fingerprint of the key, from which nobody finds a key that is random.
pub fn fingerprint(key: &str) -> String {
    // HMAC takes a key of any length.
    let Ok(mut mac) = Hmac::<Sha256>::new_from_slice(key.as_bytes()) else {
        unreachable!("any length is right")
    };
    mac.update(b"fingerprint");
    hex(&mac.finalize().into_bytes())[..16].to_owned()
}
