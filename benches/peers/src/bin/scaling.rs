//! How the work of a ray grows with the number of triangles: counts, which are the same on every machine. It needs no Embree.
//!
//! `benches/peers/run scaling` prints a table, and writes it and a picture into `target/peers/scaling.csv` and `scaling.png`.

use clap::Parser;
use glam::Vec3;
use plotters::prelude::{Color, RGBColor};
use rand::RngExt;
use raybook::accel::{
    Accel, Tests, bvh::Bvh, grid::Grid, list::List, octree::Octree, two_level_grid::TwoLevelGrid,
    wide_bvh::WideBvh,
};
use raybook::image::file;
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::scene::soup;
use raybook::shape::mesh::Facet;
use raybook::store;
use raybook_chapters::kit::axis::Axis;
use raybook_chapters::kit::chart::{Chart, Corner};
use raybook_chapters::kit::figure::{self, Figure, LEFT, figure, text};
use raybook_chapters::kit::palette::{BLUE, GREEN, INK, ORANGE, PURPLE, VERMILION};
use raybook_chapters::lab::legend::power_of_ten;
use raybook_common::machine::{comments, processor};
use raybook_common::statistics::slope;
use std::error::Error;
use std::fmt::Write;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

/// Counts the steps of rays in soups of 100 to TRIANGLES triangles
#[derive(Parser)]
struct Options {
    /// Triangles of the largest soup
    #[arg(value_parser = clap::value_parser!(u32).range(1000..))]
    triangles: u32,
    /// Where scaling.csv and scaling.png go
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
    let how = [
        processor(),
        format!("compiled: {}", env!("HOW")),
        format!(
            "rays: {RAYS} for each structure and size, by counts; build times are wall clock, on all processors"
        ),
    ];
    let curves = measure(options.triangles);
    let text = comments(&how) + &table(&curves);
    print!("{text}");
    store::write(&options.out.join("scaling.csv"), text.as_bytes())?;
    let picture = picture(&curves, &how)?;
    Ok(file::save(
        &options.out.join("scaling.png"),
        &picture.pixels,
    )?)
}

/// Rays through the soup, the same for every size.
const RAYS: usize = 2000;

/// One that is measured: how it is called, drawn and counted.
struct Structure {
    name: &'static str,
    colour: RGBColor,
    /// It goes no further than this number of triangles.
    at_most: u32,
    count: fn(&[Facet]) -> Counted,
}

/// All that are measured and drawn.
const STRUCTURES: &[Structure] = &[
    structure("Bvh", BLUE, |facets| count(facets, Bvh::new, Bvh::bytes)),
    structure("Grid", GREEN, |facets| {
        count(facets, Grid::of_facets, Grid::bytes)
    }),
    Structure {
        at_most: 100_000, // it asks every shape
        ..structure("List", INK, |facets| {
            count(facets, List::new, |_| size_of_val(facets))
        })
    },
    structure("Octree", PURPLE, |facets| {
        count(facets, Octree::of_facets, Octree::bytes)
    }),
    structure("TwoLevelGrid", ORANGE, |facets| {
        count(facets, TwoLevelGrid::of_facets, TwoLevelGrid::bytes)
    }),
    structure("WideBvh", VERMILION, |facets| {
        count(facets, WideBvh::new, WideBvh::bytes)
    }),
];

const fn structure(
    name: &'static str,
    colour: RGBColor,
    count: fn(&[Facet]) -> Counted,
) -> Structure {
    Structure {
        name,
        colour,
        at_most: u32::MAX,
        count,
    }
}

/// What is counted of one structure over one soup.
struct Counted {
    tests: Tests,
    /// Seconds.
    build: f64,
    bytes: usize,
}

/// What came of one structure at one size.
struct Point {
    triangles: f64,
    /// Boxes tested, in the mean over the rays.
    boxes: f64,
    /// The same of triangles.
    shapes: f64,
    /// Both.
    steps: f64,
    /// Seconds.
    build: f64,
    /// Bytes per triangle.
    bytes: f64,
}

/// What came of one structure, size by size.
struct Curve {
    structure: &'static Structure,
    points: Vec<Point>,
}

/// What came of the structures at all sizes from a hundred triangles to `largest`.
fn measure(largest: u32) -> Vec<Curve> {
    let nothing = |structure| Curve {
        structure,
        points: Vec::new(),
    };
    let mut curves: Vec<_> = STRUCTURES.iter().map(nothing).collect();
    let sizes = (0..).map(|i| (100.0 * 10_f64.powf(0.5 * f64::from(i))).round() as u32);
    for n in sizes.take_while(|&n| n <= largest) {
        let facets = soup::soup(n, 1).facets();
        for Curve { structure, points } in &mut curves {
            if n > structure.at_most {
                continue;
            }
            let Counted {
                tests,
                build,
                bytes,
            } = (structure.count)(&facets);
            let mean = |count: u64| count as f64 / RAYS as f64;
            points.push(Point {
                triangles: f64::from(n),
                boxes: mean(tests.boxes),
                shapes: mean(tests.shapes),
                steps: mean(tests.boxes + tests.shapes),
                build,
                bytes: bytes as f64 / f64::from(n),
            });
        }
    }
    curves
}

impl Curve {
    /// The power of the number of triangles to which the steps grow, fitted by least squares, and two standard errors.
    fn exponent(&self) -> (f64, f64) {
        let log = |point: &Point| (point.triangles.ln(), point.steps.ln());
        let (exponent, error) = slope(&self.points.iter().map(log).collect::<Vec<_>>());
        (exponent, 2.0 * error)
    }
}

/// The rows of `scaling.csv`, and below them, as comments, the exponents.
fn table(curves: &[Curve]) -> String {
    let mut text = String::from("structure,triangles,boxes,shapes,build_s,bytes_per_triangle\n");
    for Curve { structure, points } in curves {
        for point in points {
            let Point {
                triangles,
                boxes,
                shapes,
                build,
                bytes,
                ..
            } = point;
            let _ = writeln!(
                text,
                "{},{triangles},{boxes:.2},{shapes:.2},{build:.4},{bytes:.1}",
                structure.name
            );
        }
    }
    for curve in curves {
        let (exponent, error) = curve.exponent();
        let _ = writeln!(
            text,
            "# {}: steps grow as N^({exponent:.3} ± {error:.3})",
            curve.structure.name
        );
    }
    text
}

/// Steps, memory and the time of the build against the number of triangles, side by side. The legend tells the exponents of the steps.
///
/// # Errors
/// What plotters reports.
fn picture(curves: &[Curve], how: &[String]) -> Figure {
    let all = || curves.iter().flat_map(|curve| &curve.points);
    let most = |of: fn(&Point) -> f64| all().map(of).fold(0.0, f64::max);
    let least = |of: fn(&Point) -> f64| all().map(of).fold(f64::INFINITY, f64::min);
    let log = |of| Axis::log(0.5 * least(of)..2.0 * most(of)).format(power_of_ten);
    let from_zero = |of| Axis::linear(0.0..1.1 * most(of));
    let steps: fn(&Point) -> f64 = |point| point.steps;
    let bytes: fn(&Point) -> f64 = |point| point.bytes;
    let build: fn(&Point) -> f64 = |point| point.build;
    let panels = [
        (
            log(steps).named("boxes and triangles tested per ray"),
            steps,
        ),
        (from_zero(bytes).named("bytes per triangle"), bytes),
        (log(build).named("seconds to build"), build),
    ];
    let charts = panels.map(|(y, of)| {
        let mut chart = Chart::new(log(|point| point.triangles).named("triangles"), y);
        for curve in curves {
            let Structure { name, colour, .. } = curve.structure;
            let points = || curve.points.iter();
            let places = || points().map(|point| (point.triangles, of(point)));
            let (exponent, error) = curve.exponent();
            let name = format!("{name}: steps ∝ N^({exponent:.2} ± {error:.2})");
            chart
                .line(places(), colour.stroke_width(6))
                .named(&name)
                .dots(places(), 8, colour.filled());
        }
        chart
    });
    let [steps, bytes, build] = charts;
    let charts = [steps, bytes.legend(Corner::LowerLeft), build]; // where no curve is
    figure(1800, 700, |canvas| {
        let (canvas, foot) = canvas.split_vertically(1280);
        for (i, line) in (0..).zip(how) {
            figure::write(&foot, line, (30, 24 + 36 * i), text(26).pos(LEFT))?;
        }
        let parts = canvas.split_evenly((1, charts.len()));
        let mut both = charts.iter().zip(parts);
        both.try_for_each(|(chart, part)| chart.draw(&part))
    })
}

/// Builds a structure, and counts the steps of all rays.
fn count<A: Accel<Facet>>(
    facets: &[Facet],
    build: impl Fn(Vec<Facet>) -> A,
    bytes: impl Fn(&A) -> usize,
) -> Counted {
    let start = Instant::now();
    let accel = build(facets.to_vec());
    let seconds = start.elapsed().as_secs_f64();
    let mut rng = pcg::stream(9, 0);
    let mut at = || Vec3::from_array(std::array::from_fn(|_| rng.random::<f32>()));
    let mut tests = Tests::default();
    for _ in 0..RAYS {
        let (from, to) = (3.0 * at() - 1.0, at());
        let ray = Ray::new(from, Dir3::new_or(to - from, Dir3::X));
        accel.closest_counted(&ray, Interval::AHEAD, &mut tests);
    }
    Counted {
        tests,
        build: seconds,
        bytes: bytes(&accel),
    }
}
