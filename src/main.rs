//! The `raybook` command: parse, call, print.

mod tour;

use clap::{Parser, Subcommand};
use raybook::lab::chapter::report;
use raybook::workbook::curriculum::CHAPTERS;
use std::process::ExitCode;

/// A ray-tracing course that you can run. Without a command: the map of the course.
#[derive(Parser)]
#[command(version)]
struct Command {
    #[command(subcommand)]
    command: Option<Task>,
}

#[derive(Subcommand)]
enum Task {
    /// Draw every chapter's pictures, and a gallery of them
    Tour(tour::Tour),
}

fn main() -> ExitCode {
    let done = match Command::parse().command {
        None => {
            print_map();
            Ok(())
        }
        Some(Task::Tour(tour)) => tour.run(),
    };
    done.map_or_else(
        |error| {
            report(&*error);
            ExitCode::from(2)
        },
        |()| ExitCode::SUCCESS,
    )
}

/// The course map and the next step.
fn print_map() {
    println!("raybook: a ray-tracing course that you can run\n");
    for chapter in CHAPTERS {
        println!(
            "  {:2}  {:<12} {}",
            chapter.number(),
            chapter.title(),
            chapter.teaches()
        );
    }
    println!("\nNext: see every chapter's pictures   cargo run --release -- tour");
    println!(
        "      or draw one chapter           cargo run --release --bin {}",
        CHAPTERS[0].name
    );
}
