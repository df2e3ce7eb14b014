//! `raybook present`: the course for a projector, a picture per screen, with the knobs of its chapter.

mod drawing;
mod place;
mod screens;

use super::{Done, browser, chapter};
use drawing::Studio;
use raybook_chapters::kit::options::Options;
use raybook_chapters::kit::say::say;
use raybook_chapters::lesson::{self, Lesson};
use raybook_grader::serve::{Answer, Request, Server};
use std::sync::Arc;

/// The options of `raybook present`.
#[derive(clap::Args)]
pub struct Present {
    #[command(flatten)]
    options: Options,
    /// The port on this machine; 0 is any that is free
    #[arg(long, default_value = "0")]
    port: u16,
    /// Only print the address, and open no browser
    #[arg(long)]
    no_open: bool,
    /// The chapter to begin with (3, ch03, sphere)
    #[arg(long, default_value = "ch01")]
    chapter: String,
}

/// The page, which asks for all else.
const PAGE: &str = include_str!("page.html");
const SCRIPT: &str = include_str!("page.js");

impl Present {
    /// Serves the pages until the command is interrupted.
    pub fn run(&self) -> Done {
        let first = chapter(&self.chapter).map_err(|error| format!("--chapter {error}"))?;
        let server = Server::new(self.port).map_err(|error| {
            format!(
                "--port {}: {error}; without --port, any port that is free",
                self.port
            )
        })?;
        let address = format!("{}#{}", server.address(), first.name);
        say(format!(
            "Open {address}\nKeys: ← → step, b black, f full screen, k knobs, ? all keys. Ctrl-C ends it."
        ));
        if !self.no_open {
            browser::open(&address);
        }
        let studio = Arc::new(Studio::new(self.options.clone()));
        server.run(move |request| answer(&studio, request));
        Ok(true)
    }
}

fn answer(studio: &Arc<Studio>, request: &Request) -> Answer {
    let parts: Vec<_> = request.path.split('/').collect();
    match parts[..] {
        [""] => Answer::page(PAGE, SCRIPT),
        ["course.json"] => Answer::json(&screens::course()),
        ["progress.json"] => studio.progress(),
        ["screens", chapter] => of(chapter, |lesson| studio.screens(lesson, &request.query)),
        ["picture", chapter, name] => of(chapter, |lesson| {
            studio.picture(lesson, name, &request.query)
        }),
        _ => Answer::unknown(),
    }
}

/// What is answered about a chapter, if there is one of this name.
fn of(chapter: &str, answer: impl FnOnce(&'static Lesson) -> Answer) -> Answer {
    lesson::find(chapter).map_or_else(Answer::unknown, answer)
}
