//! A chapter as it is drawn. Its description stands once, at the top of its `mod.rs`.

use crate::kit::knobs;
use crate::kit::stage::{Drawn, Enough, Stage};
use clap::{ArgMatches, Command, Error};
use raybook_workbook::curriculum::{self, Chapter};

/// A chapter as it is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Lesson {
    /// The chapter's name: `ch03_sphere`.
    pub name: &'static str,
    /// The text of its `mod.rs`.
    pub source: &'static str,
    /// Adds its knobs to a command.
    pub(crate) add_knobs: fn(Command) -> Command,
    /// Draws its pictures with its knobs as they are in a command's matches.
    pub(crate) draw: fn(&Stage, &ArgMatches) -> Drawn,
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

    /// Draws its pictures with the default values of all knobs.
    ///
    /// # Errors
    /// If a picture cannot be drawn or written.
    pub fn draw(&self, stage: &Stage) -> Drawn {
        self.draw_turned(stage, &self.turn(&[])?)
    }

    /// Draws its pictures with its knobs as [`Lesson::turn`] leaves them.
    ///
    /// # Errors
    /// If a picture cannot be drawn or written.
    pub fn draw_turned(&self, stage: &Stage, knobs: &ArgMatches) -> Drawn {
        match (self.draw)(stage, knobs) {
            Err(error) if error.is::<Enough>() => Ok(()),
            drawn => drawn,
        }
    }

    /// A command that has its knobs, and nothing else.
    pub fn knobs(&self) -> Command {
        let command = Command::new(self.name)
            .no_binary_name(true)
            .disable_help_flag(true);
        (self.add_knobs)(command)
    }

    /// Its knobs after these arguments: `["--exponent=64"]`.
    ///
    /// # Errors
    /// If there is no such knob, or its value is out of range.
    pub fn turn(&self, arguments: &[String]) -> Result<ArgMatches, Error> {
        let matches = self.knobs().try_get_matches_from(arguments);
        let matches = matches.map_err(|error| knobs::plain(&self.knobs(), error))?;
        knobs::check(&self.knobs(), &matches)?;
        Ok(matches)
    }

    /// What it teaches: the paragraph at the top of its file, in one line.
    pub fn teaches(&self) -> String {
        let paragraph: Vec<_> = self.header().take_while(|line| !line.is_empty()).collect();
        paragraph.join(" ")
    }

    /// The files of `src/` that it introduces: its `New:` lines.
    pub fn new_files(&self) -> Vec<&'static str> {
        self.listed("New: ")
    }

    /// Its pictures that every page shows pixel by pixel, because scaling would add patterns: its `Unscaled:` line.
    pub fn unscaled(&self) -> Vec<&'static str> {
        self.listed("Unscaled: ")
    }

    /// The words after this word, on all lines that begin with it.
    fn listed(&self, first: &str) -> Vec<&'static str> {
        let lists = self.header().filter_map(|line| line.strip_prefix(first));
        lists
            .flat_map(str::split_whitespace)
            .map(|word| word.trim_end_matches(','))
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
