//! `raybook explain`: one question in full.

use super::asking::Asking;
use super::unwritten::Unwritten;
use super::{Done, Target};
use clap::ArgGroup;
use raybook::store::{self, StoreError};
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::terminal::colourless;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::ask::Asker;
use raybook_grader::check::{Outcome, Report, Verdict, check};
use raybook_grader::dress::Dress;
use raybook_grader::examine::{Case, Examiner, visible_rng};
use raybook_grader::explain::account::Account;
use raybook_grader::explain::tell;
use raybook_grader::json;
use raybook_grader::progress::KEPT;
use std::path::{Path, PathBuf};

/// Explains one case: the question, both answers and where they part, the steps to the right one, and a drawing.
#[derive(clap::Args)]
#[command(group = ArgGroup::new("which"))]
pub struct Explain {
    #[command(flatten)]
    target: Target,
    /// The case of this number; without it the first wrong one, or the first
    #[arg(long, value_name = "N", group = "which", value_parser = clap::value_parser!(u32).range(1..))]
    case: Option<u32>,
    /// The question of a pixel of the exercise's picture: its column and its row from the top left, from 0
    #[arg(long, value_name = "X,Y", group = "which", value_parser = pixel)]
    pixel: Option<[u32; 2]>,
    #[command(flatten)]
    asking: Asking,
    /// Write the drawing into this folder; without it, that of a workbook is kept in its .raybook
    #[arg(long, value_name = "FOLDER")]
    pictures: Option<PathBuf>,
    /// Print JSON (its fields are described in `raybook_grader::explain::account`)
    #[arg(long)]
    json: bool,
    /// No colours and no symbols in front of words
    #[arg(long)]
    plain: bool,
}

impl Explain {
    /// Asks the program all cases of the exercise, and explains one; true if that one is right.
    pub fn run(&self) -> Done {
        let (from, examiners) = self.target.resolve()?;
        let [examiner] = examiners[..] else {
            return Err("explain needs one exercise: raybook explain sphere_hit".into());
        };
        let (cases, chosen) = self.cases(examiner)?;
        let (program, workbook) = self.asking.program(&from, Vec::new())?;
        let mut asker = Asker::new(&program, self.asking.limits());
        let report = check(&mut asker, examiner, cases)?;
        let outcome = chosen.map_or_else(|| first_wrong(&report), |i| report.cases.get(i));
        let outcome = outcome.ok_or_else(|| format!("{} has no cases", examiner.name()))?;
        let account = Account::of(&report, examiner, outcome);
        // What cannot be written must not keep the explanation back.
        let mut unwritten = Unwritten::default();
        let of_workbook = workbook.map(|folder| folder.join(KEPT));
        let folder = self.pictures.clone().or(of_workbook);
        let picture = folder.and_then(|folder| unwritten.or_none(self.keep(&account, &folder)));
        let picture = picture.flatten();
        if self.json {
            say(json::text(&account.json(picture.as_deref())));
        } else {
            let dress = Dress {
                colour: colourless().is_none() && !self.plain,
                symbols: !self.plain,
            };
            say(tell::lines(&account, dress).join("\n"));
            match (&picture, &account.diagram) {
                (Some(path), Some(diagram)) => {
                    let file = Untrusted::from(path.as_path());
                    say(format!("  Drawn: {file}\n         {}.", diagram.title));
                }
                (None, Some(_)) => say("  `--pictures FOLDER` draws it."),
                _ => {}
            }
        }
        unwritten.said()?;
        Ok(outcome.verdict == Verdict::Right)
    }

    /// All cases of the exercise, with the pixel's if one is wanted, and which of them is to be explained; none if the first wrong one.
    fn cases(&self, examiner: &dyn Examiner) -> Result<(Vec<Case>, Option<usize>), String> {
        let name = examiner.name();
        let mut cases = examiner.cases(&mut visible_rng(name)).cases;
        if let Some(number) = self.case {
            let (chosen, count) = (number as usize - 1, cases.len());
            return if chosen < count {
                Ok((cases, Some(chosen)))
            } else {
                Err(format!(
                    "{name} has {count} cases, there is no case {number}"
                ))
            };
        }
        let Some([x, y]) = self.pixel else {
            return Ok((cases, None));
        };
        let size = examiner.picture(0);
        let size =
            size.ok_or_else(|| format!("{name} has no picture; --case chooses one of its cases"))?;
        let (width, height) = (size.width, size.height);
        if x >= width || y >= height {
            return Err(format!(
                "the picture of {name} has {width} columns and {height} rows: there is no pixel {x},{y}"
            ));
        }
        let question = examiner.pixel_question(0, x, y);
        let answer = examiner
            .answer_line(&question)
            .map_err(|error| error.to_string())?;
        let chosen = cases.len();
        cases.push(Case {
            number: chosen + 1,
            name: format!("the pixel in column {x} of row {y} of the picture"),
            question,
            answers: vec![answer],
        });
        Ok((cases, Some(chosen)))
    }

    /// Writes the drawing, if there is one; returns its file.
    fn keep(&self, account: &Account<'_>, folder: &Path) -> Result<Option<PathBuf>, StoreError> {
        let Some(diagram) = &account.diagram else {
            return Ok(None);
        };
        let which = match self.pixel {
            Some([x, y]) => format!("pixel_{x}_{y}"),
            None => format!("case_{}", account.outcome.case.number),
        };
        let path = folder.join(format!("{}_{which}.svg", account.report.exercise));
        store::write(&path, diagram.svg().as_bytes())?;
        Ok(Some(path))
    }
}

/// The first wrong case, or else the first.
fn first_wrong(report: &Report) -> Option<&Outcome> {
    let wrong = report.first_wrong().map(|(outcome, _)| outcome);
    wrong.or_else(|| report.cases.first())
}

/// A pixel's column and row.
fn pixel(text: &str) -> Result<[u32; 2], String> {
    let wrong = || {
        let text = Untrusted::from(text);
        format!("`{text}` is no pixel: its column and its row are wanted, for example 63,40")
    };
    let (x, y) = text.split_once(',').ok_or_else(wrong)?;
    let number = |word: &str| word.trim().parse().map_err(|_| wrong());
    Ok([number(x)?, number(y)?])
}
