//! The journal of a run: what is known about each exercise of each hand-in, in an order that does not matter.
//!
//! A record is a line: a checksum and a JSON text. It begins with a line end of its own, so that what was cut short before it, by a
//! full disk or a grader that was killed, spoils nothing but itself: its checksum is wrong, and what it would have told is graded
//! again. Nothing is ever taken out or changed, so journals are merged by concatenation: `cat a/run.jsonl b/run.jsonl`.
//!
//! When [`Journal::add`] returns, the record is on the disk.

use crate::fingerprint::hex;
use raybook::store::StoreError;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use std::collections::BTreeSet;
use std::fs::{File, OpenOptions};
use std::io::{self, BufRead, BufReader, ErrorKind, Read, Write};
use std::path::{Path, PathBuf};

/// The file in a folder of results.
pub const FILE: &str = "run.jsonl";

/// No record is as long.
const LONGEST: u64 = 1 << 20;

/// A journal that is written.
#[derive(Debug)]
pub struct Journal {
    file: File,
    path: PathBuf,
}

/// What a journal holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Told {
    /// Its records, in order.
    pub records: Vec<Value>,
    /// How many lines are no records: they were cut short, or changed since.
    pub damaged: usize,
}

/// The field of a record that names the key of the results after it.
const KEY: &str = "key";

impl Told {
    /// The fingerprints of the course keys with which its results were made.
    pub fn keys(&self) -> BTreeSet<String> {
        let keys = self
            .records
            .iter()
            .filter_map(|record| record[KEY].as_str());
        keys.map(str::to_owned).collect()
    }
}

impl Journal {
    /// Opens the journal of a folder, which is made if there is none, to add to it.
    ///
    /// # Errors
    /// If it cannot be made, or not be written.
    pub fn open(folder: &Path) -> Result<Self, StoreError> {
        let path = folder.join(FILE);
        let open = || {
            if path.symlink_metadata().is_ok_and(|there| !there.is_file()) {
                return Err(io::Error::new(ErrorKind::InvalidInput, "it is no file"));
            }
            OpenOptions::new().create(true).append(true).open(&path)
        };
        let file = open().map_err(StoreError::of(&path, "write this journal"))?;
        Ok(Self { file, path })
    }

    /// Adds with which course key the results after it are made, by the key's fingerprint.
    ///
    /// # Errors
    /// As [`add`](Self::add).
    pub fn add_key(&mut self, key: &str) -> Result<(), StoreError> {
        self.add(&json!({ KEY: key }))
    }

    /// Adds a record.
    ///
    /// # Errors
    /// If it cannot be written. Whatever was added before is still there.
    pub fn add(&mut self, record: &Value) -> Result<(), StoreError> {
        let text = record.to_string();
        let line = format!("\n{} {text}\n", checksum(text.as_bytes()));
        let written = self.file.write_all(line.as_bytes());
        written
            .and_then(|()| self.file.sync_data())
            .map_err(StoreError::of(
                &self.path,
                "add to this journal, which is whole up to here,",
            ))
    }
}

/// Reads the journal of a folder; it is empty where there is none.
///
/// # Errors
/// If it cannot be read.
pub fn read(folder: &Path) -> Result<Told, StoreError> {
    let path = folder.join(FILE);
    match File::open(&path) {
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(Told::default()),
        Err(error) => Err(error),
        Ok(file) => records(BufReader::new(file)),
    }
    .map_err(StoreError::of(&path, "read this journal"))
}

fn records(mut text: impl BufRead) -> io::Result<Told> {
    let mut told = Told::default();
    let mut line = Vec::new();
    while text.by_ref().take(LONGEST).read_until(b'\n', &mut line)? > 0 {
        let content = line.trim_ascii();
        match record(content) {
            Some(record) => told.records.push(record),
            None if content.is_empty() => {}
            None => told.damaged += 1,
        }
        line.clear();
    }
    Ok(told)
}

/// The record of a line; `None` if its checksum is wrong.
fn record(line: &[u8]) -> Option<Value> {
    let (sum, text) = line.split_at_checked(SUM)?;
    let text = text.strip_prefix(b" ")?;
    (sum == checksum(text).as_bytes()).then(|| serde_json::from_slice(text).ok())?
}

/// Digits of a checksum.
const SUM: usize = 16;

/// The first digits of the text's SHA-256.
fn checksum(text: &[u8]) -> String {
    hex(&Sha256::digest(text))[..SUM].to_owned()
}
