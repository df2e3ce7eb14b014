//! `raybook report`: a student's work on one page.

use super::asking::Asking;
use super::keep::keep_pictures;
use super::{Done, Target};
use indicatif::ProgressBar;
use raybook::store;
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::ask::Asker;
use raybook_grader::check::{State, check_all};
use raybook_grader::examine::{Examiner, visible_rng};
use raybook_grader::picture::Pixels;
use raybook_grader::progress::KEPT;
use raybook_grader::report::{Checked, cost, page};
use rayon::prelude::*;
use std::error::Error;
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
        let (out, right) = self.write()?;
        say(format!("Your report: {}", Untrusted::from(out.as_path())));
        Ok(right)
    }

    /// Checks and writes; returns the page's file, and whether all is right.
    pub fn write(&self) -> Result<(PathBuf, bool), Box<dyn Error>> {
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
        let reports = check_all(&program, &exercises, limits, Pixels::All, &|| bar.inc(1))?;
        bar.finish_and_clear();
        let mut asker = Asker::new(&program, limits);
        let mut costs = Vec::new();
        for (report, examiner) in reports.iter().zip(examiners) {
            // Only a search that finds what it should has a cost worth a curve.
            if report.state() == State::Right {
                costs.extend(cost::measure(&mut asker, examiner)?);
            }
        }
        let pictures = match &workbook {
            Some(folder) => folder.join(KEPT),
            None => out.with_extension("pictures"),
        };
        let with_picture = |report| {
            let file = keep_pictures(&report, Some(&pictures))?;
            let png = file.map(|file| store::read(&file)).transpose()?;
            Ok((report, png))
        };
        let all = reports.into_iter().map(with_picture);
        let all = all.collect::<Result<Vec<Checked>, Box<dyn Error>>>()?;
        let whose = workbook.as_deref().or(self.asking.program.as_deref());
        let whose = whose.map_or_else(Untrusted::default, Untrusted::from);
        store::write(&out, page(&whose, &all, &costs).as_bytes())?;
        let mut reports = all.iter().map(|(report, _)| report);
        let right = reports.all(|report| report.state() == State::Right);
        Ok((out, right))
    }
}
