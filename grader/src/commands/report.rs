//! `raybook report`: a student's work on one page.

use super::asking::Asking;
use super::{Done, Target, tell_new_folder};
use indicatif::ProgressBar;
use raybook::store;
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::ask::Asker;
use raybook_grader::check::{self, State, check_all};
use raybook_grader::examine::{Examiner, visible_rng};
use raybook_grader::picture::ask::Pixels;
use raybook_grader::progress::Progress;
use raybook_grader::rare::Depth;
use raybook_grader::report::{Page, cost};
use rayon::prelude::*;
use std::path::PathBuf;

/// Writes a page of your work that needs no other file: verdicts, what explains the wrong answers, pictures, and costs.
#[derive(clap::Args)]
pub struct Report {
    #[command(flatten)]
    target: Target,
    #[command(flatten)]
    asking: Asking,
    /// The page; without it out/report.html in the workbook
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

impl Report {
    /// Checks everything that was named, and writes the page; true if all is right.
    pub fn run(&self) -> Done {
        let (from, examiners) = self.target.resolve()?;
        let (program, workbook) = self.asking.program(&from, Vec::new())?;
        let of_workbook = || Some(workbook.as_ref()?.join("out").join("report.html"));
        let out = self.out.clone().or_else(of_workbook);
        let out = out.ok_or("--out FILE says where the page is to be written")?;
        let cases = |examiner: &&'static dyn Examiner| {
            (
                *examiner,
                examiner.cases(&mut visible_rng(examiner.name())).cases,
            )
        };
        let exercises: Vec<_> = examiners.par_iter().map(cases).collect();
        let bar = ProgressBar::new(examiners.len() as u64);
        let limits = self.asking.limits();
        let (pixels, done) = (|_: &dyn Examiner| Pixels::All, || bar.inc(1));
        let reports = check_all(&program, &exercises, limits, &pixels, Depth::Check, &done)?;
        bar.finish_and_clear();
        let mut asker = Asker::new(&program, limits);
        let mut costs = Vec::new();
        for (report, examiner) in reports.iter().zip(examiners) {
            // Only a search that finds what it should has a cost worth a curve.
            if report.state() == State::Right {
                costs.extend(cost::measure(&mut asker, examiner)?);
            }
        }
        let whose = workbook.as_deref().or(self.asking.program.as_deref());
        let progress = workbook
            .as_deref()
            .map(|folder| Progress::load(folder).unwrap_or_default());
        let page = Page {
            whose: whose.map_or_else(Untrusted::default, Untrusted::from),
            reports: &reports,
            costs: &costs,
            progress: progress.as_ref(),
            error: None,
        };
        if self.out.is_some() {
            tell_new_folder(&out);
        }
        store::write(&out, page.html().as_bytes())?;
        say(format!("Your report: {}", Untrusted::from(out.as_path())));
        let is_right = |report: &check::Report| report.state() == State::Right;
        Ok(reports.iter().all(is_right))
    }
}
