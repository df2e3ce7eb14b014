//! `raybook samplers`: the sampling lab.

use super::Done;
use super::asking::Asking;
use raybook::sample::pattern::Pattern;
use raybook_chapters::kit::options::seed;
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_chapters::lab::run;
use raybook_chapters::lab::settings::{MOST, Settings, counts};
use raybook_chapters::lab::slide;
use raybook_chapters::lab::steps::Steps;
use raybook_chapters::lab::subject::{Subject, known};
use raybook_grader::converse::Program;
use raybook_grader::patterns::ask::ask;
use raybook_grader::patterns::file;
use raybook_grader::patterns::got::{Got, Wanted};
use raybook_grader::patterns::{OWN_PATTERNS, OwnPattern};
use raybook_grader::student;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// The patterns that are compared if none are named: the lecture's, two more, and the reference.
const USUAL: &str =
    "regular-grid,rotated-grid,random,jittered,multi-jittered,poisson-disk,sobol-owen,blue-noise";

/// How long a program is asked for one pattern.
const PATIENCE: Duration = Duration::from_secs(20);

/// The options of `raybook samplers`.
#[derive(clap::Args)]
#[command(after_help = "Examples:\n  \
    raybook samplers                                    the usual patterns, in out/samplers/index.html\n  \
    raybook samplers --quick --patterns jittered,halton  a first look, in a few seconds\n  \
    raybook samplers --slide                            rotated grid, jittered, Poisson disk on one slide\n  \
    raybook samplers --file my-points.txt               your own points: x and y on each line")]
pub struct Samplers {
    /// The patterns to compare, or `all`; usually the lecture's, two more and a blue-noise reference, with a program those that it can have
    #[arg(long, value_delimiter = ',')]
    patterns: Vec<String>,
    /// Points in the point sets, the spectra and the table
    #[arg(long, default_value = "256", value_parser = clap::value_parser!(u32).range(1..=4096))]
    points: u32,
    /// Samples per pixel of the pictures and of the polar plots
    #[arg(long, value_delimiter = ',', default_value = "1,4,16,64", value_parser = clap::value_parser!(u32).range(1..=1024))]
    samples: Vec<u32>,
    /// How often each random pattern is drawn [default: 100; 20 with --quick]
    #[arg(long, value_parser = clap::value_parser!(u64).range(2..=100_000))]
    realisations: Option<u64>,
    /// Width of each of the pictures in pixels [default: 240; 120 with --quick]
    #[arg(long, value_parser = clap::value_parser!(u32).range(8..=2048))]
    width: Option<u32>,
    /// What the patterns' random numbers follow from; several seeds draw every pattern once for each: --seeds 1,2
    #[arg(
        long,
        value_delimiter = ',',
        default_value = "1",
        visible_alias = "seed",
        value_parser = seed
    )]
    seeds: Vec<u64>,
    /// Fewer realisations, smaller pictures, and errors up to 256 samples: a page in a few seconds
    #[arg(long)]
    quick: bool,
    /// One figure per screen, for a projector: the arrow keys go on and back
    #[arg(long)]
    slides: bool,
    /// Only the comparison of rotated grid, jittered and Poisson disk, on one slide: slide.svg, slide.png and slide.csv
    #[arg(long, conflicts_with_all = ["patterns", "program", "file", "slides"])]
    slide: bool,
    /// Your own points: x and y in [0, 1) on each line, an empty line between sets; a set of n points stands for its first 1, 2, 3 … n points too
    #[arg(long, value_name = "FILE")]
    file: Vec<PathBuf>,
    /// The folder for the page and its figures
    #[arg(long, default_value = "out/samplers")]
    out: PathBuf,
    #[command(flatten)]
    asking: Asking,
}

impl Samplers {
    /// Asks, measures, draws, and writes the page; true if no pattern of the program was wrong.
    pub fn run(&self) -> Done {
        let start = Instant::now();
        let done = |page: &Path| {
            let seconds = start.elapsed().as_secs_f32();
            let page = Untrusted::from(page);
            say(format!(
                "the sampling lab in {seconds:.1} s; look at {page}"
            ));
        };
        let mut settings = self.settings()?;
        if self.slide {
            done(&slide::make(&settings)?);
            return Ok(true);
        }
        let mut right = true;
        if self.asking.program.is_some() {
            let (program, _) = self.asking.program(Path::new("."), Vec::new())?;
            right = self.ask(&program, &mut settings)?;
        }
        for path in &self.file {
            let mut subject = file::read(path, settings.sizes())?;
            // A file may be called like a pattern, or like another file elsewhere.
            while settings
                .subjects
                .iter()
                .any(|other| other.key == subject.key)
            {
                subject = subject.renamed();
            }
            settings.subjects.push(subject);
        }
        let page = run::run(&settings)?;
        settings.remarks.iter().for_each(say);
        done(&page);
        Ok(right)
    }

    fn settings(&self) -> Result<Settings, String> {
        let whole = |n: &u32| *n as usize;
        let [realisations, width, most] = if self.quick {
            [20, 120, 256]
        } else {
            [100, 240, MOST]
        };
        let seeds: Vec<_> = self.seeds.iter().map(u64::to_string).collect();
        let words = std::env::args_os().skip(1);
        let words: Vec<_> = words
            .map(|word| Untrusted::from(Path::new(&word)).shell())
            .collect();
        Ok(Settings {
            subjects: self.chosen()?,
            remarks: Vec::new(),
            points: whole(&self.points),
            samples: self.samples.iter().map(whole).collect(),
            counts: counts(most),
            realisations: self.realisations.unwrap_or(realisations as u64),
            width: self.width.map_or(width, |width| width as usize),
            seed: self.seeds.first().copied().unwrap_or(1),
            seeds: seeds.join(" and "),
            command: format!("raybook {}", words.join(" ")),
            slides: self.slides,
            folder: self.out.clone(),
        })
    }

    fn chosen(&self) -> Result<Vec<Subject>, String> {
        let named: Vec<_> = self.patterns.iter().map(String::as_str).collect();
        let names = match &named[..] {
            ["all"] => known().map(|p| p.name).collect(),
            [] if self.asking.program.is_some() => OWN_PATTERNS.iter().map(|p| p.name).collect(),
            [] => USUAL.split(',').collect(),
            _ => named,
        };
        let all: Vec<_> = known().map(|p| p.name).collect();
        let several = self.seeds.len() > 1;
        let mut subjects = Vec::new();
        for name in names {
            let pattern = known()
                .find(|pattern| pattern.name == name)
                .ok_or_else(|| {
                    format!(
                        "--patterns {name}: there is no such pattern; there are all, {}",
                        all.join(", ")
                    )
                })?;
            let by_seed = |seed: &u64| Subject::of(pattern).by_seed(*seed, several);
            subjects.extend(self.seeds.iter().map(by_seed));
        }
        Ok(subjects)
    }

    /// Puts the program's patterns behind the library's, each behind its own, and says what there is to say; true if all are
    /// there.
    fn ask(&self, program: &Program, settings: &mut Settings) -> Result<bool, Box<dyn Error>> {
        let [needed, further] = settings.sizes();
        let wanted = Wanted {
            needed,
            further,
            realisations: settings.realisations,
            patience: PATIENCE,
        };
        let of = |subject: &Subject| {
            let mut own = OWN_PATTERNS.iter();
            own.find(|own| own.name == subject.pattern.name)
        };
        let count = settings.subjects.iter().filter_map(of).count();
        if count == 0 {
            let exercises = OWN_PATTERNS.map(|own| own.name).join(", ");
            return Err(format!("--program: of these patterns none is an exercise, so that there is none to ask for; exercises are {exercises}").into());
        }
        let (steps, mut right) = (Steps::new(count as u64), true);
        let mut subjects = Vec::new();
        let librarys: Vec<_> = settings.subjects.drain(..).collect();
        for (i, subject) in librarys.iter().enumerate() {
            let pattern = subject.pattern;
            subjects.push(subject.clone());
            let next = librarys.get(i + 1);
            if next.is_some_and(|next| next.pattern.name == pattern.name) {
                continue; // the same by another seed: the program is asked once
            }
            let own = of(subject);
            let Some(own) = own else { continue };
            steps.begin(format!("asking for {}", own.exercise));
            let got = ask(program, own, &wanted, self.asking.limits())?;
            right &= got.wrong.is_none();
            let folder = student::workbook(&program.folder).ok();
            let place = folder.and_then(|folder| student::place(&folder, own.exercise));
            settings
                .remarks
                .extend(self.remarks(&pattern, own, &got, place));
            if !got.points.is_empty() {
                subjects.push(Subject::own(&pattern, got.points));
            }
            steps.done();
        }
        steps.finish();
        if subjects.iter().any(Subject::is_own) {
            let how = "Where there are two curves of a pattern, the broad pale one is the library's, and the thin one is yours.";
            settings.remarks.insert(0, how.to_owned());
        }
        settings.subjects = subjects;
        Ok(right)
    }

    /// What there is to say of a program's pattern, which is written in the file `place` if the program is a workbook's.
    fn remarks(
        &self,
        pattern: &Pattern,
        own: &OwnPattern,
        got: &Got,
        place: Option<String>,
    ) -> Vec<String> {
        let my = format!("my {}", pattern.title);
        let wrong = got.wrong.as_ref().map(|why| {
            let shown = if got.points.is_empty() {
                "it is left out"
            } else {
                "its curves end before"
            };
            let exercise = own.exercise;
            let place = place.map_or_else(String::new, |file| format!("It is written in {file}; "));
            format!("{my}: {why}; {shown}. {place}`raybook exercise {exercise}` says what it is asked, and `raybook check {exercise}{}` what is wrong.", self.asking.again())
        });
        let more = got.remarks.iter().map(|remark| format!("{my}: {remark}."));
        wrong.into_iter().chain(more).collect()
    }
}
