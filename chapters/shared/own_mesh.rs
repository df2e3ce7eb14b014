//! A user's own mesh in the showroom, searched by the structure that a chapter is about.

use crate::kit::say::complain;
use crate::kit::stage::{Drawn, Stage};
use crate::kit::untrusted::Untrusted;
use crate::shared::heat::{Heat, coarse, heat};
use crate::shared::showroom::{SMOOTH, Showroom, small};
use clap::Args;
use glam::{Vec2, vec2};
use raybook::accel::{Accel, list::List};
use raybook::math::interval::Interval;
use raybook::render::film::Film;
use raybook::shape::mesh::{Facet, Mesh};
use raybook::shape::mesh_file::{self, LoadError};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// The knob of a chapter that can draw any mesh.
#[derive(Args, Clone, Debug)]
pub struct MeshKnob {
    /// Draw this mesh (.obj, .stl or .ply) instead of the chapter's scenes
    #[arg(long, value_name = "FILE")]
    pub mesh: Option<PathBuf>,
}

/// Reads a mesh, and says how many triangles it has.
///
/// # Errors
/// Those of [`mesh_file::load`].
pub fn load(path: &Path) -> Result<Mesh, LoadError> {
    let mesh = mesh_file::load(path)?;
    let (name, triangles) = (Untrusted::from(path), mesh.triangles().len());
    complain(format_args!("{name}: {triangles} triangles"));
    Ok(mesh)
}

/// Draws a mesh by the structure that `build` makes of its facets, and what each ray costs; `boxes` is what the structure calls
/// its boxes: "cells visited".
///
/// # Errors
/// If the file is no mesh, or a picture cannot be drawn or written.
pub fn draw<A: Accel<Facet>>(
    stage: &Stage,
    path: &Path,
    build: impl FnOnce(&Mesh) -> A,
    boxes: &str,
) -> Drawn {
    let mesh = load(path)?;
    let film = stage.film_of(960, 4, 1.6);
    let (room, accel) = draw_picture(stage, &film, &mesh, build)?;
    let map = || heat(&small(&film), |place| room.ray(place), &accel);
    draw_heat(stage, map, boxes)
}

/// As [`draw`], by a list. The picture is so small that it does not take long; if it takes long all the same, a warning is
/// printed.
///
/// # Errors
/// As for [`draw`].
pub fn draw_by_list(stage: &Stage, path: &Path) -> Drawn {
    let mesh = load(path)?;
    warn_of_list(&mesh);
    let film = film_of_list(stage, &mesh);
    let (room, list) = draw_picture(stage, &film, &mesh, |mesh| List::new(mesh.facets()))?;
    let map = || coarse(&film, |place| room.ray(place), &list);
    draw_heat(stage, map, "boxes tested")
}

/// Says what is faster, if a mesh is too large for a list.
pub fn warn_of_list(mesh: &Mesh) {
    /// A teapot has some thousands of triangles; the scans that people have, some hundred thousand and more.
    const MANY: usize = 100_000;
    if mesh.triangles().len() >= MANY {
        complain(
            "note: a list tests every triangle for each ray; `ch11_bvh --mesh` draws the same mesh with a tree, in seconds",
        );
    }
}

/// A film on which a mesh in a list takes a few seconds, whatever its number of triangles.
pub fn film_of_list<'a>(stage: &'a Stage, mesh: &Mesh) -> Film<'a> {
    let triangles = mesh.triangles().len();
    let width = (4.9e8 / triangles as f32).sqrt().clamp(160.0, 640.0);
    stage.film_of(width as u32, 4, 1.6)
}

/// Draws the main picture of a mesh; returns the room that the mesh is in, and its structure.
fn draw_picture<A: Accel<Facet>>(
    stage: &Stage,
    film: &Film,
    mesh: &Mesh,
    build: impl FnOnce(&Mesh) -> A,
) -> Result<(Showroom, A), Box<dyn Error>> {
    let start = Instant::now();
    let accel = build(mesh);
    complain(format_args!(
        "built in {}",
        duration(start.elapsed().as_secs_f64())
    ));
    let room = Showroom::around(mesh, film.aspect());
    if stage.wants("picture") {
        say_estimate(film, |place| {
            let ray = room.ray(place);
            if let Some((_, hit)) = accel.closest(&ray, Interval::AHEAD) {
                SMOOTH(&ray, &hit, &mesh.surface(&ray, &hit));
            }
        });
        let picture = film.refine(|place, _| {
            let ray = room.ray(place);
            match accel.closest(&ray, Interval::AHEAD) {
                Some((_, hit)) => SMOOTH(&ray, &hit, &mesh.surface(&ray, &hit)),
                None => room.backdrop(place, &ray),
            }
        });
        let caption = format!("A mesh of {} triangles.", mesh.triangles().len());
        stage.picture("picture", &caption, &picture)?;
    }
    Ok((room, accel))
}

fn draw_heat(stage: &Stage, map: impl FnOnce() -> Heat, boxes: &str) -> Drawn {
    if !stage.wants("heat") {
        return Ok(());
    }
    let map = map();
    let each = |sum: u64| sum as f64 / map.rays().max(1) as f64;
    let caption = format!(
        "What each ray of the picture costs: {:.1} {boxes} and {:.1} triangles tested, on average.",
        each(map.tests().boxes),
        each(map.tests().shapes)
    );
    stage.figure("heat", &caption, &map.figure(boxes)?)
}

/// Number of rays that are tried before a picture is drawn.
const TRIED: u16 = 64;

/// Tries a few rays, evenly over the picture, and prints an estimate of the time for all rays.
pub fn say_estimate(film: &Film, mut follow: impl FnMut(Vec2)) {
    let start = Instant::now();
    for i in 0..TRIED {
        // Evenly over the picture; rays that follow each other are not neighbours.
        let across = f32::from(i) * 0.618_034 % 1.0;
        follow(vec2(across, f32::from(i) / f32::from(TRIED)));
    }
    let each = start.elapsed().as_secs_f64() / f64::from(TRIED);
    let rays = (film.width * film.height * film.samples) as f64;
    let time = duration(each * rays / film.threads as f64);
    complain(format_args!("the picture takes about {time}"));
}

/// A time, in the unit that people would say.
fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 1.0 => format!("{:.0} ms", 1e3 * s),
        s if s < 120.0 => format!("{s:.0} s"),
        s => format!("{:.0} min", s / 60.0),
    }
}
