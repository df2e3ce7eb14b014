//! The noise of two programs' pictures at equal processor time. `benches/noise/run` builds the programs and starts this.
//!
//! Each program draws each picture with few samples and with many more, its reference. The error is the RMS difference of the
//! two as a display shows them. Scenes have changed between the commits, so each picture is compared with the reference of its
//! own program. The time is the processor time of all threads until the picture is written, less that of a picture of 8 pixels.

use clap::Parser;
use raybook::image::{Image, file, rms::rms};
use raybook::store;
use std::error::Error;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

/// Compares the noise of two programs' pictures at equal time
#[derive(Parser)]
struct Options {
    /// Width of the pictures, in pixels
    #[arg(long, default_value_t = 240)]
    width: u32,
    /// Samples per pixel of the reference
    #[arg(long, default_value_t = 1024)]
    reference: u32,
    /// The folder of both clones; noise.csv is written there
    #[arg(long, default_value = "target/noise")]
    folder: PathBuf,
    /// Binaries of chapters
    #[arg(required = true)]
    chapters: Vec<String>,
}

/// Samples per pixel.
const SAMPLES: [u32; 4] = [4, 8, 16, 32];

/// The seed of the reference; that of the others is 1.
const REFERENCE_SEED: u32 = 1000;

/// The time, in processor-seconds, and the error of a picture.
#[derive(Clone, Copy)]
struct Point {
    time: f64,
    error: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let options = Options::parse();
    let mut csv = String::from("chapter,commit,samples,seconds,error\n");
    println!("chapter, seconds, error then, error now, ratio");
    for chapter in &options.chapters {
        let mut curves = vec![];
        for name in ["then", "now"] {
            let program = options
                .folder
                .join(name)
                .join("target/release")
                .join(chapter);
            let draw = |width, samples, seed| draw(&program, width, samples, seed);
            let (_, reference) = draw(options.width, options.reference, REFERENCE_SEED)?;
            let (start, _) = draw(8, 1, 1)?;
            let mut curve = vec![];
            for samples in SAMPLES {
                let (time, picture) = draw(options.width, samples, 1)?;
                let error = f64::from(rms(&reference, &picture, |_, _| true));
                let time = (time - start).max(TICK);
                writeln!(csv, "{chapter},{name},{samples},{time:.2},{error:.5}")?;
                curve.push(Point { time, error });
            }
            curves.push(curve);
        }
        let then = curves[0][SAMPLES.len() / 2];
        let now = error_at(&curves[1], then.time);
        let ratio = now / then.error;
        println!(
            "{chapter}, {:.2}, {:.4}, {now:.4}, {ratio:.2}",
            then.time, then.error
        );
        store::write(&options.folder.join("noise.csv"), csv.as_bytes())?;
    }
    Ok(())
}

/// The error after so much time: on the straight line through the two nearest points, both axes logarithmic.
fn error_at(curve: &[Point], time: f64) -> f64 {
    let after = curve.iter().position(|point| point.time > time);
    let i = after.unwrap_or(curve.len() - 1).max(1);
    let [a, b] = [curve[i - 1], curve[i]];
    let along = (time / a.time).ln() / (b.time / a.time).ln();
    a.error * (b.error / a.error).powf(along)
}

/// The shortest time that the system counts, in seconds.
const TICK: f64 = 0.01;

/// The processor time of a picture, and the picture. The program is stopped after it, before its other figures.
fn draw(
    program: &Path,
    width: u32,
    samples: u32,
    seed: u32,
) -> Result<(f64, Image), Box<dyn Error>> {
    let folder = tempfile::tempdir()?;
    let chapter = program.file_name().ok_or("a chapter's binary has a name")?;
    let picture = folder.path().join(chapter).join("picture");
    let numbers = [("--width", width), ("--samples", samples), ("--seed", seed)];
    let mut child = Command::new(program)
        .args(numbers.map(|(name, value)| format!("{name}={value}")))
        .arg("--out")
        .arg(folder.path())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()?;
    let drawn = wait(&mut child, &picture.with_extension("png"));
    child.kill()?;
    child.wait()?;
    Ok((drawn?, file::load(&picture.with_extension("exr"))?))
}

/// Waits until a program has written a file; returns its processor time.
fn wait(child: &mut Child, file: &Path) -> Result<f64, Box<dyn Error>> {
    loop {
        let time = processor_time(child.id())?;
        if file.exists() {
            return Ok(time);
        }
        if let Some(status) = child.try_wait()? {
            return Err(format!("the chapter ended without a picture: {status}").into());
        }
        sleep(Duration::from_millis(5));
    }
}

/// Processor time of a process, in seconds: fields 14 and 15 of its `stat` (proc(5)), after a name that ends with `)`.
fn processor_time(process: u32) -> Result<f64, Box<dyn Error>> {
    let stat = std::fs::read_to_string(format!("/proc/{process}/stat"))?;
    let (_, fields) = stat.rsplit_once(") ").ok_or("no end of the name")?;
    let mut fields = fields.split(' ').skip(11);
    let mut ticks = || fields.next().and_then(|field| field.parse::<u64>().ok());
    let (user, system) = ticks().zip(ticks()).ok_or("no times")?;
    Ok((user + system) as f64 / rustix::param::clock_ticks_per_second() as f64)
}
