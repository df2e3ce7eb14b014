//! The page of `raybook watch --page`: all that was checked since the watch began, and any pixel of its pictures explained.

use raybook_chapters::kit::say::error_text;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::ask::Asker;
use raybook_grader::cases;
use raybook_grader::check::Report;
use raybook_grader::converse::Limits;
use raybook_grader::explain::asked::{Asked, Which, pixel};
use raybook_grader::mutex::lock;
use raybook_grader::progress::Progress;
use raybook_grader::report;
use raybook_grader::serve::{Answer, Server};
use raybook_grader::student;
use std::error::Error;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard};
use std::thread::spawn;

/// The page's script: it asks for the page again and again, shows what has changed, and makes its pictures answer to keys and clicks.
const SCRIPT: &str = concat!(include_str!("inspect.js"), include_str!("renew.js"));

/// What is shown before the first check is done.
const NOTHING_YET: &str = "<!DOCTYPE html><html lang=\"en\"><title>raybook</title><main><h1>raybook</h1><p>The first check is not done yet.</p></main></html>";

/// The page, and what it tells.
#[derive(Debug)]
pub struct Page {
    folder: PathBuf,
    reports: Vec<Report>,
    text: Arc<Mutex<String>>,
    /// Held while the workbook's program is built and asked, for two builds of one folder disturb each other.
    asking: Arc<Mutex<()>>,
}

impl Page {
    /// Serves the page of a workbook until the command ends; returns its address, too.
    pub fn serve(folder: &Path) -> io::Result<(Self, String)> {
        let server = Server::new(0)?;
        let address = server.address();
        let text = Arc::new(Mutex::new(NOTHING_YET.to_owned()));
        let shown = Arc::clone(&text);
        let asking = Arc::new(Mutex::new(()));
        let (alone, workbook) = (Arc::clone(&asking), folder.to_owned());
        spawn(move || {
            server.run(move |request| {
                let parts: Vec<_> = request.path.split('/').collect();
                match parts[..] {
                    [""] => {
                        let text = lock(&shown).clone();
                        Answer::page(&text, SCRIPT)
                    }
                    ["explain", exercise, pixel] => {
                        let _alone = lock(&alone);
                        explain(&workbook, exercise, pixel)
                            .unwrap_or_else(|error| Answer::wrong(&error_text(&*error)))
                    }
                    _ => Answer::unknown(),
                }
            });
        });
        let page = Self {
            folder: folder.to_owned(),
            reports: Vec::new(),
            text,
            asking,
        };
        Ok((page, address))
    }

    /// Nobody else builds or asks the workbook's program as long as this is held.
    pub fn alone(&self) -> MutexGuard<'_, ()> {
        lock(&self.asking)
    }

    /// Shows what was just checked, or why nothing could be, beside what was checked before.
    pub fn show(&mut self, checked: Result<Vec<Report>, String>) {
        let (reports, error) = match checked {
            Ok(reports) => (reports, None),
            Err(error) => (Vec::new(), Some(error)),
        };
        for report in reports {
            self.reports.retain(|old| old.exercise != report.exercise);
            self.reports.push(report);
        }
        let progress = Progress::load(&self.folder).unwrap_or_default();
        let page = report::Page {
            whose: Untrusted::from(self.folder.as_path()),
            reports: &self.reports,
            costs: &[],
            progress: Some(&progress),
            error: error.as_deref(),
        };
        *lock(&self.text) = page.html();
    }
}

/// Asks the workbook's program for a pixel of an exercise's picture, and tells it in full.
fn explain(folder: &Path, exercise: &str, at: &str) -> Result<Answer, Box<dyn Error>> {
    let Some(examiner) = cases::find(exercise) else {
        return Ok(Answer::unknown());
    };
    let program = student::build(folder)?;
    let mut asker = Asker::new(&program, Limits::default());
    let asked = Asked::new(&mut asker, examiner, Which::Pixel(pixel(at)?))?;
    let account = asked.account().ok_or("there is no such case")?;
    Ok(Answer::part(report::explained(&account).into_string()))
}
