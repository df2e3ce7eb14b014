//! Everyone in the race. One more is a line here, and a [`Search`] where there is none yet.

pub(crate) mod bvh_crate;
pub(crate) mod embree;
pub(crate) mod embree4;
mod embree_tree;
pub(crate) mod obvhs;
pub(crate) mod ours;
pub(crate) mod parry;

use crate::racer::{Build, Entry, Racer, Search};
use ::obvhs::BvhBuildParams;
use ours::{Binary, Ours, Wide};
use raybook::accel::{
    bvh::{Bvh, build::Method},
    grid::Grid,
    list::List,
    octree::Octree,
    two_level_grid::TwoLevelGrid,
    wide_bvh::WideBvh,
};

/// Structures in two levels, over instances of one mesh; and beside each, the same in one level, over all triangles.
pub(crate) const INSTANCES: [[&str; 2]; 2] = [
    ["Embree instances", "Embree"],
    ["WideBvh instances", "WideBvh"],
];

/// All that take part; the first is what the others are compared with.
pub(crate) const ENTRIES: &[Entry] = &[
    entry("Embree", false, embree::build),
    entry("Embree medium", false, embree::build_medium),
    entry("Embree robust", false, embree::build_robust),
    Entry {
        takes_part: |_| embree4::is_here(),
        ..entry("Embree 4", false, embree4::build)
    },
    Entry {
        takes_part: |_| embree4::is_here(),
        ..entry("Embree 4 robust", false, embree4::build_robust)
    },
    Entry {
        at_most: 10_000,
        ..entry("List", true, |scene, _| {
            boxed(Ours(List::new(scene.mesh.facets())))
        })
    },
    entry("Grid", true, |scene, _| {
        boxed(Ours(Grid::of_facets(scene.mesh.facets())))
    }),
    entry("TwoLevelGrid", true, |scene, _| {
        boxed(Ours(TwoLevelGrid::of_facets(scene.mesh.facets())))
    }),
    entry("Octree", true, |scene, _| {
        boxed(Ours(Octree::of_facets(scene.mesh.facets())))
    }),
    entry("Bvh", true, |scene, _| {
        boxed(Binary(Bvh::new(scene.mesh.facets())))
    }),
    entry("WideBvh", true, |scene, _| {
        boxed(Wide(WideBvh::new(scene.mesh.facets())))
    }),
    entry("WideBvh binned", true, |scene, _| {
        boxed(Wide(WideBvh::build(scene.mesh.facets(), Method::Binned)))
    }),
    Entry {
        takes_part: |scene| scene.forest.is_some(),
        ..entry(INSTANCES[0][0], false, embree::build_instances)
    },
    Entry {
        takes_part: |scene| scene.forest.is_some(),
        ..entry(INSTANCES[1][0], true, ours::build_instances)
    },
    entry("obvhs BVH2", false, |scene, _| {
        let medium = BvhBuildParams::medium_build();
        boxed(obvhs::Bvh2::new(&scene.mesh, medium))
    }),
    entry("obvhs BVH2 fastest", false, |scene, _| {
        let fastest = BvhBuildParams::fastest_build();
        boxed(obvhs::Bvh2::new(&scene.mesh, fastest))
    }),
    entry("obvhs CwBvh", false, |scene, _| {
        let medium = BvhBuildParams::medium_build();
        boxed(obvhs::Wide::new(&scene.mesh, medium))
    }),
    entry("obvhs CwBvh fastest", false, |scene, _| {
        let fastest = BvhBuildParams::fastest_build();
        boxed(obvhs::Wide::new(&scene.mesh, fastest))
    }),
    entry("bvh", false, |scene, _| {
        boxed(bvh_crate::Bvh::new(&scene.mesh))
    }),
    entry("parry3d", false, |scene, _| {
        boxed(parry::Trimesh::new(&scene.mesh)?)
    }),
];

const fn entry(name: &'static str, ours: bool, build: Build) -> Entry {
    Entry {
        name,
        ours,
        build,
        at_most: usize::MAX,
        takes_part: |_| true,
    }
}

#[allow(clippy::unnecessary_wraps, reason = "others can fail")]
fn boxed<S: Search + 'static>(search: S) -> Result<Box<dyn Racer>, String> {
    Ok(Box::new(search))
}
