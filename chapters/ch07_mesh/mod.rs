//! Triangles that share their corners can follow any surface. Normals at the corners, interpolated in between, make it
//! look smooth, and texture coordinates tell where on it we are. The search for the nearest triangle still tests every triangle.
//!
//! New: accel/mod.rs accel/list.rs shape/attributes.rs shape/mesh.rs shape/bezier.rs shape/teapot.rs
//! New: shape/triangle_watertight.rs shape/mesh_file.rs shape/word.rs shape/obj.rs shape/stl.rs shape/ply/mod.rs

mod letters;

use crate::kit::chapter;
use crate::kit::sheet::sheet;
use crate::kit::stage::{Drawn, Stage};
use crate::shared::own_mesh::{self, MeshKnob};
use crate::shared::showroom;
use crate::shared::showroom::{FLAT, Look, NORMALS, SMOOTH, Showroom, TEXTURE};
use crate::shared::stock_picture;
use clap::Args;
use raybook::accel::{Accel, Meshed, Tests, list::List, wide_bvh::WideBvh};
use raybook::image::Image;
use raybook::math::{interval::Interval, ray::Ray, slab};
use raybook::render::film::Film;
use raybook::shape::mesh::{Facet, Mesh};
use raybook::shape::{Hit, Shape, teapot};
use raybook_scenes::gallery;
use std::error::Error;
use std::hint::black_box;
use std::process::ExitCode;
use std::sync::atomic::{AtomicU64, Ordering};

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    #[command(flatten)]
    own: MeshKnob,
    /// Cells along each side of the teapot's 32 patches; twice as many cells make four times as many triangles, and take four
    /// times as long
    #[arg(long, value_name = "1..24 cells", default_value = "5")]
    cells: usize,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    if let Some(path) = &knobs.own.mesh {
        let mesh = own_mesh::load(path)?;
        let film = own_mesh::film_of_list(stage, &mesh);
        warn_of_long_search(&film, &mesh);
        return draw_mesh(stage, &film, &mesh).map(|_| ());
    }
    let n = knobs.cells;
    let teapot = teapot::mesh(n);
    let film = draw_mesh(stage, &own_mesh::film_of_list(stage, &teapot), &teapot)?;
    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    if stage.wants("tessellation") {
        let tile = |n| {
            let [smooth] = looks(&film, &teapot::mesh(n), [SMOOTH]);
            smooth
        };
        let tiles = [
            ("2 × 2 per patch", tile(2)),
            ("3 × 3", tile(3)),
            (&format!("{n} × {n}"), tile(n)),
        ];
        let caption = format!(
            "The teapot's 32 patches cut into 4, 9 and {} quadrilaterals each. With interpolated normals the surface looks round \
            even with few triangles; the outline does not.",
            n * n
        );
        stage.figure("tessellation", &caption, &sheet(3, &tiles)?)?;
    }

    if !stage.wants("china") {
        return Ok(());
    }
    let caption = "A picture and a normal map on the teapot. Both are looked up by the interpolated texture coordinates: the picture \
        gives the colour of the china, and the normal map tilts the interpolated normal. The surface looks hammered, and the \
        outline shows that it is not. Later lessons bring the light.";
    let film = stage.film_of(400, 8, 32.0 / 21.0);
    stock_picture::draw(stage, &film, gallery::TEAPOT, "china", caption)
}

/// Says how long the search takes for a mesh of the user's own, and what is faster if that is long.
fn warn_of_long_search(film: &Film, mesh: &Mesh) {
    own_mesh::warn_of_list(mesh);
    let room = Showroom::around(mesh, film.aspect());
    let shape = Meshed::new(mesh.clone(), List::new);
    own_mesh::say_estimate(film, |place| {
        black_box(nearest(&shape, &room.ray(place), &mut Tests::default()));
    });
}

/// Draws any mesh. Returns the film of the small pictures, for further sheets.
fn draw_mesh<'a>(stage: &'a Stage, film: &Film, mesh: &Mesh) -> Result<Film<'a>, Box<dyn Error>> {
    let triangles = mesh.triangles().len();
    if stage.wants("picture") {
        let (main, tests) = picture(film, mesh);
        let caption = format!(
            "A mesh of {triangles} triangles. Every ray that meets the mesh's box is tested against all triangles: {} million tests.",
            tests / 1_000_000
        );
        stage.picture("picture", &caption, &main)?;
    }
    let names = [
        "one normal per triangle",
        "normals interpolated",
        "these normals as colours",
        "texture coordinates",
    ];
    let film = showroom::small(&stage.film_of(900, 16, film.aspect()));
    if stage.wants("attributes") {
        let looks = looks(&film, mesh, [FLAT, SMOOTH, NORMALS, TEXTURE]);
        let tiles: Vec<_> = names.into_iter().zip(looks).collect();
        let caption = "The same triangles four times: with the normal of each triangle, with interpolated vertex normals, with these normals as colours, and with a checkerboard on the texture coordinates.";
        stage.figure("attributes", caption, &sheet(2, &tiles)?)?;
    }
    Ok(film)
}

/// The picture of a mesh, and how many triangles were tested for it.
fn picture(film: &Film, mesh: &Mesh) -> (Image, u64) {
    let room = Showroom::around(mesh, film.aspect());
    let shape = Meshed::new(mesh.clone(), List::new);
    let tests = AtomicU64::new(0);
    let image = film.refine(|place, _| {
        let ray = room.ray(place);
        let mut count = Tests::default();
        let hit = nearest(&shape, &ray, &mut count);
        tests.fetch_add(count.shapes, Ordering::Relaxed);
        match hit {
            Some(hit) => SMOOTH(&ray, &hit, &shape.surface(&ray, &hit)),
            None => room.backdrop(place, &ray),
        }
    });
    (image, tests.into_inner())
}

/// The nearest of a mesh's triangles: if the ray meets the mesh's box, all triangles are tested.
fn nearest(shape: &Meshed<List<Facet>>, ray: &Ray, count: &mut Tests) -> Option<Hit> {
    slab::clip(&shape.bounds(), ray, Interval::AHEAD)?;
    let closest = shape.facets().closest_counted(ray, Interval::AHEAD, count);
    closest.map(|(_, hit)| hit)
}

/// A picture of a mesh in each of these looks. They are the same with any structure; the fastest one leaves time
/// for many samples.
fn looks<const N: usize>(film: &Film, mesh: &Mesh, looks: [Look; N]) -> [Image; N] {
    let room = Showroom::around(mesh, film.aspect());
    let shape = Meshed::new(mesh.clone(), WideBvh::new);
    looks.map(|look| {
        film.refine(|place, _| {
            let ray = room.ray(place);
            match shape.hit(&ray, Interval::AHEAD) {
                Some(hit) => look(&ray, &hit, &shape.surface(&ray, &hit)),
                None => room.backdrop(place, &ray),
            }
        })
    })
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch07_mesh")
}
