//! `raybook render`: the picture of a scene file.

mod preview;

use super::{Done, tell_new_folder};
use raybook::image::Image;
use raybook::image::file::{self, FileError};
use raybook::render::film::{self, Film, Progress};
use raybook_chapters::kit::options::{WIDEST, seed};
use raybook_chapters::kit::say::{complain, say};
use raybook_chapters::kit::stage::progress_bar;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_scenes::{Shot, wrong::TextError};
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

/// The options of `raybook render`.
#[derive(clap::Args)]
pub struct Render {
    /// The scene file; the book's page "Scene files" describes what is in it
    scene: PathBuf,
    /// The picture: .png as a display shows it, .exr or .hdr with its radiance
    #[arg(long, default_value = "picture.png")]
    out: PathBuf,
    /// Width of the picture in pixels; the height follows [default: what the file says]
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=i64::from(WIDEST)))]
    width: Option<u32>,
    /// Samples per pixel [default: what the file says]
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    samples: Option<u32>,
    /// The seed of all random numbers [default: what the file says]
    #[arg(long, value_parser = seed)]
    seed: Option<u64>,
    /// The number of threads; the picture does not depend on it [default: one per core]
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=1024))]
    threads: Option<u32>,
    /// Show the picture while it becomes better, and draw it again whenever the scene file is saved
    #[arg(long, value_enum, num_args = 0..=1, require_equals = true, default_missing_value = "page")]
    preview: Option<View>,
    /// The port of the preview's page on this machine; 0 is any that is free
    #[arg(long, default_value = "0", requires = "preview")]
    port: u16,
}

/// Where a preview is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum View {
    /// A page of this machine only, at an address that is told
    Page,
    /// The terminal, if it has 24-bit colours
    Terminal,
}

impl Render {
    /// Reads the scene, draws it and writes the picture.
    pub fn run(&self) -> Done {
        file::expect_name(&self.out)?; // before the work, not after it
        tell_new_folder(&self.out);
        if let Some(view) = self.preview {
            return preview::run(self, view);
        }
        let shot = self.load()?;
        remarks(&shot).iter().for_each(complain);
        let (bar, rays) = (progress_bar(), AtomicU64::new(0));
        bar.set_prefix("render");
        bar.set_length((shot.picture.width * shot.picture.height) as u64);
        let progress = |done: film::Done| {
            bar.inc(done.pixels as u64);
            rays.fetch_add(done.rays, Ordering::Relaxed);
            ControlFlow::Continue(())
        };
        let begun = Instant::now();
        let radiance = shot.render(&self.film(&shot, &progress));
        bar.finish_and_clear();
        let written = self.write(&shot, &radiance, rays.into_inner())?;
        say(format!("{written}, {:.1} s", begun.elapsed().as_secs_f32()));
        Ok(true)
    }

    /// The scene.
    fn load(&self) -> Result<Shot, TextError> {
        raybook_scenes::load(&self.scene, self.width.map(|width| width as usize))
    }

    /// Samples per pixel.
    fn samples(&self, shot: &Shot) -> usize {
        self.samples.map_or(shot.picture.samples, |n| n as usize)
    }

    /// What the picture is taken on.
    fn film<'a>(&self, shot: &Shot, progress: &'a Progress<'a>) -> Film<'a> {
        let usual = Film::new(shot.picture.width, shot.picture.height, self.samples(shot));
        Film {
            seed: self.seed.unwrap_or(shot.picture.seed),
            threads: self.threads.map_or(usual.threads, |n| n as usize),
            progress,
            ..usual
        }
    }

    /// Writes the picture, and returns a sentence about it.
    fn write(&self, shot: &Shot, radiance: &Image, rays: u64) -> Result<String, FileError> {
        let is_png = self
            .out
            .extension()
            .is_some_and(|e| e.eq_ignore_ascii_case("png"));
        let shown = is_png.then(|| shot.picture.developed(radiance));
        file::save(&self.out, shown.as_ref().unwrap_or(radiance))?;
        Ok(format!(
            "wrote {}: {} × {} pixels, {} samples, {:.1} million rays",
            Untrusted::from(self.out.as_path()),
            radiance.width(),
            radiance.height(),
            self.samples(shot),
            rays as f64 / 1e6,
        ))
    }
}

/// What is to be said of the scene's files.
fn remarks(shot: &Shot) -> Vec<String> {
    let remark = |remark: &String| format!("remark: {}", Untrusted::from(&**remark));
    shot.remarks.iter().map(remark).collect()
}
