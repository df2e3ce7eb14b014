//! Answers that are right one by one, judged together: right programs stay right, small biases are found, and how small is in a table.

mod biases;

use super::{Alternative, STYLES, alternatives, line};
use biases::{BIASES, Bias};
use raybook::inside::Space;
use raybook::math::pcg;
use raybook::sample::pattern::poisson_disk::poisson_disk;
use raybook_common::{STALE, measured};
use raybook_grader::Verdict;
use raybook_grader::cases;
use raybook_grader::examine::{Case, Examiner};
use raybook_grader::further::{Row, judge_further};
use raybook_grader::hidden::Key;
use raybook_grader::together::Bounds;
use raybook_workbook::row;
use rayon::prelude::*;
use std::convert::Infallible;
use std::fmt::Write;
use std::iter;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{LazyLock, Mutex, MutexGuard};

/// The exercises whose answers are judged together.
const EXERCISES: [&str; 8] = [
    "visible_fraction",
    "cosine_hemisphere",
    "sample_environment",
    "concentric_disk",
    "random_pattern",
    "jittered",
    "poisson_disk",
    "reflected_radiance",
];

/// Of these, the one whose answer is no list and has no count.
const ONE_COLOUR: &str = "reflected_radiance";

/// Number of students who are asked each exercise; of the alternatives, which are right, a part.
const STUDENTS: usize = 20;
const STUDENTS_OF_ALTERNATIVES: usize = 10;

/// The students of each of these exercises: what the reference answers them is known once for all tests.
static ASKED: LazyLock<Vec<Vec<Mutex<Student>>>> = LazyLock::new(|| {
    let student = |of: usize| {
        let examiner = cases::find(EXERCISES[of / STUDENTS]).expect("an exercise");
        Mutex::new(Student::new(examiner, of % STUDENTS))
    };
    let all = (0..EXERCISES.len() * STUDENTS).into_par_iter().map(student);
    let mut all: Vec<_> = all.collect();
    let of_exercise = EXERCISES.iter().map(|_| all.drain(..STUDENTS).collect());
    of_exercise.collect()
});

fn locked(student: &Mutex<Student>) -> MutexGuard<'_, Student> {
    student.lock().expect("no test failed with it")
}

/// A student who is asked an exercise: the questions, each with the golden answer.
struct Student {
    examiner: &'static dyn Examiner,
    cases: Vec<Row>,
    questions: Vec<Vec<f64>>,
    /// To the first of the further questions: as many as a program was asked.
    further: Vec<Row>,
}

impl Student {
    fn new(examiner: &'static dyn Examiner, student: usize) -> Self {
        let key = Key {
            course: "a course's secret".into(),
            term: "summer".into(),
            student: format!("student {student}"),
        };
        let cases = examiner.cases(&mut key.rng(examiner.name())).cases;
        let asked = examiner.asked();
        let row = |case: &Case| {
            let question = asked.read_question(&case.question).expect("a question");
            (
                question,
                asked.read_answer(&case.answers[0]).expect("an answer"),
            )
        };
        Self {
            examiner,
            cases: cases.iter().map(row).collect(),
            questions: examiner.further_questions(&cases),
            further: Vec::new(),
        }
    }

    /// What is said of all answers of a program together, to the cases and to further questions as far as they are asked, and how many were.
    fn together(&mut self, answer: impl Fn(&Row) -> Vec<f64>) -> (Verdict, usize) {
        let Self {
            examiner,
            cases,
            questions,
            further,
        } = self;
        let answered = |row: &Row| (row.0.clone(), answer(row));
        let rows: Vec<_> = cases.iter().map(answered).collect();
        let verdict = examiner.compare_together(&rows, Bounds::CHANCE);
        if verdict.is_err() || questions.is_empty() {
            return (verdict, 0);
        }
        let mut asked = 0;
        let Ok(verdict) = judge_further(*examiner, questions, rows, |part| {
            let first = asked;
            asked += part.len();
            for question in &questions[further.len().min(asked)..asked] {
                let golden = examiner.reference(question).expect("the reference answers");
                further.push((question.clone(), golden));
            }
            let rows = further[first..asked].iter().map(answered);
            Ok::<_, Infallible>(Some(rows.collect()))
        });
        (verdict, asked)
    }
}

#[test]
fn programs_that_are_right_by_another_method_are_right_together() {
    for (exercise, students) in EXERCISES.iter().zip(&*ASKED) {
        let exercise = *exercise;
        let kinds = cases::find(exercise).expect("an exercise").asked();
        let others: Vec<&Alternative> = alternatives()
            .filter(|other| other.exercise == exercise)
            .collect();
        let (asked, programs) = (AtomicUsize::new(0), AtomicUsize::new(0));
        let students = &students[..STUDENTS_OF_ALTERNATIVES];
        students.par_iter().for_each(|student| {
            let mut student = locked(student);
            let (golden, _) = student.together(|row| row.1.clone());
            assert_eq!(golden, Ok(()), "{exercise}, the reference");
            for other in &others {
                let answer = |(question, _): &Row| {
                    let question = row::format(kinds.question, question);
                    let said = line(&other.answer_to(&question), STYLES[0].1);
                    kinds.read_answer(&said).expect("an answer")
                };
                let (verdict, further) = student.together(answer);
                asked.fetch_add(further, Ordering::Relaxed);
                programs.fetch_add(1, Ordering::Relaxed);
                assert_eq!(verdict, Ok(()), "{exercise}, {}", other.method);
            }
        });
        // An eighth of the questions are asked at first: 64 and 100.
        let mean = asked.into_inner() as f64 / programs.into_inner() as f64;
        println!("{exercise}: {mean} further questions on average");
        assert!(mean < 200.0, "{exercise}: {mean}");
    }
}

#[test]
fn who_keeps_the_distance_over_the_edges_too_is_told_that_nothing_is_repeated() {
    let of = EXERCISES.iter().position(|name| *name == "poisson_disk");
    for student in &ASKED[of.expect("it is judged together")] {
        let (verdict, _) = locked(student).together(|(question, _)| {
            let rng = &mut pcg::stream(405, question[1] as u64);
            let points = poisson_disk(question[0] as f32, Space::Torus, rng);
            let numbers = points.iter().flat_map(|p| p.as_dvec2().to_array());
            iter::once(points.len() as f64).chain(numbers).collect()
        });
        let why = verdict.expect_err("the square is repeated nowhere");
        assert!(
            why.contains("nothing is repeated beyond its edges"),
            "{why}"
        );
    }
}

#[test]
fn small_biases_are_found_as_often_as_the_table_says() {
    let mut table = String::from("| exercise | the function … | found in |\n|---|---|---|\n");
    for (exercise, students) in EXERCISES.iter().zip(&*ASKED) {
        let exercise = *exercise;
        let of_exercise = BIASES.iter().find(|(name, _)| *name == exercise);
        let biases = of_exercise.map_or(&[][..], |(_, biases)| biases);
        let found = students.par_iter().map(|student| {
            let mut student = locked(student);
            let is_found = |(_, change): &Bias| {
                let wrong = |(question, golden): &Row| {
                    let (count, numbers) = golden.split_at(usize::from(exercise != ONE_COLOUR));
                    let changed = change(question, numbers.to_vec());
                    [count, &changed].concat()
                };
                student.together(wrong).0.is_err()
            };
            biases.iter().map(is_found).collect::<Vec<_>>()
        });
        let found: Vec<_> = found.collect();
        for (i, (fault, _)) in biases.iter().enumerate() {
            let found = 100 * found.iter().filter(|found| found[i]).count() / STUDENTS;
            writeln!(table, "| `{exercise}` | {fault} | {found} % |").expect("text");
        }
    }
    assert_eq!(measured("biases", &table), table, "{STALE}");
}
