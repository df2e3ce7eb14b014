//! The `raybook` command: parse, call, print.

mod commands;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use raybook_chapters::kit::say::{report, said_all};
use raybook_chapters::tour::Tour;
use raybook_grader::contain;
use std::path::Path;
use std::process::ExitCode;

/// A ray-tracing course that you can run. Without a command: the map of the course.
///
/// Exit codes: 0 all right, 1 some answers are wrong or missing, 2 wrong usage or input, or a file that cannot be read or written.
#[derive(Parser)]
#[command(name = "raybook", version)]
struct Command {
    #[command(subcommand)]
    task: Option<Task>,
}

#[derive(Subcommand)]
enum Task {
    /// Draw every chapter's pictures, and a gallery of them
    Tour(Tour),
    /// Draw one chapter's pictures, with its knobs
    Chapter(commands::one_chapter::OneChapter),
    /// Make a workbook: a folder in which you write the functions
    New(commands::new::New),
    /// Check a workbook: what is right, what is not, and the next step
    Check(commands::check::Check),
    /// Check again whenever you save a file
    Watch(commands::watch::Watch),
    /// Draw a chapter's pictures with the functions of your workbook
    Draw(commands::draw::Draw),
    /// Draw a scene with everything that you have written: the picture grows with your work
    Picture(commands::picture::Picture),
    /// Hint at what is wrong, without giving the answer away
    Hint(commands::hint::Hint),
    /// Explain one case in full: both answers, every step to the right one, and a drawing
    Explain(commands::explain::Explain),
    /// Write a page of your work: verdicts, what explains the wrong answers, pictures, costs
    Report(commands::report::Report),
    /// Say what an exercise asks and how it is answered
    Exercise(commands::exercise::Exercise),
    /// Copy in the reference for a chapter that you missed; your files are kept
    Solve(commands::solve::Solve),
    /// Draw the picture of a scene file
    Render(commands::render::Render),
    /// Show the course on a projector: a picture per screen, with knobs to turn
    Present(commands::present::Present),
    /// Compare sampling patterns: points, errors, spectra, pictures, on a page
    Samplers(commands::samplers::Samplers),
    /// Attack the sandbox of strangers' programs, and tell what stopped each attack
    Doctor,
    /// Write or read the file that says what a course grades
    #[command(subcommand)]
    Course(commands::course::CourseFile),
    /// Grade a class of hand-ins, contained and with hidden cases; what was interrupted goes on
    Grade(commands::grade::Grade),
    /// Grade by other rules what is graded; first say whose grade changes, and why
    Regrade(commands::regrade::Regrade),
    /// Write what another machine needs to grade a class
    #[command(subcommand)]
    Pack(commands::pack::Pack),
    /// Write the golden answers (for course authors)
    Bless(commands::bless::Bless),
    /// Open the course book, or a chapter's page, in the browser
    Book(commands::book::Book),
    /// Expand the directives of the course book (mdBook calls this)
    #[command(hide = true)]
    Expand(commands::expand::Expand),
}

fn main() -> ExitCode {
    let matches = told_of_negatives(Command::command()).get_matches();
    let task = Command::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
    let task = task.task;
    if let Err(error) = contain::obey_signals() {
        report(&error);
        return ExitCode::from(2);
    }
    let done = match task {
        None => commands::map::print(Path::new(".")),
        Some(Task::Tour(task)) => task.run().map(|()| true),
        Some(Task::Chapter(task)) => task.run(),
        Some(Task::New(task)) => task.run(),
        Some(Task::Check(task)) => task.run(),
        Some(Task::Watch(task)) => task.run(),
        Some(Task::Draw(task)) => task.run(),
        Some(Task::Picture(task)) => task.run(),
        Some(Task::Hint(task)) => task.run(),
        Some(Task::Explain(task)) => task.run(),
        Some(Task::Report(task)) => task.run(),
        Some(Task::Exercise(task)) => task.run(),
        Some(Task::Solve(task)) => task.run(),
        Some(Task::Render(task)) => task.run(),
        Some(Task::Present(task)) => task.run(),
        Some(Task::Samplers(task)) => task.run(),
        Some(Task::Doctor) => commands::doctor::run(),
        Some(Task::Course(task)) => task.run(),
        Some(Task::Grade(task)) => task.run(),
        Some(Task::Regrade(task)) => task.run(),
        Some(Task::Pack(task)) => task.run(),
        Some(Task::Bless(task)) => task.run(),
        Some(Task::Book(task)) => task.run(),
        Some(Task::Expand(task)) => task.run(Command::command()),
    };
    match done {
        Ok(true) => said_all(ExitCode::SUCCESS),
        Ok(false) => said_all(ExitCode::from(1)),
        Err(error) => {
            report(&*error);
            ExitCode::from(2)
        }
    }
}

/// The same command, where a negative number after an option is its value, so that who writes one is told what the option takes.
fn told_of_negatives(command: clap::Command) -> clap::Command {
    let command = command.mut_subcommands(told_of_negatives);
    command.mut_args(|arg| {
        let takes_value = arg.get_long().is_some() && arg.get_action().takes_values();
        arg.allow_negative_numbers(takes_value)
    })
}
