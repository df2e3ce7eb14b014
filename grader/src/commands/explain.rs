//! `raybook explain`: one question in full.

use super::asking::Asking;
use super::manner::Manner;
use super::unwritten::Unwritten;
use super::{Done, Examiners, Target};
use clap::ArgGroup;
use raybook::store::{self, StoreError};
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::ask::Asker;
use raybook_grader::check::{Mark, State, check};
use raybook_grader::examine::{Examiner, visible_rng};
use raybook_grader::explain::account::Account;
use raybook_grader::explain::asked::{Asked, Which, pixel};
use raybook_grader::explain::tell;
use raybook_grader::json;
use raybook_grader::progress::KEPT;
use std::io;
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
    #[command(flatten)]
    manner: Manner,
}

impl Explain {
    /// Asks the program all cases of the exercise, and explains one; true if that one is right.
    pub fn run(&self) -> Done {
        let (from, examiners) = self.target.resolve()?;
        let which = match (self.case, self.pixel) {
            (Some(number), _) => Which::Case(number as usize),
            (None, Some(pixel)) => Which::Pixel(pixel),
            (None, None) => Which::FirstWrong,
        };
        let (program, workbook) = self.asking.program(&from, Vec::new())?;
        let mut asker = Asker::new(&program, self.asking.limits());
        let examiner = match examiners[..] {
            [examiner] => examiner,
            _ if which != Which::FirstWrong => {
                return Err("of which exercise? For example: raybook explain sphere_hit".into());
            }
            _ => {
                let Some(examiner) = first_wrong(&mut asker, &examiners)? else {
                    say("Nothing to explain: everything that was asked for is right.");
                    return Ok(true);
                };
                examiner
            }
        };
        let asked = Asked::new(&mut asker, examiner, which)?;
        let account = asked.account();
        let account = account.ok_or_else(|| format!("{} has no cases", examiner.name()))?;
        // What cannot be written must not keep the explanation back.
        let mut unwritten = Unwritten::default();
        let of_workbook = workbook.map(|folder| folder.join(KEPT));
        let folder = self.pictures.clone().or(of_workbook);
        let picture = folder.and_then(|folder| unwritten.or_none(self.keep(&account, &folder)));
        let picture = picture.flatten();
        if self.manner.json {
            say(json::text(&account.json(picture.as_deref())));
        } else {
            say(tell::lines(&account, self.manner.look.dress()).join("\n"));
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
        Ok(account.outcome.verdict == Mark::Right)
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

/// The first exercise that is not right.
fn first_wrong(
    asker: &mut Asker<'_>,
    examiners: &Examiners,
) -> io::Result<Option<&'static dyn Examiner>> {
    for &examiner in examiners {
        let cases = examiner.cases(&mut visible_rng(examiner.name())).cases;
        if check(asker, examiner, cases)?.state() != State::Right {
            return Ok(Some(examiner));
        }
    }
    Ok(None)
}
