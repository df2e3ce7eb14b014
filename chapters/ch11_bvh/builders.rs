//! The builders of trees compared: how long each takes, and what its tree costs.

use crate::kit::{bars::bars, figure::Figure, sheet::sheet};
use raybook::accel::bvh::Bvh;
use raybook::accel::bvh::build::Method;
use raybook::shape::mesh::Facet;
use std::time::Instant;

/// The methods, by name.
pub(super) const METHODS: [(&str, Method); 5] = [
    ("median", Method::Median),
    ("middle", Method::Middle),
    ("heuristic, all cuts", Method::Sweep),
    ("heuristic, bins", Method::Binned),
    ("bottom-up", Method::BottomUp),
];

/// Two bar charts: milliseconds to build, and the cost of the tree.
///
/// # Errors
/// What plotters reports.
pub(super) fn figure(facets: &[Facet]) -> Figure {
    let mut rows = Vec::new();
    for (name, method) in METHODS {
        let facets = facets.to_vec();
        let start = Instant::now();
        let tree = Bvh::build(facets, method);
        rows.push((name, 1e3 * start.elapsed().as_secs_f64(), tree.sah_cost()));
    }
    let times: Vec<_> = rows.iter().map(|&(name, ms, _)| (name, ms)).collect();
    let costs: Vec<_> = rows
        .iter()
        .map(|&(name, _, cost)| (name, f64::from(cost)))
        .collect();
    let note = format!("{} triangles, all threads", facets.len());
    let times = bars("Time to build", "ms", &times, &note)?;
    let note = "branches opened and triangles tested by a random ray, as the heuristic sees it";
    let costs = bars("Cost of a search", "", &costs, note)?;
    sheet(1, &[("", times), ("", costs)])
}
