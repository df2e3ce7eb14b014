//! The builders of trees compared: how long each takes, and what its tree costs.

use crate::kit::bars::{Bars, bars};
use crate::kit::figure::Diagram;
use clap::ValueEnum;
use raybook::accel::bvh::Bvh;
use raybook::accel::bvh::build::Method;
use raybook::shape::mesh::Facet;
use std::error::Error;
use std::time::Instant;

/// A method by its name, as on a command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Builder {
    /// Half of the boxes on either side
    Median,
    /// Cut in the middle of the box around the centres
    Middle,
    /// The surface-area heuristic at all cuts
    Sweep,
    /// The surface-area heuristic at the borders of bins
    Binned,
    /// Bottom-up: the nearest boxes are joined first
    BottomUp,
}

impl From<Builder> for Method {
    fn from(builder: Builder) -> Self {
        match builder {
            Builder::Median => Self::Median,
            Builder::Middle => Self::Middle,
            Builder::Sweep => Self::Sweep,
            Builder::Binned => Self::Binned,
            Builder::BottomUp => Self::BottomUp,
        }
    }
}

const ALL_CUTS: &str = "heuristic, all cuts";
const BINS: &str = "heuristic, bins";

/// The methods, by name.
pub(super) const METHODS: [(&str, Method); 5] = [
    ("median", Method::Median),
    ("middle", Method::Middle),
    (ALL_CUTS, Method::Sweep),
    (BINS, Method::Binned),
    ("bottom-up", Method::BottomUp),
];

/// Two bar charts, milliseconds to build and the cost of the tree; and their caption.
///
/// # Errors
/// What plotters reports.
pub(super) fn figure(facets: &[Facet]) -> Result<(Diagram, String), Box<dyn Error>> {
    let mut rows = Vec::new();
    for (name, method) in METHODS {
        let facets = facets.to_vec();
        let start = Instant::now();
        let tree = Bvh::build(facets, method);
        rows.push((name, 1e3 * start.elapsed().as_secs_f64(), tree.sah_cost()));
    }
    let of = |wanted| {
        let row = rows.iter().find(|row| row.0 == wanted);
        row.map_or((f64::NAN, f64::NAN), |row| (row.1, f64::from(row.2)))
    };
    let (all, bins) = (of(ALL_CUTS), of(BINS));
    let caption = format!(
        "Time to build a tree over the teapot, and the cost of a search in it, for each builder. With bins, building is {:.0} \
        times as fast as with all cuts, and a search costs {:.1} % more.",
        all.0 / bins.0,
        100.0 * (bins.1 / all.1 - 1.0)
    );
    let times: Vec<_> = rows.iter().map(|&(name, ms, _)| (name, ms)).collect();
    let costs: Vec<_> = rows
        .iter()
        .map(|&(name, _, cost)| (name, f64::from(cost)))
        .collect();
    let note = format!("{} triangles, all threads", facets.len());
    let charts = bars(&[
        Bars {
            title: "Time to build",
            unit: "ms",
            rows: &times,
            note: &note,
        },
        Bars {
            title: "Cost of a search",
            unit: "",
            rows: &costs,
            note: "branches opened and triangles tested by a random ray, as the heuristic estimates",
        },
    ])?;
    Ok((charts, caption))
}
