//! `raybook book`: the course book, in the browser of this machine.

use super::{Done, browser, chapter};
use raybook_chapters::kit::address;
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::student;
use raybook_workbook::curriculum::Chapter;
use std::env;
use std::path::{Path, PathBuf};

/// Opens the book, or the page of a chapter; nothing is fetched from elsewhere. Where there is no built book, it says where the
/// workbook has the lesson as text.
#[derive(clap::Args)]
pub struct Book {
    /// The chapter (3, ch03, sphere); without it, the first page
    chapter: Option<String>,
    /// The folder of a built book; without it, the book that `book/build` built in the course around you
    #[arg(long, value_name = "FOLDER")]
    folder: Option<PathBuf>,
    /// Only print the address, and open no browser
    #[arg(long)]
    no_open: bool,
}

impl Book {
    /// Opens it, or says where the lesson is.
    pub fn run(&self) -> Done {
        let chapter = self.chapter.as_deref().map(chapter).transpose()?;
        let page = chapter.map_or("index", |chapter| chapter.name);
        let here = env::current_dir()?;
        let around = here.ancestors().map(|folder| folder.join("book/book"));
        let folders: Vec<_> = match &self.folder {
            Some(folder) => vec![here.join(folder)],
            None => around.collect(),
        };
        let pages = folders
            .iter()
            .map(|folder| folder.join(page).with_extension("html"));
        if let Some(page) = pages.into_iter().find(|page| page.is_file()) {
            let address = address::of_file(&page);
            say(format!("The book: {address}"));
            if !self.no_open {
                browser::open(&address);
            }
            return Ok(true);
        }
        if let Some(folder) = &self.folder {
            let folder = Untrusted::from(folder.as_path());
            return Err(format!(
                "{folder}: there is no {page}.html in it; expected the folder of a built book, into which `book/build` writes index.html"
            )
            .into());
        }
        let lesson = lesson(&here, chapter).ok_or(
            "there is no built book here: `book/build` in the course's repository builds it into book/book, and --folder names \
             such a folder; a workbook has the lessons as text",
        )?;
        say(format!(
            "There is no built book here: `book/build` in the course's repository builds one, and --folder names it. The lesson as text: {}",
            Untrusted::from(lesson.as_path())
        ));
        Ok(true)
    }
}

/// The lesson in the workbook around a folder; of all chapters, their folder.
fn lesson(here: &Path, chapter: Option<&Chapter>) -> Option<PathBuf> {
    let lessons = student::workbook(here).ok()?.join("lessons");
    let path = chapter.map_or(lessons.clone(), |chapter| {
        lessons.join(chapter.name).with_extension("md")
    });
    path.exists().then_some(path)
}
