//! `raybook regrade`: grades by other rules, from what is known already. First it says who changes, and why.

use super::{Done, course};
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::class::changes::{Change, changes};
use raybook_grader::class::grades::points;
use raybook_grader::class::record::{Record, known};
use raybook_grader::class::roll::{Class, Results};
use raybook_grader::class::{export, journal};
use std::error::Error;
use std::path::PathBuf;

/// Grades by other rules, without asking a hand-in again.
#[derive(clap::Args)]
pub struct Regrade {
    /// The folder of the results
    #[arg(default_value = "results")]
    results: PathBuf,
    /// What counts now
    #[arg(long, value_name = "FILE")]
    course: PathBuf,
    /// Write the grades; without it, only say whose grade would change, and why
    #[arg(long)]
    write: bool,
}

impl Regrade {
    /// Previews or writes; true if everything is graded.
    pub fn run(&self) -> Done {
        let course = course::read(&self.course)?;
        if !self.results.is_dir() {
            return Err(format!(
                "{}: there is no such folder; `raybook grade` makes it",
                Untrusted::from(self.results.as_path())
            )
            .into());
        }
        let results = Results::take(&self.results)?;
        let roll = results.roll()?;
        if course.term != roll.term {
            return Err("the course file has another term, and so other hidden cases: `raybook grade` asks them".into());
        }
        let records = journal::read(&self.results)?.records;
        let is_current =
            |record: &Record| roll.editions.get(&record.exercise) == Some(&record.edition);
        let known = known(
            records
                .iter()
                .filter_map(Record::from_json)
                .filter(is_current),
        );
        let class = Class::of(&course, &roll, &known);
        let changes = changes(&results.written()?, &class);
        tell(&changes);
        if self.write {
            publish(&results, &class)?;
        } else if !changes.is_empty() {
            say("Nothing is written; --write writes it.");
        }
        Ok(class
            .grades
            .iter()
            .all(raybook_grader::class::grades::Grade::is_complete))
    }
}

/// Says whose grade changes, and why.
pub fn tell(changes: &[Change]) {
    if changes.is_empty() {
        say("no grade changes");
        return;
    }
    let of = |grade: Option<[f64; 2]>| {
        grade.map_or_else(
            || "nothing".to_owned(),
            |[got, of]| format!("{} of {}", points(got), points(of)),
        )
    };
    for change in changes {
        let student = Untrusted::from(change.student.as_str());
        say(format!(
            "{student}: {} → {}  ({})",
            of(change.before),
            of(change.after),
            change.why.join("; ")
        ));
    }
    let changed = changes
        .iter()
        .filter(|change| change.before.map(|[got, _]| got) != change.after.map(|[got, _]| got))
        .count();
    say(format!("{changed} students have other points"));
}

/// Writes the grades, and all files that others read.
pub fn publish(results: &Results<'_>, class: &Class<'_>) -> Result<(), Box<dyn Error>> {
    export::write(results.folder, class)?;
    results.remember(class)?;
    let complete = class
        .grades
        .iter()
        .filter(|grade| grade.is_complete())
        .count();
    say(format!(
        "{complete} of {} hand-ins are graded in full; look at {}",
        class.grades.len(),
        Untrusted::from(results.folder.join("index.html").as_path())
    ));
    Ok(())
}
