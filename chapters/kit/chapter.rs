//! The `main` of every chapter binary.

use crate::kit::knobs::{self, Kind, Knob};
use crate::kit::options::Options;
use crate::kit::say::{complain, report, said_all, say};
use crate::kit::stage::{Drawn, Output, Stage, progress_bar};
use crate::kit::terminal::colourless;
use crate::kit::untrusted::Untrusted;
use crate::kit::vary::{self, Vary};
use crate::lesson::{self, Lesson};
use clap::{Arg, ArgAction, Args, Command, FromArgMatches};
use raybook_workbook::answer::unwritten;
use std::env;
use std::error::Error;
use std::ffi::OsString;
use std::panic;
use std::process::ExitCode;
use std::sync::Mutex;

/// The options of every chapter beside its knobs.
#[derive(Args)]
struct Shared {
    #[command(flatten)]
    options: Options,
    /// Draw the pictures in the terminal too, if standard output is a terminal with colours
    #[arg(long)]
    show: bool,
    #[command(flatten)]
    vary: Vary,
}

/// The `main` of a chapter binary: parses the options, draws, and says what was written.
pub fn run(chapter: &str) -> ExitCode {
    end_at_what_is_unwritten();
    let words: Vec<_> = env::args_os().skip(1).collect();
    match draw_as(chapter, chapter, &words) {
        Ok(()) => said_all(ExitCode::SUCCESS),
        Err(error) => {
            report(&*error);
            ExitCode::from(2)
        }
    }
}

/// Draws what these words of a command line ask for, and says what was written; `called` is what stands before them.
///
/// # Errors
/// If there is no such chapter, or a picture cannot be drawn or written. Wrong words end the program with a sentence.
pub fn draw_as(called: &str, chapter: &str, words: &[OsString]) -> Drawn {
    for output in drawn(called, chapter, words)? {
        let beside = match (&output.exr, &output.svg) {
            (Some(_), _) => " and .exr",
            (_, Some(_)) => " and .svg",
            _ => "",
        };
        say(format!(
            "wrote {}{beside}",
            Untrusted::from(output.png.as_path())
        ));
    }
    Ok(())
}

fn drawn(called: &str, chapter: &str, words: &[OsString]) -> Result<Vec<Output>, Box<dyn Error>> {
    let lesson = lesson::find(chapter).ok_or_else(|| format!("there is no chapter {chapter}"))?;
    let matches = command(lesson, called).try_get_matches_from(words);
    let matches = matches.unwrap_or_else(|error| knobs::plain(&lesson.knobs(), error).exit());
    knobs::check(&lesson.knobs(), &matches).unwrap_or_else(|error| error.exit());
    let shared = Shared::from_arg_matches(&matches)?;
    let turned = knobs::turned(&lesson.knobs(), &matches);
    let show = shared.show && can_show();
    if let Some(what) = shared.vary.one()? {
        let strip = vary::draw(lesson, &shared.options, &turned, what, &shared.vary)?;
        return Ok(vec![strip]);
    }
    let stage = Stage::new(lesson.name, shared.options, show, progress_bar());
    if let Some(name) = &shared.vary.picture {
        let stage = stage.until(name);
        lesson.draw_turned(&stage, &matches)?;
        return Ok(vec![vary::only(stage, name)?]);
    }
    lesson.draw_turned(&stage, &matches)?;
    Ok(stage.into_outputs())
}

/// The command of a chapter: examples, its own knobs, then the options of all chapters.
fn command(lesson: &Lesson, called: &str) -> Command {
    // The short help, for `--help` too: a line for each option.
    let help = Arg::new("help")
        .short('h')
        .long("help")
        .action(ArgAction::HelpShort)
        .help("Print this help");
    let command = Command::new(lesson.name)
        .bin_name(called)
        .no_binary_name(true)
        .disable_help_flag(true)
        .next_help_heading(lesson.chapter().title);
    let command = (lesson.add_knobs)(command).next_help_heading("Pictures");
    Shared::augment_args(command)
        .arg(help)
        .about(lesson.teaches())
        .help_template("{about}\n\n{usage-heading} {usage}{after-help}\n\n{all-args}")
        .after_help(examples(lesson, called))
}

/// One knob turned, and one varied.
fn examples(lesson: &Lesson, called: &str) -> String {
    let knobs = knobs::of(&lesson.knobs());
    let turned = |knob: &Knob| Some(format!("  {called} --{} {}\n", knob.name, knob.example()?));
    let first = knobs.iter().find_map(turned).unwrap_or_default();
    let number = knobs
        .iter()
        .find(|knob| matches!(knob.kind, Kind::Number(..)));
    let varied = number.and_then(|knob| {
        let (name, one, two) = (&knob.name, knob.default.as_ref()?, knob.example()?);
        Some(format!(
            "  {called} --vary {name}={one},{two} --width 320\n"
        ))
    });
    format!(
        "Examples:\n{first}{}",
        varied.unwrap_or_default().trim_end()
    )
}

/// Whether there is a terminal that shows pictures; says why if not.
fn can_show() -> bool {
    let why = colourless();
    if let Some(why) = why {
        complain(format_args!(
            "note: --show shows nothing, because {why}; the pictures are written into files all the same"
        ));
    }
    why.is_none()
}

/// In a student's workbook, a function that is not written yet ends the program with a sentence.
fn end_at_what_is_unwritten() {
    /// Something is missing, as `raybook check` counts it.
    const MISSING: i32 = 1;
    /// Several threads come here at the same time: the first one speaks.
    static SPEAKS: Mutex<()> = Mutex::new(());
    let panics = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        let Some(name) = unwritten(info.payload()) else {
            return panics(info);
        };
        let _speaks = SPEAKS.lock();
        let place = info.location().map_or_else(String::new, |place| {
            format!(" in {}:{}", place.file(), place.line())
        });
        let name = Untrusted::from(name);
        complain(format_args!(
            "error: this chapter's pictures need {name}, which is not written yet: write it{place}; `raybook exercise {name}` says what it is asked"
        ));
        std::process::exit(MISSING);
    }));
}
