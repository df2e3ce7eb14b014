//! What a student reads, for every kind of reply. The snapshots are in `golden/snapshots/feedback_*`: read them as one who is tired.

mod answers;
mod states;

use raybook_grader::ask::{Reply, Said};
use raybook_grader::cases;
use raybook_grader::check::{Mark, Outcome, Report, assess};
use raybook_grader::converse::Prints;
use raybook_grader::dress::Dress;
use raybook_grader::examine::{Examiner, visible_rng};
use raybook_grader::feedback::{self, Commands};
use std::path::Path;

const DRESS: Dress = Dress {
    colour: false,
    symbols: true,
};

/// The report on a program that replies so.
fn report(exercise: &str, reply: impl Fn(&dyn Examiner, &str) -> Said) -> Report {
    let examiner = cases::find(exercise).expect("the exercise exists");
    let cases = examiner.cases(&mut visible_rng(exercise)).cases;
    let replies = cases.iter().map(|case| Reply {
        said: reply(examiner, &case.question),
        printed: Prints::default(),
    });
    let replies = replies.collect();
    assess(examiner, cases, replies)
}

/// What a student with this report reads.
fn told(report: &Report) -> String {
    let examiner = cases::find(report.exercise).expect("the exercise exists");
    let picture = (!report.pictures.is_empty()).then_some(Path::new(".raybook/picture.png"));
    let [again, explain] =
        ["check", "explain"].map(|command| format!("raybook {command} {}", report.exercise));
    let commands = Commands {
        again: &again,
        explain: Some(&explain),
    };
    format!(
        "{}\n\n{}",
        feedback::line(report, DRESS),
        feedback::explain(report, examiner, picture, commands, DRESS)
    )
}

fn right(examiner: &dyn Examiner, question: &str) -> Said {
    let answer = examiner.answer_line(question).expect("it is a question");
    Said::Answer(answer.into())
}

#[test]
fn a_sentence_has_one_mark_at_its_end() {
    for (said, ended) in [
        ("t is 1 m too large", "t is 1 m too large."),
        ("which root is it?", "which root is it?"),
    ] {
        assert_eq!(feedback::ended(said), ended);
    }
}

#[test]
fn one_wrong_answer_does_not_hide_what_is_wrong_in_all_together() {
    let question_of_one_wrong = "150 151";
    let report = report("random_pattern", |examiner, question| {
        let (n, _) = question.split_once(' ').expect("n and the seed");
        let same_seed = right(examiner, &format!("{n} 1"));
        if question
            .split_whitespace()
            .eq(question_of_one_wrong.split(' '))
        {
            Said::Answer("0".into())
        } else {
            same_seed
        }
    });
    let is_together = |one: &&Outcome| matches!(&one.verdict, Mark::Wrong(why) if why.starts_with("in all answers together"));
    let together = report.cases.iter().filter(is_together).count();
    assert_eq!(report.right(), 0);
    assert_eq!(together, report.cases.len() - 1, "all but the one");
}
