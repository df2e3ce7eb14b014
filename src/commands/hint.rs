//! `raybook hint`: a nudge that does not give the answer away.

use super::{Done, Target};
use raybook::grade::check::{State, check};
use raybook::grade::converse::Limits;
use raybook::grade::examine::visible_rng;
use raybook::grade::{library, student};
use std::time::Duration;

/// Hints at what is wrong.
#[derive(clap::Args)]
pub struct Hint {
    #[command(flatten)]
    target: Target,
}

impl Hint {
    /// Asks the student's program, and hints at the first exercise that is not right.
    pub fn run(&self) -> Done {
        let (from, examiners) = self.target.resolve()?;
        let program = student::build(&student::workbook(&from)?)?;
        let limits = Limits {
            time: Duration::from_secs(2),
            output: 1 << 20,
        };
        for examiner in examiners {
            let report = check(
                &program,
                examiner,
                examiner.cases(&mut visible_rng(examiner.name())).cases,
                limits,
            )?;
            let name = report.exercise;
            match (report.state(), &report.diagnosis, report.first_wrong()) {
                (State::Right, ..) => continue,
                (State::NotStarted, ..) => {
                    println!(
                        "{name}: {}\nWrite it in {}.",
                        examiner.task(),
                        library::place(name).unwrap_or_default()
                    );
                }
                (State::WaitsFor(other), ..) => {
                    println!("{name} calls {other}, which you have not written yet.");
                }
                (State::Wrong, Some(diagnosis), _) => println!("{name}: {}", diagnosis.hint),
                (State::Wrong, None, first) => {
                    let (case, why) =
                        first.map_or(("", ""), |(outcome, why)| (outcome.case.name.as_str(), why));
                    println!("{name}: think of the case \"{case}\": {why}.");
                }
            }
            return Ok(true);
        }
        println!("Nothing to hint at: everything that was asked for is right.");
        Ok(true)
    }
}
