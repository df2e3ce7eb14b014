//! raybook's octree of triangles against that of the crate `arctk`, on the same rays, in one thread.

mod race;
mod racers;
mod scenes;

use clap::Parser;
use race::race;
use raybook::store;
use raybook_common::machine::processor;
use scenes::scenes;
use std::error::Error;
use std::fmt::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// Races raybook's octree against that of the crate arctk
#[derive(Parser)]
struct Options {
    /// Few rays and rounds
    #[arg(long)]
    quick: bool,
    /// Where octrees.csv goes
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
    let (side, rounds) = if options.quick { (64, 5) } else { (256, 11) };
    let mut text = format!(
        "# {}, one thread\n# {side}² rays of each set; {rounds} rounds; processor time; builds are wall clock, once\n\
         mesh,triangles,set,ratio,ratio_10,ratio_90,agree,build_s,arctk_build_s,arctk_leaf,arctk_levels\n",
        processor()
    );
    for scene in scenes()? {
        for row in race(&scene, side, rounds)? {
            let [ratio, low, high] = row.ratio();
            let line = format!(
                "{},{},{},{ratio:.3},{low:.3},{high:.3},{:.5},{:.4},{:.4},{},{}",
                scene.name,
                scene.mesh.triangles().len(),
                row.set,
                row.agree,
                row.build,
                row.their_build,
                row.settings.leaf,
                row.settings.levels
            );
            let _ = writeln!(text, "{line}");
        }
    }
    let file = options.out.join("octrees.csv");
    store::write(&file, text.as_bytes())?;
    // Only now: arctk shows on the standard output how far its builds are.
    println!("{text}wrote {}", file.display());
    Ok(())
}
