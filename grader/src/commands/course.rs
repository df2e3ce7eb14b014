//! `raybook course`: the file that says what a course grades.

use super::Done;
use raybook::store;
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::class::course::{Course, template};
use raybook_grader::examine::visible_rng;
use std::path::{Path, PathBuf};

/// The file that says what a course grades.
#[derive(clap::Subcommand)]
pub enum CourseFile {
    /// Write a course file with everything that can be set
    New {
        /// The file to write
        #[arg(default_value = "course.toml")]
        file: PathBuf,
    },
    /// Read a course file, and say what it counts
    Show {
        /// The file
        #[arg(default_value = "course.toml")]
        file: PathBuf,
    },
}

/// Reads a course file.
///
/// # Errors
/// If it cannot be read, or something in it is wrong.
pub fn read(file: &Path) -> Result<Course, Box<dyn std::error::Error>> {
    Ok(Course::read(file, &store::read_text(file)?)?)
}

impl CourseFile {
    /// Writes it, or tells of it.
    pub fn run(&self) -> Done {
        match self {
            Self::New { file } => {
                if file.symlink_metadata().is_ok() {
                    let file = Untrusted::from(file.as_path());
                    return Err(
                        format!("{file}: this is there already; choose another name").into(),
                    );
                }
                store::write(file, template().as_bytes())?;
                let file = Untrusted::from(file.as_path());
                say(format!(
                    "wrote {file}: take out what you do not grade, and say what counts\n\n\
                     Next:  head -c 32 /dev/urandom | base64 > course.key     (the hidden cases follow from it: keep it secret)\n       \
                     raybook grade HAND-INS --course {} --key-file course.key --out results",
                    file.shell()
                ));
            }
            Self::Show { file } => {
                let course = read(file)?;
                // The instructor's program is tried, too: better now than when a class waits.
                for examiner in &course.own.exercises {
                    examiner.try_cases(&mut visible_rng(examiner.name()))?;
                }
                tell(&course);
            }
        }
        Ok(true)
    }
}

fn tell(course: &Course) {
    let term = Untrusted::from(course.term.as_str());
    let of_term = if course.term.is_empty() {
        String::new()
    } else {
        format!(", {term}")
    };
    say(format!(
        "{}{of_term}",
        Untrusted::from(course.title.as_str())
    ));
    for plan in &course.chapters {
        let due = plan
            .due
            .map_or_else(String::new, |due| format!(", due {due}"));
        let weight = if plan.weight == 1.0 {
            String::new()
        } else {
            format!(", times {}", plan.weight)
        };
        let number = match plan.chapter.number() {
            0 => String::new(),
            number => number.to_string(),
        };
        say(format!("{number:>2} {}{weight}{due}", plan.chapter.title));
        for exercise in &plan.exercises {
            let bonus = if exercise.bonus { " (bonus)" } else { "" };
            say(format!(
                "   {:<22} {:>6}{bonus}",
                exercise.name, exercise.points
            ));
        }
    }
    say(format!("{} points can be reached", course.reachable()));
}
