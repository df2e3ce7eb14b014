//! The teapot in the stadium, and what its rays cost in an accelerator.

use crate::shared::{daylight::Paint, daylight::picture};
use crate::shared::{heat::heat, heat::with_scale};
use glam::{Vec3, vec3};
use raybook::accel::Accel;
use raybook::camera::pinhole::Pinhole;
use raybook::image::{Image, rgb::Rgb};
use raybook::render::film::Film;
use raybook::scene::stadium::{Part, Stadium};
use raybook::shape::mesh::Facet;
use std::error::Error;

/// The stadium, the teapot close by, and for the second view the boxes and the triangles tested; `boxes` is what the
/// accelerator calls its boxes: "cells visited".
///
/// # Errors
/// If a label cannot be drawn.
pub fn figure(
    film: &Film,
    stadium: &Stadium,
    accel: &impl Accel<Facet>,
    boxes: &str,
) -> Result<Image, Box<dyn Error>> {
    let camera = |from, to| Pinhole::look_at(from, to, Vec3::Y, 0.035, film.aspect());
    let far = camera(vec3(-40.0, 15.0, 38.0), vec3(4.0, -2.0, -4.0))?;
    let near = camera(vec3(0.32, 0.36, 0.9), vec3(0.02, 0.17, 0.0))?;
    let shown = |camera| {
        picture(film, camera, &stadium.mesh, accel, |id| {
            paint(stadium.part(id))
        })
    };
    let heat = heat(film, |place| near.ray_through(place), accel);
    let maps = [
        ("the stadium".to_owned(), shown(&far)),
        ("the teapot on its centre spot".to_owned(), shown(&near)),
        heat.of_boxes(boxes),
        heat.of_triangles(),
    ];
    with_scale(2, &maps)
}

/// The look of each part.
pub fn paint(part: Part) -> Paint {
    let colour = match part {
        Part::Teapot => Rgb::new(0.80, 0.25, 0.06),
        Part::Ground => Rgb::new(0.20, 0.38, 0.11),
        Part::Lines => Rgb::gray(0.90),
        Part::Steps => Rgb::gray(0.55),
        Part::Seats => Rgb::new(0.10, 0.28, 0.62),
        Part::Roof => Rgb::gray(0.85),
    };
    Paint {
        colour,
        round: part == Part::Teapot,
    }
}
