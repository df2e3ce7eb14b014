//! Pictures of tables that other programs wrote: `pictures.csv`, of whole pictures, `octrees.csv`, of octrees, and `equal_time.csv`, of noise.
//!
//! `benches/peers/run draw FOLDER` draws those of them that are in the folder. It needs no Embree.

use clap::Parser;
use raybook::store;
use raybook_peers::plot::{Picture, Ratio};
use std::collections::HashMap;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Draws pictures.csv, octrees.csv and equal_time.csv
#[derive(Parser)]
struct Options {
    /// Where the tables are, and where the pictures go
    #[arg(default_value = "target/peers")]
    folder: PathBuf,
}

fn main() -> ExitCode {
    let Options { folder } = Options::parse();
    match draw(&folder) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {}: {error}", folder.display());
            ExitCode::FAILURE
        }
    }
}

fn draw(folder: &Path) -> Result<(), Box<dyn Error>> {
    for (name, title, ratios) in [
        (
            "pictures",
            "Whole pictures: processor time and error of others, divided by raybook's: more is better for raybook",
            pictures as fn(&Table) -> Result<Vec<Ratio>, String>,
        ),
        (
            "octrees",
            "Rays per second and builds per second of Octree, as a multiple of those of arctk's octree: more is better",
            octrees,
        ),
        (
            "equal_time",
            "Error of an older commit, divided by that of this one in the same processor time: more is better",
            noise,
        ),
    ] {
        let file = folder.join(name).with_extension("csv");
        if !file.exists() {
            continue;
        }
        let table = Table::new(&store::read_text(&file)?);
        let picture = Picture {
            title,
            scenes: &[""],
            ratios: &ratios(&table)?,
            how: &table.how,
        };
        let file = folder.join(name).with_extension("png");
        picture.write(&file)?;
        println!("drew {}", file.display());
    }
    Ok(())
}

/// A table whose cells hold no commas.
struct Table {
    /// The lines that are comments.
    how: Vec<String>,
    /// The rows: each cell by the name of its column.
    rows: Vec<HashMap<String, String>>,
}

impl Table {
    fn new(text: &str) -> Self {
        let how = text.lines().filter_map(|line| line.strip_prefix("# "));
        let mut lines = text.lines().filter(|line| !line.starts_with('#'));
        let cells = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<_>>();
        let head = lines.next().map(cells).unwrap_or_default();
        let row = |line| head.iter().cloned().zip(cells(line)).collect();
        Self {
            how: how.map(str::to_owned).collect(),
            rows: lines.map(row).collect(),
        }
    }
}

/// A number of a row.
fn number(row: &HashMap<String, String>, column: &str) -> Result<f64, String> {
    let cell = row.get(column).and_then(|cell| cell.parse().ok());
    cell.ok_or_else(|| format!("no number in the column {column}"))
}

/// Each path tracer but raybook's, which is the first row.
fn pictures(table: &Table) -> Result<Vec<Ratio>, String> {
    let [ours, others @ ..] = &*table.rows else {
        return Ok(Vec::new());
    };
    let mut ratios = Vec::new();
    for row in others {
        for (panel, column) in [("time", "seconds"), ("error", "rms_error")] {
            let ratio = number(row, column)? / number(ours, column)?;
            ratios.push(one(row, "path_tracer", panel, ratio, [ratio; 2]));
        }
        let spread = [number(row, "ratio_10")?, number(row, "ratio_90")?];
        let panel = "time for the same error";
        let ratio = number(row, "ratio")?;
        ratios.push(one(row, "path_tracer", panel, ratio, spread));
    }
    Ok(ratios)
}

/// Each mesh: each set of rays, and once the build.
fn octrees(table: &Table) -> Result<Vec<Ratio>, String> {
    let mut ratios: Vec<Ratio> = Vec::new();
    for row in &table.rows {
        let set = row.get("set").cloned().unwrap_or_default();
        let spread = [number(row, "ratio_10")?, number(row, "ratio_90")?];
        ratios.push(one(row, "mesh", &set, number(row, "ratio")?, spread));
    }
    for row in &table.rows {
        let ratio = number(row, "arctk_build_s")? / number(row, "build_s")?;
        let build = one(row, "mesh", "build", ratio, [ratio; 2]);
        if !ratios.contains(&build) {
            ratios.push(build);
        }
    }
    Ok(ratios)
}

/// Each chapter.
fn noise(table: &Table) -> Result<Vec<Ratio>, String> {
    let one = |row| {
        let spread = [number(row, "ratio_most")?, number(row, "ratio_least")?];
        let ratio = number(row, "ratio")?.recip();
        let panel = "error at equal time";
        Ok(one(row, "chapter", panel, ratio, spread.map(f64::recip)))
    };
    table.rows.iter().map(one).collect()
}

/// The ratio of a row, which is named in a column.
fn one(
    row: &HashMap<String, String>,
    name: &str,
    panel: &str,
    ratio: f64,
    spread: [f64; 2],
) -> Ratio {
    Ratio {
        panel: panel.to_owned(),
        row: row.get(name).cloned().unwrap_or_default(),
        ours: false,
        scene: 0,
        ratio,
        spread,
    }
}
