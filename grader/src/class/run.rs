//! A run of the grader over a class: what the journal does not tell yet is graded, on all processors, and told to the journal.

use super::course::Course;
use super::hand_in::{self, Content, HandIn};
use super::journal::{Journal, hex};
use super::record::{Marked, Record, Standing};
use super::stage::{self, Stage, Staged, Trouble};
use crate::ask::MORE_TIME;
use crate::check::check_each;
use crate::examine::{Case, CasesError, Examiner};
use crate::hidden::Key;
use crate::picture::Pixels;
use hmac::{Hmac, KeyInit, Mac};
use raybook::store::StoreError;
use rayon::prelude::*;
use sha2::{Digest, Sha256};
use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The student of the hidden cases of a class: all are asked the same. `raybook check --student class` asks them too.
pub const CLASS: &str = "class";

/// How often a hand-in is tried when something other than itself fails.
const ATTEMPTS: usize = 3;

/// What is asked of everybody.
pub struct Exam {
    /// The exercises, in the order of the course, with their cases.
    asked: Vec<(&'static dyn Examiner, Vec<Case>)>,
    /// For each, the fingerprint of what its result depends on besides the hand-in.
    editions: BTreeMap<&'static str, String>,
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
            let mut hash = Sha256::new();
            let limits = format!("{:?}", course.limits.asking());
            let memory = course.limits.memory.to_string();
            for part in [
                env!("CARGO_PKG_VERSION"),
                &key,
                &course.term,
                &limits,
                &memory,
                examiner.golden(),
            ] {
                hash.update((part.len() as u64).to_le_bytes());
                hash.update(part.as_bytes());
            }
            (examiner.name(), hex(&hash.finalize())[..16].to_owned())
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

/// What is still to be graded: each hand-in once, however many students handed it in, with its exercises.
pub fn open<'a>(
    hand_ins: &'a [HandIn],
    exam: &Exam,
    known: &BTreeSet<(String, String)>,
) -> Vec<(&'a HandIn, &'a Content, BTreeSet<&'static str>)> {
    let mut seen = BTreeSet::new();
    let mut open = Vec::new();
    for hand_in in hand_ins {
        let Ok(content) = &hand_in.content else {
            continue;
        };
        let is_open =
            |name: &&'static str| !known.contains(&(content.print.clone(), (*name).to_owned()));
        let exercises: BTreeSet<_> = exam.editions.keys().copied().filter(is_open).collect();
        if !exercises.is_empty() && seen.insert(&content.print) {
            open.push((hand_in, content, exercises));
        }
    }
    open
}

/// Which hand-ins of a class are graded here: part `part` of `of`, by fingerprint, so that equal ones are in the same part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Which part, from 1.
    pub part: u64,
    /// How many parts there are.
    pub of: u64,
}

impl Shard {
    /// Whether a hand-in is of this part.
    pub fn holds(self, content: &Content) -> bool {
        let number = content
            .print
            .get(..12)
            .and_then(|digits| u64::from_str_radix(digits, 16).ok());
        number.unwrap_or(0) % self.of + 1 == self.part
    }
}

/// Grades what is open, on `jobs` threads. Each result is told to the journal, and then to `done`; `done` is also told when a hand-in
/// is through.
///
/// # Errors
/// If the journal cannot be written: everything ends then, and what is in it stays.
pub fn run(
    open: Vec<(&HandIn, &Content, BTreeSet<&'static str>)>,
    course: &Course,
    exam: &Exam,
    stage: &Stage,
    journal: &mut Journal,
    jobs: usize,
    done: &(dyn Fn(Option<Record>) + Sync),
) -> Result<(), StoreError> {
    let queue = Mutex::new(VecDeque::from(open));
    // A function, so that the queue is free while a hand-in is graded.
    let next = || lock(&queue).pop_front();
    let shared = Mutex::new((journal, None));
    let tell = |record: Record| -> bool {
        let mut shared = lock(&shared);
        let (journal, failed) = &mut *shared;
        if failed.is_none() {
            match journal.add(&record.to_json()) {
                Ok(()) => done(Some(record)),
                Err(error) => *failed = Some(error),
            }
        }
        failed.is_none()
    };
    std::thread::scope(|scope| {
        for _ in 0..jobs.max(1) {
            scope.spawn(|| {
                while lock(&shared).1.is_none()
                    && let Some((hand_in, content, mut exercises)) = next()
                {
                    let worker = Worker {
                        course,
                        exam,
                        stage,
                        hand_in,
                        content,
                        tell: &tell,
                    };
                    worker.grade(&mut exercises);
                    done(None);
                }
            });
        }
    });
    let (_, failed) = shared.into_inner().unwrap_or_else(PoisonError::into_inner);
    failed.map_or(Ok(()), Err)
}

/// The words without the remark on options that give more time.
fn without_options(why: &str) -> String {
    let parts = why.split_once(MORE_TIME);
    let parts = parts.and_then(|(before, rest)| Some((before, rest.split_once(')')?.1)));
    parts.map_or_else(
        || why.to_owned(),
        |(before, after)| before.to_owned() + after,
    )
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// One hand-in being graded.
struct Worker<'a> {
    course: &'a Course,
    exam: &'a Exam,
    stage: &'a Stage,
    hand_in: &'a HandIn,
    content: &'a Content,
    tell: &'a (dyn Fn(Record) -> bool + Sync),
}

impl Worker<'_> {
    /// Grades what is open of the hand-in. What still is, when nothing helps, is told to be not graded.
    fn grade(&self, exercises: &mut BTreeSet<&'static str>) {
        let mut trouble = String::new();
        for _ in 0..ATTEMPTS {
            match self.attempt(exercises) {
                Ok(()) => break,
                Err(why) => trouble = why,
            }
        }
        for exercise in std::mem::take(exercises) {
            if !self.told(
                exercise,
                Marked::without_cases(Standing::NotGraded, &trouble),
            ) {
                break;
            }
        }
        // What is left of it is removed with the whole stage.
        let _ = super::stage::remove(&self.stage.folder.join(&self.content.print));
    }

    fn attempt(&self, exercises: &mut BTreeSet<&'static str>) -> Result<(), Trouble> {
        let (language, files, _) =
            hand_in::files(&self.hand_in.path, self.course).map_err(|error| error.to_string())?;
        let again = hand_in::fingerprint(language, &files);
        if again != self.content.print {
            return Err("it was changed while it was graded; grade again".to_owned());
        }
        let asked: Vec<_> = self
            .exam
            .asked
            .iter()
            .map(|(examiner, _)| *examiner)
            .collect();
        let asked: Vec<_> = asked
            .into_iter()
            .filter(|examiner| exercises.contains(examiner.name()))
            .collect();
        for staged in self
            .stage
            .make(&self.content.print, language, &files, &asked)?
        {
            self.ask(staged, exercises)?;
        }
        Ok(())
    }

    fn ask(
        &self,
        (program, examiners): Staged,
        exercises: &mut BTreeSet<&'static str>,
    ) -> Result<(), Trouble> {
        let program = match program {
            Ok(program) => program,
            Err(why) => {
                for (i, examiner) in examiners.into_iter().enumerate() {
                    exercises.remove(examiner.name());
                    // The compiler's words are kept once.
                    let why = if i == 0 { &why } else { "" };
                    let result = Marked::without_cases(Standing::NotBuilt, why);
                    if !self.told(examiner.name(), result) {
                        break;
                    }
                }
                return Ok(());
            }
        };
        let is_asked = |name: &str| examiners.iter().any(|examiner| examiner.name() == name);
        let asked: Vec<(&dyn Examiner, Vec<Case>)> = self
            .exam
            .asked
            .iter()
            .filter(|(examiner, _)| is_asked(examiner.name()))
            .map(|(examiner, cases)| (*examiner, cases.clone()))
            .collect();
        let limits = self.course.limits.asking();
        let (mut number, mut trouble) = (0, None);
        check_each(
            &program,
            &asked,
            limits,
            Pixels::FirstWrong,
            &mut |report| {
                let (examiner, _) = &asked[number];
                number += 1;
                trouble = examiner.trouble();
                if trouble.is_some() {
                    return false;
                }
                exercises.remove(report.exercise);
                let mut result = Marked::of(&report, *examiner);
                // Where it lies here, and options of a command, mean nothing to the student.
                let place = program.folder.display().to_string();
                result.why = without_options(&result.why.replace(&place, stage::PLACE));
                self.told(report.exercise, result)
            },
        )
        .map_err(|error| error.to_string())?;
        trouble.map_or(Ok(()), Err)
    }

    /// Whether the journal took the result.
    fn told(&self, exercise: &'static str, result: Marked) -> bool {
        (self.tell)(Record {
            hand_in: self.content.print.clone(),
            exercise: exercise.to_owned(),
            edition: self.exam.edition(exercise).unwrap_or_default().to_owned(),
            result,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::without_options;
    use crate::ask::Said;
    use crate::budget::{Over, Whole};
    use std::time::Duration;

    #[test]
    fn students_are_told_of_no_option() {
        let time = Duration::from_secs(2);
        for said in [
            Said::TimedOut(time),
            Said::Over(Over::Time(Whole::Exercise, time)),
        ] {
            let why = said.why_none().expect("there is no answer");
            assert!(why.contains("--time-limit"), "{why}");
            let told = without_options(&format!("{why}!"));
            assert!(!told.contains("--") && told.ends_with('!'), "{told}");
        }
    }
}
