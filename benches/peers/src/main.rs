//! raybook's accelerators against Embree 3 and the crates `obvhs`, `bvh` and `parry3d`, in one thread.
//!
//! `benches/peers/run` (or `cargo run --release -p raybook-peers`) prints a table for each mesh, and writes `target/peers/ratios.csv`, `builds.csv`,
//! `how.txt` and `ratios.png`. `README.md` beside this package says what is measured and how.

mod construction;
mod forest;
mod generated;
mod meshes;
mod plot;
mod race;
mod racer;
mod racers;
mod report;
mod scaling;
mod sets;

use clap::Parser;
use racer::Racer;
use racers::{ENTRIES, embree::Embree};
use raybook::image::file;
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
    /// Instead of the race, count a ray's steps in soups of 100 to TRIANGLES triangles, and write scaling.csv and scaling.png
    #[arg(long, value_name = "TRIANGLES", value_parser = clap::value_parser!(u32).range(1000..))]
    scaling: Option<u32>,
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
    if let Some(largest) = options.scaling {
        let points = scaling::measure(largest);
        let text = scaling::table(&points);
        print!("{text}");
        std::fs::create_dir_all(&options.out)?;
        std::fs::write(options.out.join("scaling.csv"), text)?;
        let picture = scaling::picture(&points)?;
        return Ok(file::save(
            &options.out.join("scaling.png"),
            &picture.pixels,
        )?);
    }
    let (side, count, rounds, builds) = if options.quick {
        (256, 1 << 15, 3, 1)
    } else {
        (1024, 1 << 18, 5, 3)
    };
    let rounds = options.rounds.map_or(rounds, usize::from);
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
    let how = how(side, count, rounds);
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
        let mut built = Vec::new();
        for entry in ENTRIES {
            if is_wanted(entry.name) && triangles <= entry.at_most && (entry.takes_part)(&scene) {
                built.push((entry, construction::build(entry, &scene, builds)?));
            }
        }
        let (entries, mut made): (Vec<_>, Vec<_>) = built.into_iter().unzip();
        let racers: Vec<Box<dyn Racer>> = made.iter_mut().map(construction::Built::take).collect();
        let (_, radius) = meshes::ball(&scene.mesh);
        let first = rows.len();
        for set in &sets {
            for lap in race::race(set, &racers, rounds, radius) {
                let (entry, built) = (entries[lap.racer], &made[lap.racer]);
                rows.push(Row::new(scene.name, set.name, entry, built, lap));
            }
        }
        print!("{}", report::table(&rows[first..]));
        save(&options.out, &rows, &how)?; // after each mesh: what was measured is not lost if the next one fails
    }
    println!(
        "\n{} has ratios.csv, builds.csv, instances.csv, how.txt and ratios.png",
        options.out.display()
    );
    Ok(())
}

fn save(folder: &Path, rows: &[Row], how: &[String]) -> Result<(), Box<dyn Error>> {
    std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    report::write(folder, rows, how).map_err(|error| format!("{}: {error}", folder.display()))?;
    plot::write(&folder.join("ratios.png"), rows)
}

/// The machine, the compiler's flags and the sizes, in words.
fn how(side: usize, count: usize, rounds: usize) -> Vec<String> {
    let processor = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let field = |name: &str| {
        let line = processor.lines().find(|line| line.starts_with(name));
        line.and_then(|line| line.split_once(": "))
            .map_or("unknown", |(_, value)| value)
    };
    let has: Vec<_> = ["avx2", "fma", "avx512f"]
        .into_iter()
        .filter(|has| field("flags").split(' ').any(|flag| flag == *has))
        .collect();
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    vec![
        format!(
            "processor: {}, family {}, model {} ({cores} of them), with {}",
            field("model name"),
            field("cpu family"),
            field("model\t"),
            has.join(", ")
        ),
        format!("compiled: {}", env!("HOW")),
        format!(
            "rays: {side}² primary ones, {count} of every other set, in one thread; {rounds} rounds, in which all take turns; \
             processor time; build times are wall clock"
        ),
    ]
}
