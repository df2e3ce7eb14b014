//! raybook's accelerators against Embree 3 and the crates `obvhs`, `bvh` and `parry3d`, in one thread.
//!
//! `benches/peers/run` (or `cargo run --release -p raybook-peers`) prints a table for each mesh, and writes `ratios`, `builds` and `instances`
//! as CSV and PNG, and `how.txt`, into `target/peers`. `README.md` beside this package says what is measured and how.

mod construction;
mod forest;
mod generated;
mod meshes;
mod pictures;
mod race;
mod racer;
mod racers;
mod report;
mod sets;

use clap::Parser;
use racer::{Entry, Racer};
use racers::{ENTRIES, embree::Embree};
use raybook_common::machine;
use raybook_embree::scans;
use report::Row;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Races raybook's accelerators against Embree and other crates
#[derive(Parser)]
struct Options {
    /// Only these meshes, separated by commas
    #[arg(long, value_delimiter = ',', value_name = "NAMES")]
    meshes: Vec<String>,
    /// Only these structures, separated by commas: a part of a name is enough; Embree always runs
    #[arg(long, value_delimiter = ',', value_name = "NAMES")]
    structures: Vec<String>,
    /// Few rays and rounds: a first impression in a minute or two
    #[arg(long)]
    quick: bool,
    /// Rounds; the median of them counts
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    rounds: Option<u16>,
    /// Rounds of builds; their best time counts, and the median of the ratios to Embree's times
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    builds: Option<u16>,
    /// Where the files go
    #[arg(long, value_name = "FOLDER", default_value = "target/peers")]
    out: PathBuf,
}

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    let (side, count, rounds, builds) = if options.quick {
        (256, 1 << 15, 3, 1)
    } else {
        (1024, 1 << 18, 5, 3)
    };
    let rounds = options.rounds.map_or(rounds, usize::from);
    let builds = options.builds.map_or(builds, usize::from);
    let names: Vec<_> = if options.meshes.is_empty() {
        meshes::NAMES.map(str::to_owned).to_vec()
    } else {
        options.meshes.clone()
    };
    let is_wanted = |name: &str| {
        let part = |part: &String| name.to_lowercase().contains(&part.to_lowercase());
        name == ENTRIES[0].name
            || options.structures.is_empty()
            || options.structures.iter().any(part)
    };
    let how = how(side, count, rounds, builds);
    println!("{}", how.join("\n"));
    if names.iter().any(|name| name == "bunny" || name == "dragon") {
        println!("{}", scans::credits()?);
    }
    let mut rows = Vec::new();
    for name in &names {
        let scene = meshes::scene(name)?;
        let triangles = scene.mesh.triangles().len();
        println!(
            "\n{name}: {triangles} triangles; rays per second, divided by Embree's (+: in batches)"
        );
        let embree = Embree::new(&scene.mesh, 2)?;
        let sets = sets::sets(&scene, &embree, side, count);
        drop(embree);
        let takes_part = |entry: &&Entry| {
            is_wanted(entry.name) && triangles <= entry.at_most && (entry.takes_part)(&scene)
        };
        let mut made = construction::build(ENTRIES.iter().filter(takes_part), &scene, builds)?;
        let racers: Vec<Box<dyn Racer>> = made.iter_mut().map(construction::Built::take).collect();
        let (_, radius) = meshes::ball(&scene.mesh);
        let first = rows.len();
        for set in &sets {
            for lap in race::race(set, &racers, rounds, radius) {
                let built = &made[lap.racer];
                rows.push(Row::new(scene.name, set.name, built, &made[0], lap));
            }
        }
        print!("{}", report::table(&rows[first..]));
        save(&options.out, &rows, &how)?; // after each mesh: what was measured is not lost if the next one fails
    }
    println!(
        "\n{} has ratios, builds and instances as CSV and PNG, and how.txt",
        options.out.display()
    );
    Ok(())
}

fn save(folder: &Path, rows: &[Row], how: &[String]) -> Result<(), Box<dyn Error>> {
    std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    report::write(folder, rows, how).map_err(|error| format!("{}: {error}", folder.display()))?;
    pictures::write(folder, rows, how)
}

/// The machine, the compiler's flags and the sizes, in words.
fn how(side: usize, count: usize, rounds: usize, builds: usize) -> Vec<String> {
    vec![
        machine::processor(),
        format!("compiled: {}", env!("HOW")),
        format!(
            "rays: {side}² primary ones, {count} of every other set, in one thread; {rounds} rounds, in which all take turns; \
             processor time; build times are wall clock, rounds of builds: {builds}"
        ),
    ]
}
