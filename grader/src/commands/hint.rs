//! `raybook hint`: a nudge that does not give the answer away.

use super::asking::Asking;
use super::{Done, Target};
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::ask::Asker;
use raybook_grader::check::{State, check};
use raybook_grader::examine::visible_rng;
use raybook_grader::student;

/// Hints at what is wrong.
#[derive(clap::Args)]
pub struct Hint {
    #[command(flatten)]
    target: Target,
    #[command(flatten)]
    asking: Asking,
}

impl Hint {
    /// Asks the program, and hints at the first exercise that is not right.
    pub fn run(&self) -> Done {
        let (from, examiners) = self.target.resolve()?;
        let (program, workbook) = self.asking.program(&from, Vec::new())?;
        let mut asker = Asker::new(&program, self.asking.limits());
        for examiner in examiners {
            let report = check(
                &mut asker,
                examiner,
                examiner.cases(&mut visible_rng(examiner.name())).cases,
            )?;
            let name = report.exercise;
            match (report.state(), &report.diagnosis, report.first_wrong()) {
                (State::Right, ..) => continue,
                (State::NotStarted, ..) => {
                    say(format!("{name}: {}", examiner.task()));
                    if let Some(file) = workbook.and_then(|folder| student::place(&folder, name)) {
                        say(format!("Write it in {file}."));
                    }
                }
                (State::WaitsFor(other), ..) => {
                    say(format!(
                        "{name} calls {other}, which you have not written yet."
                    ));
                }
                (State::Wrong, Some(diagnosis), _) => say(format!("{name}: {}", diagnosis.hint)),
                (State::Wrong, None, first) => {
                    let (case, why) =
                        first.map_or(("", ""), |(outcome, why)| (outcome.case.name.as_str(), why));
                    let case = Untrusted::from(case);
                    say(format!("{name}: think of the case \"{case}\": {why}."));
                }
            }
            return Ok(true);
        }
        say("Nothing to hint at: everything that was asked for is right.");
        Ok(true)
    }
}
