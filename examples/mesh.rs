//! A mesh from a file, or the teapot, in gold: `cargo run --release --example mesh -- my.obj`

use raybook::prelude::*;
use raybook::shape::{mesh_file, teapot};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mesh = match std::env::args_os().nth(1) {
        Some(file) => mesh_file::load(file.as_ref())?,
        None => teapot::mesh(12),
    };
    let (middle, size) = (mesh.bounds().center(), mesh.bounds().size().length());
    let gold = Thing::new(Meshed::new(mesh, WideBvh::new), Conductor(Metal::GOLD));
    let sky = |ray: &Ray| Rgb::gray(0.6 + 0.4 * ray.direction.y);
    let scene = Scene::new(vec![gold], vec![]).surrounded_by(Rgb::BLACK, sky);
    let film = Film::new(480, 360, 32);
    let eye = middle + size * vec3(0.4, 0.35, 0.9);
    let camera = Pinhole::look_at(eye, middle, Vec3::Y, 0.035, film.aspect())?;
    let picture = film.render(&camera, &Sampler::Even, &Path::WHOLE, &scene);
    Ok(file::save("mesh.png".as_ref(), &picture)?)
}
