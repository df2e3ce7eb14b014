//! `raybook exercise`: all exercises, a line each; of one, what it asks, field by field.

use super::golden::Golden;
use super::{Done, Target};
use raybook_chapters::kit::say::say;
use raybook_grader::describe::{describe, schema};
use raybook_grader::examine::Examiner;
use raybook_grader::json;
use raybook_grader::language::Language;
use raybook_grader::reader::{cpp, python};
use raybook_grader::{library, starter, student};
use serde_json::json;
use std::path::Path;

/// Describes exercises.
#[derive(clap::Args)]
pub struct Exercise {
    #[command(flatten)]
    target: Target,
    #[command(flatten)]
    golden: Golden,
    /// Print JSON (its fields are described in `raybook_grader::describe`)
    #[arg(long, conflicts_with = "reader")]
    json: bool,
    /// Print a program in this language, python or cpp, that reads the questions of one exercise and writes its answers
    #[arg(long, value_name = "LANGUAGE", value_parser = Language::named)]
    reader: Option<Language>,
}

impl Exercise {
    /// Describes them; without a name, lists all.
    pub fn run(&self) -> Done {
        let (_, examiners) = self.target.resolve()?;
        let examiners = self.golden.replace(examiners)?;
        if let Some(language) = self.reader {
            let [examiner] = examiners[..] else {
                return Err(
                    "--reader needs one exercise: raybook exercise sphere_hit --reader python"
                        .into(),
                );
            };
            let asked = examiner.asked();
            say(match language {
                Language::Python => python::program(asked),
                Language::Cpp => cpp::program(asked),
                Language::Rust => {
                    return Err(
                        "in Rust a workbook reads the questions: raybook new my-rays".into(),
                    );
                }
            });
        } else if self.json {
            let exercises: Vec<_> = examiners.into_iter().map(schema).collect();
            say(json::text(&json!({ "version": 1, "exercises": exercises })));
        } else if self.target.what.is_empty() {
            say(starter::course_map());
            say(
                "`raybook exercise sphere_hit` says what one of them asks, and `raybook exercise ch03` what those of a chapter ask.",
            );
        } else {
            let workbook = student::workbook(Path::new(".")).ok();
            let described = |examiner: &dyn Examiner| {
                let name = examiner.name();
                let place = match &workbook {
                    Some(folder) => student::place(folder, name),
                    None => library::place(name),
                };
                describe(examiner, place.as_deref(), workbook.is_none())
            };
            let texts: Vec<_> = examiners.into_iter().map(described).collect();
            say(texts.join("\n"));
        }
        Ok(true)
    }
}
