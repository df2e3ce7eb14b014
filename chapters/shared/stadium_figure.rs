//! The teapot in the stadium, and what its rays cost in an accelerator.

use crate::kit::sheet::Sheet;
use crate::shared::daylight::{Paint, shade};
use crate::shared::heat::{heat, with_scale};
use crate::shared::outdoors::sky;
use glam::{Vec3, vec3};
use raybook::accel::{Accel, wide_bvh::WideBvh};
use raybook::camera::Camera;
use raybook::camera::pinhole::Pinhole;
use raybook::image::rgb::Rgb;
use raybook::math::interval::Interval;
use raybook::render::film::Film;
use raybook::scene::stadium::{Part, Stadium};
use raybook::shape::mesh::Facet;

/// The stadium, a near view of the teapot, and for the near view the boxes and the triangles tested; `boxes` is the name of the
/// accelerator's boxes: "cells visited".
///
/// # Errors
/// If a label cannot be drawn.
pub fn figure(film: &Film, stadium: &Stadium, accel: &impl Accel<Facet>, boxes: &str) -> Sheet {
    let camera = |from, to| Pinhole::look_at(from, to, Vec3::Y, 0.035, film.aspect());
    let far = camera(vec3(-40.0, 15.0, 38.0), vec3(4.0, -2.0, -4.0))?;
    let near = camera(vec3(0.32, 0.36, 0.9), vec3(0.02, 0.17, 0.0))?;
    // The pictures are the same with any structure; the heat maps are those of `accel`.
    let tree = WideBvh::new(stadium.mesh.facets());
    // From afar, the lines of the field are thinner than a pixel.
    let fine = Film {
        samples: 2 * film.samples,
        ..*film
    };
    let shown = |camera: &Pinhole| {
        fine.refine(|place, _| {
            let ray = camera.central_ray(place);
            tree.closest(&ray, Interval::AHEAD)
                .map_or(sky(ray.direction), |(_, hit)| {
                    let at = stadium.mesh.surface(&ray, &hit);
                    shade(&at, paint(stadium.part(hit.id)), &ray, &tree)
                })
        })
    };
    let heat = heat(film, |place| near.central_ray(place), accel);
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
