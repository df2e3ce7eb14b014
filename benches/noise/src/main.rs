//! The noise of two programs' pictures at equal processor time. `benches/noise/run` builds the programs and starts this.
//!
//! Each program draws each picture with few samples and with many more, its reference. The error is the RMS difference of the
//! two as a display shows them. Scenes have changed between the commits, so each picture is compared with the reference of its
//! own program. The time is the processor time of all threads until the picture is written, less that of a picture of 8 pixels. Each
//! picture is drawn with several seeds: its time is the median of theirs, and the spread of the errors tells what is chance.

use clap::Parser;
use raybook::image::{Image, file, rms::rms};
use raybook::store;
use raybook_common::machine::{comments, processor};
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
    /// The folder of both clones; noise.csv and equal_time.csv are written there
    #[arg(long, default_value = "target/noise")]
    folder: PathBuf,
    /// Binaries of chapters
    #[arg(required = true)]
    chapters: Vec<String>,
}

/// Samples per pixel of the older commit.
const THEN: u32 = 16;

/// Least samples per pixel of this commit. They are doubled until the time is that of the older one, but not beyond half of the
/// reference's.
const NOW: u32 = 4;

/// The seeds of the pictures.
const SEEDS: [u32; 3] = [1, 2, 3];

/// The seed of the reference.
const REFERENCE_SEED: u32 = 1000;

/// Pictures with one number of samples: the median of their times, in processor-seconds, and the error of each seed's.
#[derive(Clone, Copy)]
struct Point {
    time: f64,
    errors: [f64; SEEDS.len()],
}

fn main() -> Result<(), Box<dyn Error>> {
    let options = Options::parse();
    let how = [
        processor(),
        format!(
            "pictures {} pixels wide, of {} seeds each: error is the median, least and most are of them all; references of {} samples per pixel",
            options.width,
            SEEDS.len(),
            options.reference
        ),
    ];
    let mut csv = comments(&how) + "chapter,commit,samples,seconds,error,error_least,error_most\n";
    let mut equal_time =
        comments(&how) + "chapter,seconds,error_then,error_now,ratio,ratio_least,ratio_most\n";
    println!(
        "{}chapter, seconds, error then, error now, ratio",
        comments(&how)
    );
    for chapter in &options.chapters {
        let then = Subject::new("then", chapter, &options)?;
        let now = Subject::new("now", chapter, &options)?;
        let mut record = |subject: &Subject, samples| {
            let point = subject.point(samples)?;
            let (name, time) = (subject.name, point.time);
            let [least, error, most] = sorted(point.errors);
            writeln!(
                csv,
                "{chapter},{name},{samples},{time:.2},{error:.5},{least:.5},{most:.5}"
            )?;
            Ok::<_, Box<dyn Error>>(point)
        };
        let then = record(&then, THEN)?;
        let mut curve = vec![record(&now, NOW)?];
        let mut samples = NOW;
        while curve.len() < 2 || curve[curve.len() - 1].time < then.time {
            samples *= 2;
            if samples > options.reference / 2 {
                break;
            }
            curve.push(record(&now, samples)?);
        }
        let now = errors_at(&curve, then.time);
        let ratios = std::array::from_fn(|seed| now[seed] / then.errors[seed]);
        let ([_, before, _], [_, now, _]) = (sorted(then.errors), sorted(now));
        let [least, ratio, most] = sorted(ratios);
        println!(
            "{chapter}, {:.2}, {before:.4}, {now:.4}, {ratio:.2} [{least:.2}–{most:.2}]",
            then.time
        );
        writeln!(
            equal_time,
            "{chapter},{:.2},{before:.5},{now:.5},{ratio:.3},{least:.3},{most:.3}",
            then.time
        )?;
        for (file, text) in [("noise.csv", &csv), ("equal_time.csv", &equal_time)] {
            store::write(&options.folder.join(file), text.as_bytes())?;
        }
    }
    Ok(())
}

/// One commit's binary of a chapter.
struct Subject {
    name: &'static str,
    program: PathBuf,
    width: u32,
    reference: Image,
    /// The time of a picture of 8 pixels.
    start: f64,
}

impl Subject {
    fn new(name: &'static str, chapter: &str, options: &Options) -> Result<Self, Box<dyn Error>> {
        let program = options
            .folder
            .join(name)
            .join("target/release")
            .join(chapter);
        let (_, reference) = draw(&program, options.width, options.reference, REFERENCE_SEED)?;
        let (start, _) = draw(&program, 8, 1, 1)?;
        Ok(Self {
            name,
            program,
            width: options.width,
            reference,
            start,
        })
    }

    fn point(&self, samples: u32) -> Result<Point, Box<dyn Error>> {
        let (mut times, mut errors) = ([0.0; SEEDS.len()], [0.0; SEEDS.len()]);
        for (i, seed) in SEEDS.into_iter().enumerate() {
            let (time, picture) = draw(&self.program, self.width, samples, seed)?;
            times[i] = (time - self.start).max(TICK);
            errors[i] = rms(&self.reference, &picture, |_, _| true).into();
        }
        let [_, time, _] = sorted(times);
        Ok(Point { time, errors })
    }
}

/// The least, the median and the greatest.
fn sorted(mut numbers: [f64; SEEDS.len()]) -> [f64; SEEDS.len()] {
    numbers.sort_by(f64::total_cmp);
    numbers
}

/// The error of each seed after `time`, in processor-seconds: on the straight line through the curve's last two points, both axes
/// logarithmic; that of the last point, if its own time is less.
fn errors_at(curve: &[Point], time: f64) -> [f64; SEEDS.len()] {
    match *curve {
        [.., a, b] if a.time < b.time => {
            let along = (time / a.time).ln() / (b.time / a.time).ln();
            let ratio = |seed: usize| b.errors[seed] / a.errors[seed];
            std::array::from_fn(|seed| a.errors[seed] * ratio(seed).powf(along.clamp(0.0, 1.0)))
        }
        [.., b] => b.errors,
        [] => [f64::NAN; SEEDS.len()],
    }
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
