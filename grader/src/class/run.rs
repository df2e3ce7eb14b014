//! A run of the grader over a class: what the journal does not tell yet is graded, on all processors, and told to the journal.

use super::course::Course;
use super::exam::Exam;
use super::hand_in::{self, Content, HandIn};
use super::journal::Journal;
use super::record::{Marked, Record, Standing};
use super::stage::{self, Stage, Staged, Trouble};
use crate::check::check_each;
use crate::examine::{Case, Examiner};
use crate::mutex::{self, lock};
use crate::picture::ask::Pixels;
use crate::rare::Depth;
use raybook::store::StoreError;
use std::collections::{BTreeSet, VecDeque};
use std::sync::Mutex;

/// How often a hand-in is tried when something other than itself fails.
const ATTEMPTS: usize = 3;

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
    let (_, failed) = mutex::into_inner(shared);
    failed.map_or(Ok(()), Err)
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
        let _ = self.stage.strike(&self.content.print);
    }

    fn attempt(&self, exercises: &mut BTreeSet<&'static str>) -> Result<(), Trouble> {
        let (language, files, _) =
            hand_in::files(&self.hand_in.path, self.course).map_err(|error| error.to_string())?;
        let again = hand_in::fingerprint(language, &files);
        if again != self.content.print {
            return Err("it was changed while it was graded; grade again".to_owned());
        }
        let asked = self.exam.asked.iter().map(|(examiner, _)| *examiner);
        let asked: Vec<_> = asked
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
            Err((standing, why)) => {
                for (i, examiner) in examiners.into_iter().enumerate() {
                    exercises.remove(examiner.name());
                    // The words, which may be a compiler's, are kept once.
                    let why = if i == 0 { &why } else { "" };
                    let result = Marked::without_cases(standing, why);
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
            &|_| Pixels::FirstWrong,
            Depth::Grade,
            &mut |report| {
                let (examiner, _) = &asked[number];
                number += 1;
                trouble = examiner.trouble();
                if trouble.is_some() {
                    return false;
                }
                exercises.remove(report.exercise);
                let mut result = Marked::of(&report, *examiner);
                // Where it lies here means nothing to the student.
                let place = program.folder.display().to_string();
                result.why = result.why.replace(&place, stage::PLACE);
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
