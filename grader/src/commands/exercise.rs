//! `raybook exercise`: all exercises, a line each; of one, what it asks, field by field.

use super::golden::Golden;
use super::{Done, Target};
use raybook_chapters::kit::say::say;
use raybook_grader::describe::{describe, schema};
use raybook_grader::json;
use raybook_grader::reader::{cpp, python};
use raybook_workbook::curriculum::CHAPTERS;
use serde_json::json;

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
    /// Print a program in this language that reads the questions of one exercise and writes its answers
    #[arg(long, value_name = "LANGUAGE")]
    reader: Option<Language>,
}

/// A language of programs that can be printed.
#[derive(Clone, Copy, clap::ValueEnum)]
enum Language {
    /// Python 3
    Python,
    /// C++17
    Cpp,
}

impl Exercise {
    /// Describes them; without a name, lists all.
    pub fn run(&self) -> Done {
        let (_, examiners) = self.target.resolve()?;
        let examiners = self.golden.replace(examiners)?;
        if let Some(language) = self.reader {
            // `phong` is a chapter and an exercise of it.
            let named = examiners.iter().copied();
            let named: Vec<_> = named
                .filter(|examiner| self.target.what.iter().any(|word| word == examiner.name()))
                .collect();
            let one = if named.is_empty() { examiners } else { named };
            let [examiner] = one[..] else {
                return Err(
                    "--reader needs one exercise: raybook exercise sphere_hit --reader python"
                        .into(),
                );
            };
            let asked = examiner.asked();
            say(match language {
                Language::Python => python::program(asked),
                Language::Cpp => cpp::program(asked),
            });
        } else if self.json {
            let exercises: Vec<_> = examiners.into_iter().map(schema).collect();
            say(json::text(&json!({ "version": 1, "exercises": exercises })));
        } else if self.target.what.is_empty() {
            say(list());
        } else {
            let texts: Vec<_> = examiners.into_iter().map(describe).collect();
            say(texts.join("\n"));
        }
        Ok(true)
    }
}

/// All exercises by chapter: the name and the task's first words.
fn list() -> String {
    let mut lines = Vec::new();
    for chapter in CHAPTERS {
        lines.push(format!("{:2} {}", chapter.number(), chapter.title));
        for asked in chapter.exercises() {
            let task = asked.task.split([';', ':', ',']).next().unwrap_or_default();
            lines.push(format!(
                "      {:<20} {}",
                asked.name,
                task.trim_end_matches('.')
            ));
        }
    }
    lines.extend([
        String::new(),
        "What one asks, field by field: raybook exercise sphere_hit".to_owned(),
    ]);
    lines.join("\n")
}
