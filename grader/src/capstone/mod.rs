//! A picture that grows with a student's work: a scene of which everything is seen whose function is written.
//!
//! The program is asked for the rays, the hits, the normals, the light and the shadows of a whole picture, a list of questions at a
//! time. Only camera rays, normals and the light of a lamp are the course's own where they are not written yet.

mod functions;
mod light;
mod nearest;
mod normals;
mod onward;
mod scene;
mod teapot;
mod trace;

pub use functions::Functions;

use crate::picture::progressive::{MISSING, passes, spread};
use glam::vec2;
use raybook::image::Image;
use std::io;
use trace::Tracer;

/// What a function adds to the picture.
#[derive(Clone, Copy, Debug)]
pub struct Part {
    /// The exercise's name.
    pub exercise: &'static str,
    /// What is seen when it is written.
    pub adds: &'static str,
}

/// What the picture is made of, in the order of the course.
pub const PARTS: [Part; 15] = [
    part("camera_ray", "your own camera"),
    part("sphere_hit", "balls"),
    part("sphere_normal", "the directions of the balls' surfaces"),
    part("plane_hit", "a floor"),
    part("box_clip", "a box"),
    part("triangle_hit", "a pyramid"),
    part("triangle_normal", "the directions of the pyramid's faces"),
    part("mesh_hit", "a teapot"),
    part("interpolate_normal", "the teapot's smooth surface"),
    part("vertex_normals", "the directions at the teapot's vertices"),
    part("phong", "light and highlights"),
    part("point_light", "your own lamp"),
    part("reflect", "a mirror"),
    part("refract", "glass"),
    part("shadow_ray", "shadows"),
];

const fn part(exercise: &'static str, adds: &'static str) -> Part {
    Part { exercise, adds }
}

/// Draws the picture, and shows it after each pass with the side of its blocks in pixels: coarse first.
///
/// # Errors
/// If the program cannot be started, or what is shown cannot be kept.
pub fn draw(
    functions: &mut Functions<'_>,
    [width, height]: [u32; 2],
    show: &mut dyn FnMut(&Image, u32) -> io::Result<()>,
) -> io::Result<()> {
    let mut tracer = Tracer::new(functions);
    let mut picture = Image::from_fn(width as usize, height as usize, |_, _| MISSING);
    for (block, pixels) in passes(width, height) {
        let film = |&(x, y): &(u32, u32)| {
            vec2(
                (x as f32 + 0.5) / width as f32,
                (y as f32 + 0.5) / height as f32,
            )
        };
        let colours = tracer.seen(&pixels.iter().map(film).collect::<Vec<_>>())?;
        for ((x, y), colour) in pixels.into_iter().zip(colours) {
            picture.set(x as usize, y as usize, colour);
        }
        show(&spread(&picture, block), block)?;
    }
    Ok(())
}
