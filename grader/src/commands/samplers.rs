//! `raybook samplers`: the sampling lab.

use super::Done;
use super::asking::Asking;
use raybook::sample::pattern::{PATTERNS, Pattern, find};
use raybook_chapters::kit::say::say;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_chapters::lab::run;
use raybook_chapters::lab::settings::Settings;
use raybook_chapters::lab::steps::Steps;
use raybook_chapters::lab::subject::Subject;
use raybook_grader::converse::Program;
use raybook_grader::library;
use raybook_grader::patterns::ask::ask;
use raybook_grader::patterns::got::{Got, Wanted};
use raybook_grader::patterns::{OWN_PATTERNS, OwnPattern};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// The patterns that are compared if none are named: as many as there are colours.
const USUAL: &str =
    "regular-grid,rotated-grid,random,jittered,multi-jittered,poisson-disk,sobol-owen";

/// How long a program is asked for one pattern.
const PATIENCE: Duration = Duration::from_secs(20);

/// The options of `raybook samplers`.
#[derive(clap::Args)]
pub struct Samplers {
    /// The patterns to compare, or `all`; usually the lecture's and two more, with a program those that it can have
    #[arg(long, value_delimiter = ',')]
    patterns: Vec<String>,
    /// Points in the point sets, the spectra and the table
    #[arg(long, default_value_t = 256, value_parser = clap::value_parser!(u32).range(1..=4096))]
    points: u32,
    /// Samples per pixel of the pictures and of the polar plots
    #[arg(long, value_delimiter = ',', default_value = "1,4,16", value_parser = clap::value_parser!(u32).range(1..=1024))]
    samples: Vec<u32>,
    /// How often each random pattern is drawn
    #[arg(long, default_value_t = 100, value_parser = clap::value_parser!(u64).range(2..=100_000))]
    realisations: u64,
    /// Width of each of the pictures in pixels
    #[arg(long, default_value_t = 240, value_parser = clap::value_parser!(u32).range(8..=2048))]
    width: u32,
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
        let whole = |n: &u32| *n as usize;
        let mut settings = Settings {
            subjects: self.chosen()?,
            remarks: Vec::new(),
            points: whole(&self.points),
            samples: self.samples.iter().map(whole).collect(),
            realisations: self.realisations,
            width: whole(&self.width),
            folder: self.out.clone(),
        };
        let mut right = true;
        if self.asking.program.is_some() {
            let (program, _) = self.asking.program(Path::new("."), Vec::new())?;
            right = self.ask(&program, &mut settings)?;
        }
        let page = run::run(&settings)?;
        settings.remarks.iter().for_each(say);
        say(format!(
            "the sampling lab in {:.1} s; look at {}",
            start.elapsed().as_secs_f32(),
            Untrusted::from(page.as_path())
        ));
        Ok(right)
    }

    fn chosen(&self) -> Result<Vec<Subject>, String> {
        let named: Vec<_> = self.patterns.iter().map(String::as_str).collect();
        let names = match &named[..] {
            ["all"] => PATTERNS.iter().map(|p| p.name).collect(),
            [] if self.asking.program.is_some() => OWN_PATTERNS.iter().map(|p| p.name).collect(),
            [] => USUAL.split(',').collect(),
            _ => named,
        };
        let known: Vec<_> = PATTERNS.iter().map(|p| p.name).collect();
        let subject = |name: &str| {
            find(name).map(Subject::of).ok_or_else(|| {
                format!(
                    "--patterns {name}: there is no such pattern; there are all, {}",
                    known.join(", ")
                )
            })
        };
        names.into_iter().map(subject).collect()
    }

    /// Puts the program's patterns behind the library's, each behind its own, and says what there is to say; true if all are
    /// there.
    fn ask(&self, program: &Program, settings: &mut Settings) -> Result<bool, Box<dyn Error>> {
        let [needed, further] = Settings::sizes(settings.points, &settings.samples);
        let wanted = Wanted {
            needed,
            further,
            realisations: self.realisations,
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
        for subject in settings.subjects.drain(..) {
            let pattern = subject.pattern;
            let own = of(&subject);
            subjects.push(subject);
            let Some(own) = own else { continue };
            steps.begin(format!("asking for {}", own.exercise));
            let got = ask(program, own, &wanted, self.asking.limits())?;
            right &= got.wrong.is_none();
            settings.remarks.extend(self.remarks(&pattern, own, &got));
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

    /// What there is to say of a program's pattern.
    fn remarks(&self, pattern: &Pattern, own: &OwnPattern, got: &Got) -> Vec<String> {
        let my = format!("my {}", pattern.title);
        let wrong = got.wrong.as_ref().map(|why| {
            let shown = if got.points.is_empty() {
                "it is left out"
            } else {
                "its curves end before"
            };
            let exercise = own.exercise;
            let place = library::place(exercise).unwrap_or_default();
            format!("{my}: {why}; {shown}. In a Rust workbook it is in {place}; `raybook exercise {exercise}` says what it is asked, and `raybook check {exercise}{}` what is wrong.", self.asking.again())
        });
        let more = got.remarks.iter().map(|remark| format!("{my}: {remark}."));
        wrong.into_iter().chain(more).collect()
    }
}
