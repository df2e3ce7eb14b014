//! `raybook grade`: a class of hand-ins.

use super::golden::Golden;
use super::pace::Pace;
use super::regrade::{publish, tell};
use super::{Done, course, hidden};
use raybook::store;
use raybook_chapters::kit::say::{complain, say};
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::class::changes::changes;
use raybook_grader::class::course::Course;
use raybook_grader::class::exam::{self, Exam};
use raybook_grader::class::grades::{Known, Sheet};
use raybook_grader::class::hand_in::{self, HandIn};
use raybook_grader::class::journal::{self, Journal};
use raybook_grader::class::record::{self, Marked, Record, Standing};
use raybook_grader::class::roll::{Class, Results, Roll};
use raybook_grader::class::run::{Shard, open, run};
use raybook_grader::class::stage::Stage;
use raybook_grader::class::when::Timestamp;
use raybook_grader::class::{similar, times};
use raybook_grader::mutex::{self, lock};
use raybook_grader::sandbox::{Missing, Sandbox};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// Grades a class. What was graded before is not graded again: an interrupted run goes on where it was.
#[derive(clap::Args)]
pub struct Grade {
    /// The folder of the hand-ins: a folder, a .zip, a .tar.gz or a program in Python or C++ for each student
    hand_ins: PathBuf,
    /// What counts, and how much (`raybook course new` writes one)
    #[arg(long, value_name = "FILE")]
    course: PathBuf,
    /// The course key, from which the hidden cases follow; `-` reads it from standard input
    #[arg(long, value_name = "FILE")]
    key_file: PathBuf,
    /// The folder of the results
    #[arg(long, value_name = "FOLDER", default_value = "results")]
    out: PathBuf,
    /// When each hand-in came: a file with `student,time` on each line. Without it nobody is late
    #[arg(long, value_name = "FILE")]
    times: Option<PathBuf>,
    /// Grade part I of N of the class, and write the journal alone; `cat` merges journals
    #[arg(long, value_name = "I/N", value_parser = shard)]
    shard: Option<Shard>,
    /// How many hand-ins at the same time; as many as there are processors, if not said
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    jobs: Option<u16>,
    #[command(flatten)]
    golden: Golden,
}

impl Grade {
    /// Grades; true if everything is graded.
    pub fn run(&self) -> Done {
        let course = course::read(&self.course)?;
        let key = hidden::read_key(&self.key_file)?;
        let times = self.times()?;
        let examiners = self.golden.replace(course.examiners())?;
        let sandbox = self.sandbox(&course, examiners.len())?;
        let results = Results::take(&self.out)?;
        let mut journal = Journal::open(&self.out)?;
        let told = journal::read(&self.out)?;
        let (print, keys) = (exam::fingerprint(&key), told.keys());
        results.only_for(&print, &keys)?;
        if keys.is_empty() {
            journal.add_key(&print)?;
        }
        if told.damaged > 0 {
            complain(format!(
                "note: {} lines of the journal were cut short or changed; what they told is graded again",
                told.damaged
            ));
        }
        let hand_ins = self.read(&course)?;
        let exam = Exam::new(&course, &examiners, &key)?;
        let of_exam = told
            .records
            .iter()
            .filter_map(Record::from_json)
            .filter(|record| exam.holds(record));
        let mut known = record::known(of_exam);
        let is_done = |(key, result): (&(String, String), &Marked)| {
            (result.standing != Standing::NotGraded).then(|| key.clone())
        };
        let done: BTreeSet<_> = known.iter().filter_map(is_done).collect();
        let mut open = open(&hand_ins, &exam, &done);
        if let Some(shard) = self.shard {
            open.retain(|(_, content, _)| shard.holds(content));
        }
        let stage = Stage::new(&self.out, sandbox)?;
        let graded = Mutex::new(Vec::new());
        let progress = Pace::of(hand_ins.len(), open.len());
        let jobs = self.jobs.map_or_else(
            || std::thread::available_parallelism().map_or(1, usize::from),
            usize::from,
        );
        let ran = run(
            open,
            &course,
            &exam,
            &stage,
            &mut journal,
            jobs,
            &|record| match record {
                Some(record) => {
                    lock(&graded).push(record);
                    progress.tell();
                }
                None => progress.next(),
            },
        );
        progress.end();
        stage.clear()?;
        ran?;
        let graded = mutex::into_inner(graded);
        let complete = tell_missing(&graded);
        if self.shard.is_some() {
            say(format!(
                "part {} is graded; its journal is {}",
                self.shard_name(),
                Untrusted::from(self.out.join(journal::FILE).as_path())
            ));
            return Ok(complete);
        }
        known.extend(record::known(graded.iter().cloned()));
        self.finish(&results, &course, &exam, &hand_ins, &times, &known)
    }

    /// Where the hand-ins of a course are built and run: they cannot read what the exam is made of.
    fn sandbox(&self, course: &Course, exercises: usize) -> Result<Sandbox, Missing> {
        let unreadable = [&self.key_file, &self.course].into_iter().cloned();
        let unreadable = unreadable.chain(self.golden.folder().map(Path::to_owned));
        let unreadable = unreadable.chain(course.own.folders.iter().cloned());
        let mut sandbox = Sandbox::new(unreadable)?;
        sandbox.allowance.memory = course.limits.memory;
        let exercises = u32::try_from(exercises).unwrap_or(u32::MAX);
        sandbox.allowance.processor_time = course.limits.exercise * exercises.max(1);
        Ok(sandbox)
    }

    /// Keeps the roll, and writes the grades; where that would change grades that are written, it tells of them instead.
    fn finish(
        &self,
        results: &Results<'_>,
        course: &Course,
        exam: &Exam,
        hand_ins: &[HandIn],
        times: &BTreeMap<String, Timestamp>,
        known: &Known,
    ) -> Done {
        for student in times
            .keys()
            .filter(|student| !hand_ins.iter().any(|hand_in| hand_in.student == **student))
        {
            complain(format!(
                "note: --times names {}, of whom there is no hand-in",
                Untrusted::from(student.as_str())
            ));
        }
        let roll = Roll {
            sheets: hand_ins
                .iter()
                .map(|hand_in| Sheet::of(hand_in, times.get(&hand_in.student).copied()))
                .collect(),
            pairs: similar::pairs(hand_ins),
            editions: exam.editions(),
            key: exam.key.clone(),
            term: course.term.clone(),
        };
        results.keep(&roll)?;
        let class = Class::of(course, &roll, known);
        let changes = changes(&results.written()?, &class);
        let of_known = changes.iter().any(|change| change.before.is_some());
        if of_known {
            tell(&changes);
            say(format!(
                "\nGrades that were written before would change: nothing is written. `raybook regrade {} --course {} --write` writes them.",
                Untrusted::from(self.out.as_path()).shell(),
                Untrusted::from(self.course.as_path()).shell()
            ));
            return Ok(false);
        }
        publish(results, &class)?;
        Ok(class
            .grades
            .iter()
            .all(raybook_grader::class::grades::Grade::is_complete))
    }

    fn times(&self) -> Result<BTreeMap<String, Timestamp>, Box<dyn Error>> {
        match &self.times {
            None => Ok(BTreeMap::new()),
            Some(file) => Ok(times::read(file, &store::read_text(file)?)?),
        }
    }

    /// Reads all hand-ins, in the order of their names.
    fn read(&self, course: &Course) -> Result<Vec<HandIn>, Box<dyn Error>> {
        let beside = [&self.out, &self.course, &self.key_file]
            .into_iter()
            .chain(&self.times)
            .chain(&course.own.folders);
        let beside: Vec<_> = beside.filter_map(|path| path.canonicalize().ok()).collect();
        let listed = hand_in::list(&self.hand_ins, &beside)?;
        for other in &listed.others {
            complain(format!("note: no hand-in: {other}"));
        }
        if listed.found.is_empty() {
            return Err(format!(
                "{}: there is no hand-in here",
                Untrusted::from(self.hand_ins.as_path())
            )
            .into());
        }
        let found: Vec<_> = listed.found.iter().collect();
        let hand_ins: Result<Vec<_>, _> = found
            .par_iter()
            .map(|(student, path)| hand_in::read(student, path, course))
            .collect();
        let hand_ins = hand_ins?;
        for hand_in in &hand_ins {
            if let Err(why) = &hand_in.content {
                complain(format!(
                    "note: {} is refused: {}",
                    Untrusted::from(hand_in.student.as_str()),
                    Untrusted::from(why.as_str())
                ));
            }
        }
        Ok(hand_ins)
    }

    fn shard_name(&self) -> String {
        self.shard
            .map_or_else(String::new, |shard| format!("{}/{}", shard.part, shard.of))
    }
}

/// Tells which results are missing, and why; whether none is.
fn tell_missing(graded: &[Record]) -> bool {
    let mut missing: BTreeMap<&str, usize> = BTreeMap::new();
    for record in graded {
        if record.result.standing == Standing::NotGraded {
            *missing.entry(record.result.why.as_str()).or_default() += 1;
        }
    }
    for (why, count) in &missing {
        complain(format!(
            "{count} results are missing: {}\nThey are no zeros; the next `raybook grade` tries again.",
            Untrusted::from(*why)
        ));
    }
    missing.is_empty()
}

/// A part of a class: `2/8` is the second of eight.
fn shard(text: &str) -> Result<Shard, String> {
    let numbers = text
        .split_once('/')
        .and_then(|(part, of)| Some((part.parse().ok()?, of.parse().ok()?)));
    numbers
        .filter(|&(part, of): &(u64, u64)| 1 <= part && part <= of)
        .map(|(part, of)| Shard { part, of })
        .ok_or_else(|| "two numbers such as 2/8, the second part of eight".to_owned())
}
