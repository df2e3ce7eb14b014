//! What came of the race: a table, and files for other programs.

use crate::construction::Built;
use crate::race::{Lap, Ratios};
use crate::racer::Query;
use crate::racers::INSTANCES;
use raybook_common::machine::comments;
use raybook_peers::sah::Sah;
use std::fmt::Write;
use std::io;
use std::path::Path;

/// A row of the report: one structure at one set of rays of one mesh.
pub(crate) struct Row {
    /// The mesh.
    pub mesh: &'static str,
    /// The set of rays.
    pub set: &'static str,
    /// The structure.
    pub structure: &'static str,
    /// Whether it is raybook's.
    pub ours: bool,
    /// What came of it.
    pub lap: Lap,
    /// Seconds to build it, with 1 thread and with 2: the best of the rounds.
    pub build: [f64; 2],
    /// Embree's seconds divided by these, in each round.
    pub build_ratios: [Ratios; 2],
    /// Its memory.
    pub bytes_per_triangle: f64,
    /// What its tree costs, if that is known.
    pub sah: Option<Sah>,
}

impl Row {
    /// A row.
    pub(crate) fn new(
        mesh: &'static str,
        set: &'static str,
        built: &Built,
        embree: &Built,
        lap: Lap,
    ) -> Self {
        Self {
            mesh,
            set,
            structure: built.entry.name,
            ours: built.entry.ours,
            lap,
            build: built.best(),
            build_ratios: built.ratios(embree),
            bytes_per_triangle: built.bytes_per_triangle,
            sah: built.sah,
        }
    }

    /// The set, and the query where it is not the set's usual one: "random, many".
    pub(crate) fn column(&self) -> String {
        match self.lap.query {
            Query::ClosestMany => format!("{}, many", self.set),
            Query::Closest | Query::Any => self.set.to_owned(),
        }
    }
}

/// The columns of the table, in order.
pub(crate) const COLUMNS: [&str; 7] = [
    "primary",
    "random",
    "diffuse",
    "shadow",
    "occlusion",
    "random, many",
    "diffuse, many",
];

/// Width of the names of structures.
const NAME: usize = 20;

/// The table of one mesh, and below it what the trees cost and what two levels cost.
pub(crate) fn table(rows: &[Row]) -> String {
    let mut text = format!("{:NAME$}", "");
    for column in COLUMNS {
        let _ = write!(text, "{:>10}", column.replace(", many", "+"));
    }
    let _ = writeln!(
        text,
        "{:>7}{:>10}{:>9}{:>9}{:>7}",
        "mean", "agree", "build 1", "build 2", "bytes"
    );
    for name in structures(rows) {
        let own: Vec<_> = rows.iter().filter(|row| row.structure == name).collect();
        let _ = write!(text, "{name:NAME$}");
        for column in COLUMNS {
            let cell = own.iter().find(|row| row.column() == column).map(|row| {
                if name == "Embree" {
                    format!("{:.1} M/s", row.lap.speed / 1e6)
                } else {
                    format!("{:.3}", row.lap.ratios.median())
                }
            });
            let _ = write!(text, "{:>10}", cell.unwrap_or_default());
        }
        let single = own.iter().filter(|row| row.lap.query != Query::ClosestMany);
        let least = own.iter().map(|row| row.lap.agree).fold(1.0, f64::min);
        let _ = writeln!(
            text,
            "{:>7.2}{:>9.3}%{:>8.3}s{:>8.3}s{:>7.0}",
            geometric_mean(single.map(|row| row.lap.ratios.median())),
            100.0 * least,
            own[0].build[0],
            own[0].build[1],
            own[0].bytes_per_triangle,
        );
    }
    text += &costs(rows);
    for (row, ratios) in two_levels(rows) {
        let (name, set, [low, high]) = (row.structure, row.set, ratios.spread());
        let ratio = ratios.median();
        let _ = writeln!(
            text,
            "{name:NAME$}{set:>10}: {ratio:.2} [{low:.2}–{high:.2}] of all triangles in one level"
        );
    }
    text
}

/// A line for each tree whose cost is known.
fn costs(rows: &[Row]) -> String {
    let mut text = format!("{:NAME$}", "SAH");
    for column in ["cost", "nodes", "leaves", "boxes", "triangles"] {
        let _ = write!(text, "{column:>10}");
    }
    text.push('\n');
    for name in structures(rows) {
        let known = rows.iter().find(|row| row.structure == name);
        if let Some(sah) = known.and_then(|row| row.sah) {
            let _ = writeln!(
                text,
                "{name:NAME$}{:>10.2}{:>10.2}{:>10.2}{:>10.1}{:>10.2}",
                sah.cost(),
                sah.nodes,
                sah.leaves,
                sah.boxes,
                sah.triangles
            );
        }
    }
    text
}

/// What two levels cost: of each structure over instances a line, the ratios of its speed to that of the same over all triangles.
pub(crate) fn two_levels(rows: &[Row]) -> impl Iterator<Item = (&Row, Ratios)> {
    rows.iter().filter_map(|row| {
        let [_, flat] = INSTANCES.iter().find(|[name, _]| *name == row.structure)?;
        let flat = |other: &&Row| {
            (other.structure, other.mesh, other.column()) == (flat, row.mesh, row.column())
        };
        let flat = rows.iter().find(flat)?;
        Some((row, row.lap.ratios.to(&flat.lap.ratios)))
    })
}

/// The structures, each once, in the order in which they come.
pub(crate) fn structures(rows: &[Row]) -> Vec<&'static str> {
    let mut names = Vec::new();
    for row in rows {
        if !names.contains(&row.structure) {
            names.push(row.structure);
        }
    }
    names
}

/// The n-th root of the product; NaN of no numbers.
pub(crate) fn geometric_mean(numbers: impl Iterator<Item = f64>) -> f64 {
    let logarithms: Vec<_> = numbers.map(f64::ln).collect();
    (logarithms.iter().sum::<f64>() / logarithms.len() as f64).exp()
}

/// `ratios.csv`, where `build_s` is with one thread; `builds.csv` with both; `instances.csv`, the ratios of two levels to one;
/// and `how.txt`, which is also the head of each table.
///
/// # Errors
/// If a file cannot be written.
pub(crate) fn write(folder: &Path, rows: &[Row], how: &[String]) -> io::Result<()> {
    let head = |columns: &str| comments(how) + columns + "\n";
    let mut ratios =
        head("mesh,set,query,structure,ratio,ratio_10,ratio_90,agree,build_s,bytes_per_triangle");
    let mut builds = Vec::new();
    for row in rows {
        let Row {
            mesh,
            set,
            structure,
            lap,
            build,
            build_ratios,
            bytes_per_triangle: bytes,
            sah,
            ..
        } = row;
        let query = lap.query.name();
        let (ratio, [low, high], agree, [alone, _]) =
            (lap.ratios.median(), lap.ratios.spread(), lap.agree, build);
        let _ = writeln!(
            ratios,
            "{mesh},{set},{query},{structure},{ratio:.4},{low:.4},{high:.4},{agree:.6},{alone:.4},{bytes:.1}"
        );
        let sah = sah.map_or(String::from(",,,,"), |sah| {
            let Sah {
                nodes,
                leaves,
                boxes,
                triangles,
                ..
            } = sah;
            let cost = sah.cost();
            format!("{cost:.4},{nodes:.4},{leaves:.4},{boxes:.3},{triangles:.4}")
        });
        for (threads, (seconds, ratios)) in (1..).zip(build.iter().zip(build_ratios)) {
            let (ratio, [low, high]) = (ratios.median(), ratios.spread());
            let line = format!(
                "{mesh},{structure},{threads},{seconds:.4},{ratio:.3},{low:.3},{high:.3},{bytes:.1},{sah}\n"
            );
            if !builds.contains(&line) {
                builds.push(line);
            }
        }
    }
    let builds = head(
        "mesh,structure,threads,build_s,ratio,ratio_10,ratio_90,bytes_per_triangle,sah,sah_nodes,sah_leaves,sah_boxes,sah_triangles",
    ) + &builds.concat();
    let mut instances = head("mesh,set,structure,ratio,ratio_10,ratio_90");
    for (row, ratios) in two_levels(rows) {
        let Row {
            mesh,
            set,
            structure,
            ..
        } = row;
        let (ratio, [low, high]) = (ratios.median(), ratios.spread());
        let _ = writeln!(
            instances,
            "{mesh},{set},{structure},{ratio:.4},{low:.4},{high:.4}"
        );
    }
    std::fs::write(folder.join("ratios.csv"), ratios)?;
    std::fs::write(folder.join("instances.csv"), instances)?;
    std::fs::write(folder.join("builds.csv"), builds)?;
    std::fs::write(folder.join("how.txt"), how.join("\n") + "\n")
}
