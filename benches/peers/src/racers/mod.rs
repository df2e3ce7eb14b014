//! Everyone in the race. One more is a line here, and a [`Search`] where there is none yet.

pub(crate) mod bvh_crate;
pub(crate) mod embree;
pub(crate) mod embree4;
pub(crate) mod obvhs;
pub(crate) mod ours;
pub(crate) mod parry;

use crate::racer::{Build, Entry, Racer, Search};
use ours::{Ours, Wide};
use raybook::accel::{
    bvh::Bvh, grid::Grid, list::List, octree::Octree, two_level_grid::TwoLevelGrid,
    wide_bvh::WideBvh,
};

/// All that take part; the first is what the others are compared with.
pub(crate) const ENTRIES: &[Entry] = &[
    entry("Embree", false, embree::build),
    entry("Embree robust", false, embree::build_robust),
    Entry {
        is_here: embree4::is_here,
        ..entry("Embree 4", false, embree4::build)
    },
    Entry {
        is_here: embree4::is_here,
        ..entry("Embree 4 robust", false, embree4::build_robust)
    },
    Entry {
        at_most: 10_000,
        ..entry("List", true, |mesh, _| {
            boxed(Ours(List::new(mesh.facets())))
        })
    },
    entry("Grid", true, |mesh, _| {
        boxed(Ours(Grid::of_facets(mesh.facets())))
    }),
    entry("TwoLevelGrid", true, |mesh, _| {
        boxed(Ours(TwoLevelGrid::of_facets(mesh.facets())))
    }),
    entry("Octree", true, |mesh, _| {
        boxed(Ours(Octree::of_facets(mesh.facets())))
    }),
    entry("Bvh", true, |mesh, _| boxed(Ours(Bvh::new(mesh.facets())))),
    entry("WideBvh", true, |mesh, _| {
        boxed(Wide(WideBvh::new(mesh.facets())))
    }),
    entry("obvhs BVH2", false, |mesh, _| boxed(obvhs::Bvh2::new(mesh))),
    entry("obvhs CwBvh", false, |mesh, _| {
        boxed(obvhs::Wide::new(mesh))
    }),
    entry("bvh", false, |mesh, _| boxed(bvh_crate::Bvh::new(mesh))),
    entry("parry3d", false, |mesh, _| {
        boxed(parry::Trimesh::new(mesh)?)
    }),
];

const fn entry(name: &'static str, ours: bool, build: Build) -> Entry {
    Entry {
        name,
        ours,
        build,
        at_most: usize::MAX,
        is_here: || true,
    }
}

#[allow(clippy::unnecessary_wraps, reason = "others can fail")]
fn boxed<S: Search + 'static>(search: S) -> Result<Box<dyn Racer>, String> {
    Ok(Box::new(search))
}
