//! `raybook render --preview`: the picture while it becomes better, and again whenever the scene file is saved.

use super::{Render, View, remarks};
use crate::commands::Done;
use raybook::image::{Image, file};
use raybook::render::film;
use raybook_chapters::kit::say::{complain, error_text, report, say};
use raybook_chapters::kit::terminal;
use raybook_grader::keys::{self, Pressed};
use raybook_grader::mutex::lock;
use raybook_grader::serve::{Answer, Request, Server};
use raybook_scenes::Shot;
use serde_json::json;
use std::error::Error;
use std::fs;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, SystemTime};

/// How often the scene file is looked at, and how long it must stay the same after a save.
const PAUSE: Duration = Duration::from_millis(250);

/// How many times narrower the first picture is, with one sample per pixel.
const COARSE: usize = 4;

/// How many times the samples of the one before a picture has: all that come before the last take a third of its time.
const MORE: usize = 4;

/// The page, which asks for all else.
const PAGE: &str = include_str!("page.html");
const SCRIPT: &str = include_str!("page.js");

/// What the page shows.
#[derive(Default)]
struct Shown {
    /// The latest picture, as a PNG file; it stays while the scene is wrong.
    png: Vec<u8>,
    /// How many pictures there have been.
    number: u64,
    /// The width of the last one, in pixels: all are shown as large.
    width: usize,
    /// What is to be said of the picture.
    says: String,
    /// What is to be said of the scene's files.
    remarks: Vec<String>,
    /// What is wrong with the scene.
    error: Option<String>,
}

/// Draws again and again, until it is told to quit.
pub(super) fn run(render: &Render, view: View) -> Done {
    let easel = Easel {
        render,
        view,
        shown: Arc::default(),
    };
    let address = match view {
        View::Page => Some(serve(render.port, &easel.shown)?),
        View::Terminal => match terminal::colourless() {
            Some(why) => {
                return Err(
                    format!("--preview=terminal: {why}; --preview=page shows a page").into(),
                );
            }
            None => None,
        },
    };
    if let Some(address) = address {
        say(format!("Open {address}\n{}", how_on()));
    }
    loop {
        let (drawn, stopped) = (Stamp::of(&render.scene), AtomicBool::new(false));
        let quit = thread::scope(|scope| {
            scope.spawn(|| {
                if let Err(error) = easel.draw(&stopped) {
                    easel.fail(&*error);
                }
            });
            let quit = wait(&render.scene, drawn);
            stopped.store(true, Ordering::Relaxed);
            quit
        });
        if quit {
            return Ok(true);
        }
    }
}

/// What can be done.
fn how_on() -> String {
    let keys = if keys::are_there() {
        "q quits"
    } else {
        "Ctrl-C ends"
    };
    format!("Save the scene file to draw again; {keys}.")
}

/// Waits until the file is another one than it was, or for the key that quits; says whether it was the key.
fn wait(scene: &Path, drawn: Stamp) -> bool {
    let mut before = drawn;
    loop {
        if let Pressed::Key('q') | Pressed::Closed = keys::wait(PAUSE) {
            return true;
        }
        // Editors write a file in several steps: all of it is one change.
        let now = Stamp::of(scene);
        if now != drawn && now == before {
            return false;
        }
        before = now;
    }
}

/// When a file was written, and its length; nothing if it is not there.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Stamp(Option<(SystemTime, u64)>);

impl Stamp {
    fn of(file: &Path) -> Self {
        let about = fs::metadata(file).ok();
        Self(about.and_then(|about| Some((about.modified().ok()?, about.len()))))
    }
}

/// Where the pictures are drawn and shown.
struct Easel<'a> {
    render: &'a Render,
    view: View,
    shown: Arc<Mutex<Shown>>,
}

impl Easel<'_> {
    /// Draws the scene as the file is now: coarse, then better and better, and at last the picture that is written.
    fn draw(&self, stopped: &AtomicBool) -> Result<(), Box<dyn Error>> {
        let shot = self.render.load()?;
        if self.view == View::Page {
            remarks(&shot).iter().for_each(complain);
        }
        let all = self.render.samples(&shot);
        let coarse = [(COARSE, 1)].into_iter().filter(|_| all > 1);
        let finer = (0..).map(|i| (1, MORE.pow(i)));
        for (size, samples) in coarse.chain(finer.take_while(|(_, samples)| *samples < all)) {
            let Some((picture, _)) = self.pass(&shot, size, samples, stopped) else {
                return Ok(());
            };
            let says = format!("{samples} of {all} samples per pixel");
            self.show(&shot, &picture, says)?;
        }
        let Some((picture, rays)) = self.pass(&shot, 1, all, stopped) else {
            return Ok(());
        };
        let written = self.render.write(&shot, &picture, rays)?;
        self.show(&shot, &picture, written)
    }

    /// The radiance of a picture and its rays; `None` if it was stopped.
    fn pass(
        &self,
        shot: &Shot,
        smaller: usize,
        samples: usize,
        stopped: &AtomicBool,
    ) -> Option<(Image, u64)> {
        let rays = AtomicU64::new(0);
        let progress = |done: film::Done| {
            rays.fetch_add(done.rays, Ordering::Relaxed);
            if stopped.load(Ordering::Relaxed) {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        };
        let mut film = self.render.film(shot, &progress);
        film.width = film.width.div_ceil(smaller);
        film.height = film.height.div_ceil(smaller);
        film.samples = samples;
        let picture = shot.render(&film);
        (!stopped.load(Ordering::Relaxed)).then_some((picture, rays.into_inner()))
    }

    /// Shows a picture, as a display does.
    fn show(&self, shot: &Shot, radiance: &Image, says: String) -> Result<(), Box<dyn Error>> {
        let picture = &shot.picture.developed(radiance);
        if self.view == View::Terminal {
            say("\x1b[H\x1b[2J");
            terminal::print(picture)?;
            say(format!("{says}. {}", how_on()));
            // The picture has wiped away what was said before.
            remarks(shot).iter().for_each(complain);
            return Ok(());
        }
        let png = file::to_png(picture)?;
        let mut shown = lock(&self.shown);
        let number = shown.number + 1;
        *shown = Shown {
            png,
            number,
            width: shot.picture.width,
            says,
            remarks: remarks(shot),
            error: None,
        };
        Ok(())
    }

    /// Says what is wrong. The picture stays.
    fn fail(&self, error: &dyn Error) {
        report(error);
        lock(&self.shown).error = Some(error_text(error));
    }
}

/// Serves the page until the command ends; returns its address.
fn serve(port: u16, shown: &Arc<Mutex<Shown>>) -> Result<String, String> {
    let server = Server::new(port).map_err(|error| {
        format!("--port {port}: {error}; without --port, any port that is free")
    })?;
    let (address, shown) = (server.address(), Arc::clone(shown));
    thread::spawn(move || server.run(move |request| answer(&lock(&shown), request)));
    Ok(address)
}

fn answer(shown: &Shown, request: &Request) -> Answer {
    match request.path.as_str() {
        "" => Answer::page(PAGE, SCRIPT),
        "state.json" => {
            let Shown {
                number,
                width,
                says,
                remarks,
                error,
                ..
            } = shown;
            Answer::json(
                &json!({ "number": number, "width": width, "says": says, "remarks": remarks.join("\n"), "error": error }),
            )
        }
        "picture.png" if shown.number > 0 => Answer::png(shown.png.clone()),
        _ => Answer::unknown(),
    }
}
