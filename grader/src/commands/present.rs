//! `raybook present`: the course for a projector, a picture per screen, with the knobs of its chapter.
//!
//! A small server for this machine alone. Its address holds a random word, so that no other page can guess it, and what is asked of
//! another host's name is refused, so that no other page can borrow it.

mod drawing;
mod http;
mod screens;

use super::Done;
use drawing::Studio;
use http::{Answer, Request};
use raybook_chapters::kit::options::Options;
use raybook_chapters::kit::say::say;
use raybook_chapters::lesson::{self, Lesson};
use raybook_workbook::curriculum::CHAPTERS;
use std::collections::hash_map::RandomState;
use std::hash::{BuildHasher, Hasher};
use std::net::{Ipv4Addr, TcpListener};
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::thread;

/// The options of `raybook present`.
#[derive(clap::Args)]
pub struct Present {
    #[command(flatten)]
    options: Options,
    /// The port on this machine; 0 is any that is free
    #[arg(long, default_value_t = 0)]
    port: u16,
    /// Only print the address, and open no browser
    #[arg(long)]
    no_open: bool,
    /// The chapter to begin with (3, ch03, sphere)
    #[arg(long, default_value = "ch01")]
    chapter: String,
}

/// The page, which asks for all else.
const PAGE: &str = include_str!("present/page.html");

impl Present {
    /// Serves the pages until the command is interrupted.
    pub fn run(&self) -> Done {
        let first = CHAPTERS
            .iter()
            .find(|chapter| chapter.answers_to(&self.chapter));
        let first = first.ok_or_else(|| {
            let names: Vec<_> = CHAPTERS.iter().map(|chapter| chapter.name).collect();
            format!(
                "--chapter {}: no chapter is called so; there are {}",
                self.chapter,
                names.join(", ")
            )
        })?;
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, self.port)).map_err(|error| {
            format!(
                "--port {}: {error}; without --port, any port that is free",
                self.port
            )
        })?;
        let host = listener.local_addr()?.to_string();
        let site = Arc::new(Site {
            token: random_word(),
            studio: Arc::new(Studio::new(self.options.clone())),
            host,
        });
        let address = format!("http://{}/{}/#{}", site.host, site.token, first.name);
        say(format!(
            "Open {address}\nKeys: ← → step, b black, f full screen, k knobs, ? all keys. Ctrl-C ends it."
        ));
        if !self.no_open {
            open(&address);
        }
        for stream in listener.incoming().flatten() {
            let site = Arc::clone(&site);
            thread::spawn(move || http::serve(stream, |request| site.answer(request)));
        }
        Ok(true)
    }
}

/// What the server knows.
struct Site {
    /// The only name under which it is to be asked: 127.0.0.1 and its port.
    host: String,
    /// The first part of every path.
    token: String,
    studio: Arc<Studio>,
}

impl Site {
    fn answer(&self, request: &Request) -> Answer {
        if request.host != self.host {
            return Answer::refused("this page is on this machine only, and has another name");
        }
        let mut parts = request.path.trim_start_matches('/').splitn(2, '/');
        if parts.next() != Some(&self.token) {
            return Answer::refused("the address is not complete: `raybook present` printed it");
        }
        let rest: Vec<_> = parts.next().unwrap_or_default().split('/').collect();
        match rest[..] {
            [""] => Answer::page(PAGE),
            ["course.json"] => Answer::json(&screens::course()),
            ["screens", chapter] => of(chapter, |lesson| {
                self.studio.screens(lesson, &request.query)
            }),
            ["picture", chapter, name] => of(chapter, |lesson| {
                self.studio.picture(lesson, name, &request.query)
            }),
            _ => Answer::unknown(),
        }
    }
}

/// What is answered about a chapter, if there is one of this name.
fn of(chapter: &str, answer: impl FnOnce(&'static Lesson) -> Answer) -> Answer {
    lesson::find(chapter).map_or_else(Answer::unknown, answer)
}

/// 32 digits that nobody foresees: hashes under keys that the system chose at random.
fn random_word() -> String {
    let half = || RandomState::new().build_hasher().finish();
    format!("{:016x}{:016x}", half(), half())
}

/// Asks the system to show an address; if it cannot, the address is printed.
fn open(address: &str) {
    let program = if cfg!(target_os = "macos") {
        "open"
    } else {
        "xdg-open"
    };
    let mut command = Command::new(program);
    command
        .arg(address)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    // There may be no browser, or no screen: then the printed address is all.
    let _ = command.spawn();
}
