//! Boxes in boxes, and triangles in the smallest boxes: a ray that misses a box misses everything in the box. The tree follows
//! the triangles, not space, and how it is built decides how fast it is searched.
//!
//! New: accel/bvh/mod.rs accel/bvh/pair.rs accel/bvh/validate.rs accel/bvh/build/mod.rs accel/bvh/build/item.rs
//! New: accel/bvh/build/tree.rs accel/bvh/build/top_down.rs accel/bvh/build/halves.rs accel/bvh/build/cost.rs
//! New: accel/bvh/build/sweep.rs accel/bvh/build/binned.rs accel/bvh/build/fine.rs accel/bvh/build/bottom_up.rs
//! New: accel/bvh/build/flat.rs

mod builders;
mod flat_boxes;
mod letters;
mod mountains;
mod structures;
mod three_stages;
mod tree_levels;

use crate::kit::chapter;
use crate::kit::knobs;
use crate::kit::numbers::grouped;
use crate::kit::stage::{Drawn, Stage};
use crate::shared::own_mesh::{self, MeshKnob};
use crate::shared::{growth, heat, outdoors::sky_above, showroom, showroom::Showroom, speeds};
use builders::Builder;
use clap::Args;
use glam::{Vec3, vec3};
use raybook::accel::{Accel, bvh::Bvh};
use raybook::camera::Camera;
use raybook::camera::pinhole::Pinhole;
use raybook::math::{interval::Interval, ray::Ray};
use raybook::render::film::Film;
use raybook::scene::terrain::terrain;
use raybook::shape::mesh::Mesh;
use raybook::shape::teapot;
use std::process::ExitCode;
use structures::{Building, Structure};

const AHEAD: Interval = Interval::AHEAD;

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    #[command(flatten)]
    own: MeshKnob,
    /// Structure to search; --method builds bvh and wide-bvh, --leaf limits the leaves of bvh, in `heat`
    #[arg(long, value_enum, default_value = "bvh")]
    structure: Structure,
    /// Method by which the trees are built, in `levels`
    #[arg(long, value_enum, default_value = "binned")]
    method: Builder,
    /// Maximum number of triangles in a leaf; the heuristic makes smaller leaves where these cost less, in `heat`
    #[arg(long, value_name = "1..64 triangles", default_value = "8")]
    leaf: u32,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let building = Building {
        method: knobs.method.into(),
        leaf: knobs.leaf,
    };
    let structure = knobs.structure;
    if let Some(path) = &knobs.own.mesh {
        let build = |mesh: &Mesh| structure.build(mesh.facets(), building);
        return match structure {
            Structure::List => own_mesh::draw_by_list(stage, path),
            _ => own_mesh::draw(stage, path, build, structure.boxes()),
        };
    }
    let film = stage.film_of(960, 8, 1.78);
    if stage.wants("picture") {
        draw_mountains(&film, stage, building)?;
    }
    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    if stage.wants("stages") {
        let caption = "The three stages: a box around each triangle, boxes around boxes, and the tree as an array without pointers.";
        stage.diagram("stages", caption, &three_stages::draw()?)?;
    }
    if stage.wants("organisations") {
        let caption = "Two trees over the same 22 triangles. In the left tree, the boxes are large and long, and they overlap. The \
            cost is the expected work of a search.";
        stage.diagram("organisations", caption, &flat_boxes::two_organisations()?)?;
    }
    let teapot = teapot::mesh(24);
    if stage.wants("builders") {
        let (builders, caption) = builders::figure(&teapot.facets())?;
        stage.diagram("builders", &caption, &builders)?;
    }
    if stage.wants("growth") {
        let caption = "The work for a ray in a soup of triangles: a list tests all triangles; with a tree, the number of tests \
            grows with the logarithm of the number of triangles.";
        stage.diagram("growth", caption, &growth::list_and_tree()?)?;
    }
    let film = showroom::small(&film);
    draw_teapot(&film, stage, &teapot, knobs)
}

fn draw_mountains(film: &Film, stage: &Stage, building: Building) -> Drawn {
    let mesh = terrain(400);
    let tree = Bvh::with_leaves(mesh.facets(), building.method, building.leaf);
    let (eye, to) = (vec3(-3.9, 2.0, 4.3), vec3(0.3, 0.62, -0.7));
    let camera = Pinhole::look_at(eye, to, Vec3::Y, 0.044, film.aspect())?;
    let sun = mountains::toward_sun();
    let picture = film.refine(|place, _| {
        let ray = camera.central_ray(place);
        let Some((_, hit)) = tree.closest(&ray, AHEAD) else {
            return sky_above(mountains::AIR_ENDS, ray.direction);
        };
        let at = mesh.surface(&ray, &hit);
        let faces_sun = at.shading_normal.dot(*sun) > 0.0;
        let in_sunlight = faces_sun && !tree.any(&at.leave(sun), AHEAD);
        mountains::shade(&at, hit.t, in_sunlight)
    });
    let caption = format!(
        "{} triangles in the evening sun. Each ray of the camera is tested against a few dozen triangles, and so is each shadow \
        ray from the hit towards the sun.",
        grouped(mesh.triangles().len() as f64)
    );
    stage.picture("picture", &caption, &picture)
}

fn draw_teapot(
    film: &Film,
    stage: &Stage,
    mesh: &Mesh,
    &Knobs {
        structure,
        method,
        leaf,
        ..
    }: &Knobs,
) -> Drawn {
    let building = Building {
        method: method.into(),
        leaf,
    };
    let room = Showroom::around(mesh, film.aspect());
    if stage.wants("levels") {
        let tree = Bvh::with_leaves(mesh.facets(), building.method, building.leaf);
        let caption = format!(
            "The boxes of some levels of the teapot's tree, built by the method “{}”. The deeper the level, the closer the boxes follow the shape of the teapot.",
            knobs::word(&method)
        );
        let room = Showroom::around_box(mesh, &mesh.bounds(), film.aspect());
        let figure = tree_levels::figure(film, &room, &tree, &[2, 5, 8, 11])?;
        stage.figure("levels", &caption, &figure)?;
    }
    if stage.wants("heat") {
        let accel = structure.build(mesh.facets(), building);
        let map = match structure {
            Structure::List => heat::coarse(film, |place| room.ray(place), &accel),
            _ => heat::heat(film, |place| room.ray(place), &accel),
        };
        let caption = format!("What each ray costs. {}", structure.work());
        stage.figure("heat", &caption, &map.figure(structure.boxes())?)?;
    }

    if !stage.wants("speeds") {
        return Ok(());
    }
    let built = Structure::TAUGHT.map(|one| (one.name(), one.build(mesh.facets(), building)));
    let searches = built
        .each_ref()
        .map(|(name, accel)| (*name, |ray: &Ray| accel.closest(ray, AHEAD).is_some()));
    let searchers = searches
        .each_ref()
        .map(|(name, search)| (*name, search as &dyn Fn(&Ray) -> bool));
    let figure = speeds::figure(
        &speeds::rays(film, |place| room.ray(place)),
        &searchers,
        &format!(
            "the camera's rays, a teapot of {} triangles",
            mesh.triangles().len()
        ),
    )?;
    let caption = "How many rays of the camera each structure answers per second on one thread, for the same teapot.";
    stage.diagram("speeds", caption, &figure)
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch11_bvh")
}
