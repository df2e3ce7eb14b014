//! The stage on which a chapter draws: its films, its progress, and where its pictures go.

use crate::kit::{
    figure::{Diagram, Figure},
    options::Options,
    rate::Rate,
    terminal,
};
use indicatif::{ProgressBar, ProgressStyle};
use raybook::image::{Image, file};
use raybook::render::film::{Done, Film, Progress};
use raybook::store;
use std::cell::RefCell;
use std::error::Error;
use std::fmt;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// What drawing a chapter returns.
pub type Drawn = Result<(), Box<dyn Error>>;

/// A picture that a chapter drew.
#[derive(Clone, Debug)]
pub struct Output {
    /// The PNG.
    pub png: PathBuf,
    /// The EXR with linear radiance, if the picture has any.
    pub exr: Option<PathBuf>,
    /// The SVG, if the picture is a drawing.
    pub svg: Option<PathBuf>,
    /// Its width and height, in pixels.
    pub size: (usize, usize),
    /// What it shows, in a sentence or two.
    pub caption: String,
    /// Rays per second that were followed for it, if a scene was followed.
    pub rays: Option<f64>,
}

/// Where one chapter draws its pictures.
pub struct Stage {
    options: Options,
    folder: PathBuf,
    show: bool,
    advance: Box<Progress<'static>>,
    bar: ProgressBar,
    rate: Arc<Rate>,
    outputs: Arc<Mutex<Vec<Output>>>,
    /// The pictures that the chapter has come to.
    passed: RefCell<Vec<String>>,
    last: Option<String>,
    stopped: Arc<AtomicBool>,
}

/// The end of a chapter before its last picture: everything that is wanted is drawn, or nothing is wanted any more. This is no
/// fault.
#[derive(Debug)]
pub struct Enough;

impl fmt::Display for Enough {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("the rest is not wanted")
    }
}

impl Error for Enough {}

impl fmt::Debug for Stage {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Stage")
            .field("options", &self.options)
            .field("folder", &self.folder)
            .finish_non_exhaustive()
    }
}

impl Stage {
    /// The stage of the chapter whose binary has this name; `bar` shows how far it is.
    pub fn new(chapter: &str, options: Options, show: bool, bar: ProgressBar) -> Self {
        bar.set_prefix(chapter.to_owned());
        let rate = Arc::new(Rate::default());
        let stopped = Arc::new(AtomicBool::new(false));
        let advance = Box::new({
            let (bar, rate, stopped) = (bar.clone(), Arc::clone(&rate), Arc::clone(&stopped));
            move |done: Done| {
                rate.done(done.rays);
                bar.inc(done.pixels as u64);
                if stopped.load(Ordering::Relaxed) {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            }
        });
        Self {
            folder: options.out.join(chapter),
            options,
            show,
            advance,
            bar,
            rate,
            outputs: Arc::default(),
            passed: RefCell::default(),
            last: None,
            stopped,
        }
    }

    /// The same, with its pictures in this folder.
    #[must_use]
    pub fn in_folder(self, folder: PathBuf) -> Self {
        Self { folder, ..self }
    }

    /// The same, where only the picture of this name is wanted, and drawing ends after it.
    #[must_use]
    pub fn until(self, name: &str) -> Self {
        let last = Some(name.to_owned());
        Self { last, ..self }
    }

    /// The same, where films rest between two rows of pixels as long as another thread holds this lock.
    #[must_use]
    pub fn resting(self, while_held: Arc<Mutex<()>>) -> Self {
        let advance = self.advance;
        let advance = Box::new(move |done: Done| {
            drop(lock(&while_held));
            advance(done)
        });
        Self { advance, ..self }
    }

    /// Whether this picture is to be drawn: true, unless drawing ends after another picture, or was stopped. A chapter asks before
    /// each of its pictures.
    pub fn wants(&self, name: &str) -> bool {
        self.passed.borrow_mut().push(name.to_owned());
        let is_the_last = self.last.as_deref().is_none_or(|last| last == name);
        is_the_last && self.go_on().is_ok()
    }

    /// The names of the pictures that the chapter has come to, drawn or not.
    pub fn passed(&self) -> Vec<String> {
        let mut names = self.passed.borrow().clone();
        names.dedup();
        names
    }

    /// A flag that stops the drawing from another thread as soon as it is true: the film within 16 pixels, the chapter at
    /// its next picture.
    pub fn stopper(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.stopped)
    }

    /// A film of the size and the samples that the options ask for; `aspect` is its width over its height.
    pub fn film(&self, aspect: f32) -> Film<'_> {
        self.film_of(960, 16, aspect)
    }

    /// As [`Stage::film`], for a chapter whose pictures take longer: with its own default width and samples.
    pub fn film_of(&self, width: u32, samples: u32, aspect: f32) -> Film<'_> {
        let width = self.options.width.unwrap_or(width) as usize;
        let height = ((width as f32 / aspect).round() as usize).max(1);
        let samples = self.options.samples.unwrap_or(samples) as usize;
        let film = Film {
            seed: self.options.seed,
            threads: self.options.threads(),
            progress: &*self.advance,
            ..Film::new(width, height, samples)
        };
        self.bar.inc_length((film.width * film.height) as u64);
        film
    }

    /// The folder that holds the chapter's pictures.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// As [`Stage::film`], for one of several tiles side by side: a sheet of them is about as wide as a picture.
    pub fn tile(&self, columns: u32, aspect: f32) -> Film<'_> {
        let mut film = self.film(aspect);
        film.width = (film.width / columns as usize).max(1);
        film.height = ((film.width as f32 / aspect).round() as usize).max(1);
        film
    }

    /// Writes a picture of radiance: `name.exr` keeps it, `name.png` clamps it to what a display shows.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn picture(&self, name: &str, caption: &str, radiance: &Image) -> Drawn {
        self.developed(name, caption, radiance, radiance)
    }

    /// As [`Stage::picture`], but `name.png` is made of `shown`, not of the radiance.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn developed(&self, name: &str, caption: &str, radiance: &Image, shown: &Image) -> Drawn {
        self.write(name, caption, shown, || {
            let exr = self.folder.join(name).with_extension("exr");
            file::save(&exr, radiance)?;
            Ok((Some(exr), None))
        })
    }

    /// Writes a figure, which is made for the display only: `name.png`.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn figure(&self, name: &str, caption: &str, figure: &Image) -> Drawn {
        self.write(name, caption, figure, || Ok((None, None)))
    }

    /// Writes a drawing: `name.svg`, sharp at every size, and `name.png` for where pixels are needed.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn diagram(&self, name: &str, caption: &str, diagram: &Diagram) -> Drawn {
        self.write(name, caption, &diagram.pixels, || {
            let svg = self.folder.join(name).with_extension("svg");
            store::write(&svg, diagram.svg.as_bytes())?;
            Ok((None, Some(svg)))
        })
    }

    /// Draws this drawing and writes it, if it is wanted.
    ///
    /// # Errors
    /// If it cannot be drawn, or a file cannot be written.
    pub fn drawing(&self, name: &str, caption: &str, draw: impl FnOnce() -> Figure) -> Drawn {
        if self.wants(name) {
            self.diagram(name, caption, &draw()?)?;
        }
        Ok(())
    }

    /// What has been drawn.
    pub fn into_outputs(self) -> Vec<Output> {
        self.bar.finish();
        lock(&self.outputs).clone()
    }

    /// The list of the pictures that are finished, for another thread: the stage appends to it.
    pub fn outputs(&self) -> Arc<Mutex<Vec<Output>>> {
        Arc::clone(&self.outputs)
    }

    /// A picture that was stopped is black in places: it is not written.
    fn go_on(&self) -> Result<(), Enough> {
        if self.stopped.load(Ordering::Relaxed) {
            return Err(Enough);
        }
        Ok(())
    }

    /// Writes a picture, and adds it to the list; `beside` writes the EXR or the SVG, and returns their names.
    fn write(
        &self,
        name: &str,
        caption: &str,
        picture: &Image,
        beside: impl FnOnce() -> Result<(Option<PathBuf>, Option<PathBuf>), Box<dyn Error>>,
    ) -> Drawn {
        self.go_on()?;
        let (exr, svg) = beside()?;
        let rays = self.rate.take(self.options.threads());
        let png = self.folder.join(name).with_extension("png");
        file::save(&png, picture)?;
        if self.show {
            self.bar.suspend(|| terminal::print(picture))?;
        }
        lock(&self.outputs).push(Output {
            png,
            exr,
            svg,
            size: (picture.width(), picture.height()),
            caption: caption.to_owned(),
            rays,
        });
        if self.last.as_deref() == Some(name) {
            return Err(Enough.into());
        }
        Ok(())
    }
}

/// Locks a mutex, also after a drawing that panicked: what it has left behind is still valid.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The progress bar of one chapter; invisible if standard error is not a terminal.
pub fn progress_bar() -> ProgressBar {
    let style = ProgressStyle::with_template("{prefix:<16} {bar:32} {percent:>3} %  {elapsed}")
        .unwrap_or_else(|_| ProgressStyle::default_bar());
    ProgressBar::new(0).with_style(style)
}
