//! The pictures of the race: all its ratios, with their spread.

use crate::meshes::NAMES as MESHES;
use crate::race::Ratios;
use crate::report::{COLUMNS, Row, structures, two_levels};
use raybook_chapters::kit::stage::Drawn;
use raybook_peers::plot::{Picture, Ratio};
use std::path::Path;

/// Draws `ratios.png`, `builds.png` and `instances.png`.
///
/// # Errors
/// If one cannot be drawn or written.
pub(crate) fn write(folder: &Path, rows: &[Row], how: &[String]) -> Drawn {
    for (file, title, ratios) in [
        (
            "ratios.png",
            "Rays per second, as a multiple of Embree's in the same round (one thread, one ray at a time; “many”: a batch)",
            speeds(rows),
        ),
        (
            "builds.png",
            "Build time, memory and SAH cost of Embree, high quality, divided by those of each: more is better",
            builds(rows),
        ),
        (
            "instances.png",
            "Rays per second of two levels, as a multiple of those of the same structure in one level",
            levels(rows),
        ),
    ] {
        let picture = Picture {
            title,
            scenes: &MESHES,
            ratios: &ratios,
            how,
        };
        picture.write(&folder.join(file))?;
    }
    Ok(())
}

/// All speeds but Embree's own, in the order of the table's columns.
fn speeds(rows: &[Row]) -> Vec<Ratio> {
    let others = || rows.iter().filter(|row| row.structure != "Embree");
    let column = |name: &'static str| {
        let own = others().filter(move |row| row.column() == name);
        own.map(move |row| ratio(row, name, &row.lap.ratios))
    };
    COLUMNS.into_iter().flat_map(column).collect()
}

/// The speeds of instances.
fn levels(rows: &[Row]) -> Vec<Ratio> {
    let column = |name: &'static str| {
        let own = two_levels(rows).filter(move |(row, _)| row.column() == name);
        own.map(move |(row, ratios)| ratio(row, name, &ratios))
    };
    COLUMNS.into_iter().flat_map(column).collect()
}

/// Builds, each structure at each mesh once: its times, its memory and its tree.
fn builds(rows: &[Row]) -> Vec<Ratio> {
    let mut all = Vec::new();
    for mesh in MESHES {
        let of = |name| {
            let is_it = |row: &&Row| (row.mesh, row.structure) == (mesh, name);
            rows.iter().find(is_it)
        };
        let Some(embree) = of("Embree") else { continue };
        for row in structures(rows).into_iter().skip(1).filter_map(of) {
            let [alone, two] = &row.build_ratios;
            all.push(ratio(row, "build, 1 thread", alone));
            all.push(ratio(row, "build, 2 threads", two));
            let bytes = Ratios::once(embree.bytes_per_triangle / row.bytes_per_triangle);
            all.push(ratio(row, "memory", &bytes));
            if let (Some(sah), Some(others)) = (row.sah, embree.sah) {
                let cost = Ratios::once(others.cost() / sah.cost());
                all.push(ratio(row, "SAH cost", &cost));
            }
        }
    }
    all
}

/// A ratio of a row's structure at its mesh.
fn ratio(row: &Row, panel: &str, ratios: &Ratios) -> Ratio {
    let scene = MESHES.iter().position(|name| *name == row.mesh);
    Ratio {
        panel: panel.to_owned(),
        row: row.structure.to_owned(),
        ours: row.ours,
        scene: scene.unwrap_or_default(),
        ratio: ratios.median(),
        spread: ratios.spread(),
    }
}
