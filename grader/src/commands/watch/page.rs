//! The page of `raybook watch --page`: all that was checked since the watch began.

use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::check::Report;
use raybook_grader::progress::Progress;
use raybook_grader::report;
use raybook_grader::serve::{Answer, Server};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::spawn;

/// Asks for the page again and again, and shows what has changed.
const RENEW: &str = include_str!("renew.js");

/// What is shown before the first check is done.
const NOTHING_YET: &str = "<!DOCTYPE html><html lang=\"en\"><title>raybook</title><main><h1>raybook</h1><p>The first check is not done yet.</p></main></html>";

/// The page, and what it tells.
#[derive(Debug)]
pub struct Page {
    folder: PathBuf,
    reports: Vec<Report>,
    text: Arc<Mutex<String>>,
}

impl Page {
    /// Serves the page of a workbook until the command ends; returns its address, too.
    pub fn serve(folder: &Path) -> io::Result<(Self, String)> {
        let server = Server::new(0)?;
        let address = server.address();
        let text = Arc::new(Mutex::new(NOTHING_YET.to_owned()));
        let shown = Arc::clone(&text);
        spawn(move || {
            server.run(move |request| match request.path.as_str() {
                "" => {
                    let text = shown.lock().unwrap_or_else(PoisonError::into_inner).clone();
                    Answer::page(&text, RENEW)
                }
                _ => Answer::unknown(),
            });
        });
        let page = Self {
            folder: folder.to_owned(),
            reports: Vec::new(),
            text,
        };
        Ok((page, address))
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
        *self.text.lock().unwrap_or_else(PoisonError::into_inner) = page.html();
    }
}
