//! Every accelerator gives Embree's answers, over meshes of up to a million triangles.
//!
//! 10⁷ rays, two million at each mesh, of the five kinds of `src/rays.rs`; or a fifth of them (`thorough`). Embree is in its robust mode, so an edge between
//! two triangles is no excuse for a miss. Who is slower is asked a part of the questions. Run with `-- --nocapture` to see
//! the table.

use raybook::accel::{
    bvh::Bvh, grid::Grid, octree::Octree, two_level_grid::TwoLevelGrid, wide_bvh::WideBvh,
};
use raybook::scene::{soup, stadium, terrain};
use raybook::shape::mesh::Mesh;
use raybook_common::thorough;
use raybook_embree::contest::Contest;
use raybook_embree::scans;

/// Rays at each mesh, in a thorough test.
const RAYS: u32 = 2_000_000;

/// Structures that sort space, not shapes, are slower: they are asked one question of this number.
const SPACE: usize = 4;

fn all_agree(name: &'static str, mesh: Mesh, grid_every: usize) {
    let contest = Contest::new(name, mesh, thorough(RAYS) as usize, WideBvh::new);
    let contest = contest.expect("Embree works");
    contest.ask("Grid", grid_every, Grid::of_facets);
    contest.ask("WideBvh", 1, WideBvh::new);
    contest.ask("Bvh", 1, Bvh::new);
    contest.ask("TwoLevelGrid", SPACE, TwoLevelGrid::of_facets);
    contest.ask("Octree", SPACE, Octree::of_facets);
}

#[test]
fn over_the_bunny() {
    let mesh = scans::bunny().unwrap_or_else(|why| panic!("{why}"));
    all_agree("bunny", mesh, SPACE);
}

#[test]
fn over_the_dragon() {
    let mesh = scans::dragon().unwrap_or_else(|why| panic!("{why}"));
    all_agree("dragon", mesh, SPACE);
}

/// All of the teapot is in one cell of the grid, for which that scene is known.
#[test]
fn over_the_teapot_in_a_stadium() {
    all_agree("stadium", stadium::stadium(14).mesh, 200);
}

#[test]
fn over_a_terrain() {
    all_agree("terrain", terrain::terrain(707), SPACE);
}

#[test]
fn over_a_soup() {
    all_agree("soup", soup::soup(1_000_000, 1), SPACE);
}
