//! A chapter as it is drawn. What it says of itself stands once, at the top of its `mod.rs`.

use crate::kit::stage::{Drawn, Stage};
use raybook_workbook::curriculum::{self, Chapter};

/// A chapter as it is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Lesson {
    /// The chapter's name: `ch03_sphere`.
    pub name: &'static str,
    /// The text of its `mod.rs`.
    pub source: &'static str,
    /// Draws its pictures.
    pub draw: fn(&Stage) -> Drawn,
}

/// The chapter whose binary has this name, as it is drawn.
pub fn find(name: &str) -> Option<&'static Lesson> {
    crate::LESSONS.iter().find(|lesson| lesson.name == name)
}

impl Lesson {
    /// Its row of the curriculum.
    ///
    /// # Panics
    /// Never: both are made from one list.
    pub fn chapter(&self) -> &'static Chapter {
        curriculum::find(self.name).expect("lessons and curriculum are made from one list")
    }

    /// What it teaches: the paragraph at the top of its file, in one line.
    pub fn teaches(&self) -> String {
        let paragraph: Vec<_> = self.header().take_while(|line| !line.is_empty()).collect();
        paragraph.join(" ")
    }

    /// The files of `src/` that it introduces: its `New:` lines.
    pub fn new_files(&self) -> Vec<&'static str> {
        let lists = self.header().filter_map(|line| line.strip_prefix("New: "));
        lists
            .flat_map(str::split_whitespace)
            .map(|file| file.trim_end_matches(','))
            .collect()
    }

    /// The lines of the comment at the top of the file, without their `//!`.
    fn header(&self) -> impl Iterator<Item = &'static str> + use<> {
        self.source
            .lines()
            .map_while(|line| line.strip_prefix("//!"))
            .map(str::trim)
    }
}
