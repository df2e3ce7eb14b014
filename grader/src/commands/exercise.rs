//! `raybook exercise`: what an exercise asks, field by field.

use super::golden::Golden;
use super::{Done, Target};
use raybook_chapters::kit::say::say;
use raybook_grader::describe::{describe, schema};
use raybook_grader::json;
use raybook_grader::language::Language;
use raybook_grader::reader::{cpp, python};
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

impl Exercise {
    /// Describes them; without a name, all.
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
                Language::Rust => {
                    return Err("in Rust a workbook reads the questions: raybook new my-rays".into());
                }
            });
        } else if self.json {
            let exercises: Vec<_> = examiners.into_iter().map(schema).collect();
            say(json::text(&json!({ "version": 1, "exercises": exercises })));
        } else {
            let texts: Vec<_> = examiners.into_iter().map(describe).collect();
            say(texts.join("\n"));
        }
        Ok(true)
    }
}
