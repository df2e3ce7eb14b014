//! `raybook render`: the picture of a scene file.

use super::Done;
use raybook::image::file;
use raybook::render::film::{self, Film};
use raybook_chapters::kit::options::WIDEST;
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::stage::progress_bar;
use raybook_chapters::kit::untrusted::Untrusted;
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
    /// What every random number follows from [default: what the file says]
    #[arg(long)]
    seed: Option<u64>,
    /// How many threads draw; the picture does not depend on it [default: one per core]
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=1024))]
    threads: Option<u32>,
}

impl Render {
    /// Reads the scene, draws it and writes the picture.
    pub fn run(&self) -> Done {
        file::expect_name(&self.out)?; // before the work, not after it
        let begun = Instant::now();
        let shot = raybook_scenes::load(&self.scene, self.width.map(|width| width as usize))?;
        let picture = shot.picture;
        let (bar, rays) = (progress_bar(), AtomicU64::new(0));
        bar.set_prefix("render");
        bar.set_length((picture.width * picture.height) as u64);
        let progress = |done: film::Done| {
            bar.inc(done.pixels as u64);
            rays.fetch_add(done.rays, Ordering::Relaxed);
            ControlFlow::Continue(())
        };
        let usual = Film::new(picture.width, picture.height, picture.samples);
        let film = Film {
            samples: self.samples.map_or(usual.samples, |n| n as usize),
            seed: self.seed.unwrap_or(picture.seed),
            threads: self.threads.map_or(usual.threads, |n| n as usize),
            progress: &progress,
            ..usual
        };
        let radiance = shot.render(&film);
        bar.finish_and_clear();
        let is_png = self
            .out
            .extension()
            .is_some_and(|e| e.eq_ignore_ascii_case("png"));
        let shown = is_png.then(|| picture.developed(&radiance));
        file::save(&self.out, shown.as_ref().unwrap_or(&radiance))?;
        say(format!(
            "wrote {}: {} × {} pixels, {} samples, {:.1} million rays, {:.1} s",
            Untrusted::from(self.out.as_path()),
            film.width,
            film.height,
            film.samples,
            rays.into_inner() as f64 / 1e6,
            begun.elapsed().as_secs_f32(),
        ));
        Ok(true)
    }
}
