//! A processor does eight sums in the time of one. So a node gets eight children, whose boxes are tested at once, and a
//! leaf gets eight triangles. The tree becomes a third as high, and a search more than twice as fast.
//!
//! New: accel/wide_bvh/mod.rs accel/wide_bvh/avx2.rs accel/wide_bvh/avx512.rs accel/wide_bvh/batch.rs accel/wide_bvh/build.rs
//! New: accel/wide_bvh/collapse.rs accel/wide_bvh/fours.rs accel/wide_bvh/kernel.rs accel/wide_bvh/lanes.rs accel/wide_bvh/nearest.rs accel/wide_bvh/node.rs
//! New: accel/wide_bvh/optimal.rs accel/wide_bvh/portable.rs accel/wide_bvh/ray.rs accel/wide_bvh/search.rs
//! New: accel/wide_bvh/refit.rs accel/wide_bvh/stack.rs accel/wide_bvh/tree.rs accel/wide_bvh/validate.rs accel/wide_bvh/walk.rs

mod confetti;
mod eight_boxes;
mod letters;
mod wide_gain;
mod wide_trees;

use crate::kit::stage::{Drawn, Stage};
use crate::kit::{chapter, numbers::grouped};
use crate::shared::own_mesh::{self, MeshKnob};
use crate::shared::{heat, showroom};
use clap::Args;
use confetti::Confetti;
use raybook::accel::bvh::Bvh;
use raybook::accel::wide_bvh::WideBvh;
use raybook::camera::Camera;
use raybook::sample::even::Even;
use raybook::shape::mesh::Mesh;
use std::cell::LazyCell;
use std::process::ExitCode;
use std::sync::atomic::AtomicU64;
use std::sync::atomic::Ordering::Relaxed;

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    #[command(flatten)]
    own: MeshKnob,
    /// Pieces of confetti; each piece is a triangle
    #[arg(long, value_name = "100..2000000 pieces", default_value = "120000")]
    pieces: u32,
    /// Rays towards the sky from each point that is seen
    #[arg(long, value_name = "1..256 rays", default_value = "1")]
    sky_rays: u16,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    if let Some(path) = &knobs.own.mesh {
        let wide = |mesh: &Mesh| WideBvh::new(mesh.facets());
        return own_mesh::draw(stage, path, wide, "nodes visited");
    }
    let film = stage.film_of(960, 8, 1.78);
    let confetti = Confetti::new(knobs.pieces);
    let tree = WideBvh::new(confetti.mesh.facets());
    let camera = confetti::camera(confetti::EYE, film.aspect());
    if stage.wants("picture") {
        let rays = AtomicU64::new(0);
        let follow = |place, numbers: &mut Even| {
            let ray = camera.central_ray(place);
            let seen = confetti.follow(&ray, &tree, knobs.sky_rays, numbers);
            rays.fetch_add(seen.rays, Relaxed);
            seen
        };
        let picture = film.denoised(&[], |film| film.evenly(follow));
        let caption = format!(
            "A teapot in a heap of confetti, {} triangles. {:.1} million rays make this picture: from each point that is seen, one \
            ray goes towards the sun, and {} towards the sky. A filter has removed the remaining noise.",
            grouped(confetti.mesh.triangles().len() as f64),
            rays.into_inner() as f64 / 1e6,
            knobs.sky_rays
        );
        stage.picture("picture", &caption, &picture)?;
    }

    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    if stage.wants("collapse") {
        let caption = "How a binary tree becomes a wide one. The blue branches stay. The white branches are replaced by their \
            children, the branch with the largest box first.";
        stage.diagram("collapse", caption, &wide_trees::draw()?)?;
    }
    if stage.wants("boxes") {
        let caption = "Eight boxes and one ray. All lanes do the same sums at once. A box is met where the largest distance of entry \
            is not above the smallest distance of leaving. The row “turn” tells the order in which the boxes are visited.";
        stage.diagram("boxes", caption, &eight_boxes::draw()?)?;
    }

    let mesh = &confetti.mesh;
    let (two, rays) = (
        LazyCell::new(|| Bvh::new(mesh.facets())),
        LazyCell::new(|| wide_gain::rays(mesh, 60_000)),
    );
    if stage.wants("steps") {
        let caption = "The same triangles and the same 60 000 rays. In a wide tree a ray takes far fewer steps. It tests many \
            more triangles, but all triangles of a leaf, up to eight, in one step.";
        stage.diagram("steps", caption, &wide_gain::steps(&rays, &two, &tree)?)?;
    }
    if stage.wants("gain") {
        let note = format!(
            "rays between random points of a sphere, {} triangles",
            mesh.triangles().len()
        );
        let caption = "The speed after each step, measured when this figure was drawn: the wide tree with plain arithmetic, with vector instructions, and with sixteen rays that take turns.";
        stage.diagram(
            "gain",
            caption,
            &wide_gain::gain(&rays, &two, &tree, &note)?,
        )?;
    }
    if !stage.wants("heat") {
        return Ok(());
    }
    let caption = "The work for each ray of the camera, on the same scale as the maps of the other structures.";
    let heat = heat::heat(&showroom::small(&film), |p| camera.central_ray(p), &tree);
    stage.figure("heat", caption, &heat.figure("nodes visited")?)
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch24_wide_bvh")
}
