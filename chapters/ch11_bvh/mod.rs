//! Boxes in boxes, and triangles in the smallest: a ray that misses a box misses all that is in it. The tree follows the
//! triangles, not space, and how it is built decides how fast it is searched.
//!
//! New: accel/bvh/mod.rs accel/bvh/pair.rs accel/bvh/validate.rs accel/bvh/build/mod.rs accel/bvh/build/item.rs
//! New: accel/bvh/build/tree.rs accel/bvh/build/top_down.rs accel/bvh/build/halves.rs accel/bvh/build/cost.rs
//! New: accel/bvh/build/sweep.rs accel/bvh/build/binned.rs accel/bvh/build/fine.rs accel/bvh/build/bottom_up.rs
//! New: accel/bvh/build/flat.rs

mod builders;
mod flat_boxes;
mod mountains;
mod three_stages;
mod tree_levels;

use crate::kit::chapter;
use crate::kit::numbers::grouped;
use crate::kit::stage::{Drawn, Stage};
use crate::shared::own_mesh::{self, MeshKnob};
use crate::shared::{growth, heat, outdoors::sky, showroom, showroom::Showroom, speeds};
use builders::Builder;
use clap::Args;
use glam::{Vec3, vec3};
use raybook::accel::two_level_grid::TwoLevelGrid;
use raybook::accel::{Accel, bvh::Bvh, grid::Grid, list::List, octree::Octree};
use raybook::camera::pinhole::Pinhole;
use raybook::math::interval::Interval;
use raybook::render::film::Film;
use raybook::scene::terrain::terrain;
use raybook::shape::mesh::{Facet, Mesh};
use raybook::shape::teapot;
use std::process::ExitCode;

const AHEAD: Interval = Interval::AHEAD;

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    #[command(flatten)]
    own: MeshKnob,
    /// How the trees are built, in `levels`
    #[arg(long, value_enum, default_value = "binned")]
    method: Builder,
    /// Maximum number of triangles in a leaf; the heuristic makes smaller leaves where that costs less, in `heat`
    #[arg(long, value_name = "1..64 triangles", default_value_t = 8)]
    leaf: u32,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let build = |mesh: &Mesh| Bvh::with_leaves(mesh.facets(), knobs.method.into(), knobs.leaf);
    if let Some(path) = &knobs.own.mesh {
        return own_mesh::draw(stage, path, build, "boxes tested");
    }
    let film = stage.film_of(960, 4, 1.78);
    let mesh = terrain(400);
    let tree = build(&mesh);
    let (eye, to) = (vec3(-3.9, 2.0, 4.3), vec3(0.3, 0.62, -0.7));
    let camera = Pinhole::look_at(eye, to, Vec3::Y, 0.044, film.aspect())?;
    let sun = mountains::toward_sun();
    let picture = film.refine(|place, _| {
        let ray = camera.ray_through(place);
        let Some((_, hit)) = tree.closest(&ray, AHEAD) else {
            return sky(ray.direction);
        };
        let at = mesh.surface(&ray, &hit);
        let faces_sun = at.shading_normal.dot(*sun) > 0.0;
        let in_sunlight = faces_sun && !tree.any(&at.leave(sun), AHEAD);
        mountains::shade(&at, hit.t, in_sunlight)
    });
    let caption = format!(
        "{} triangles in the evening sun. A ray is tested against a few dozen of them, and so is the shadow ray that goes from the hit towards the sun.",
        grouped(mesh.triangles().len() as f64)
    );
    stage.picture("picture", &caption, &picture)?;
    let caption = "The three stages: a box around each triangle, boxes around boxes, and the tree as an array without pointers.";
    stage.diagram("stages", caption, &three_stages::draw()?)?;
    let caption = "Two trees over the same 22 triangles. In the left tree, the boxes are large and long, and they overlap. The cost tells how much work this means.";
    stage.diagram("organisations", caption, &flat_boxes::two_organisations()?)?;
    let teapot = teapot::mesh(24);
    let (builders, caption) = builders::figure(&teapot.facets())?;
    stage.diagram("builders", &caption, &builders)?;
    let caption = "The work for a ray in a soup of triangles: a list tests all triangles; with a tree, the number of tests grows with the logarithm of their number.";
    stage.diagram("growth", caption, &growth::list_and_tree()?)?;
    draw_teapot(&showroom::small(&film), stage, &teapot, &build(&teapot))
}

fn draw_teapot(film: &Film, stage: &Stage, mesh: &Mesh, tree: &Bvh<Facet>) -> Drawn {
    let room = Showroom::around(mesh, film.aspect());
    let caption = "The boxes of some levels of the teapot's tree. The deeper the level, the closer the boxes follow the shape of the teapot.";
    let figure = tree_levels::figure(film, &room, tree, &[2, 5, 8, 11])?;
    stage.figure("levels", caption, &figure)?;
    let caption = "What each ray costs. The work is where rays pass close by the surface: these rays meet many boxes before they hit anything.";
    let heat = heat::heat(film, |place| room.ray(place), tree);
    stage.figure("heat", caption, &heat.figure("boxes tested")?)?;

    let facets = || mesh.facets();
    let (list, grid) = (List::new(facets()), Grid::of_facets(facets()));
    let two_level = TwoLevelGrid::of_facets(facets());
    let octree = Octree::of_facets(facets());
    let figure = speeds::figure(
        &speeds::rays(film, |place| room.ray(place)),
        &[
            ("list", &|ray| list.closest(ray, AHEAD).is_some()),
            ("grid", &|ray| grid.closest(ray, AHEAD).is_some()),
            ("two-level grid", &|ray| {
                two_level.closest(ray, AHEAD).is_some()
            }),
            ("octree", &|ray| octree.closest(ray, AHEAD).is_some()),
            ("BVH", &|ray| tree.closest(ray, AHEAD).is_some()),
        ],
        &format!(
            "the camera's rays, a teapot of {} triangles",
            mesh.triangles().len()
        ),
    )?;
    let caption =
        "How many rays of the camera each structure answers in a second, over the same teapot.";
    stage.diagram("speeds", caption, &figure)
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch11_bvh")
}
