//! The line where light ends on a coarse mesh, before and after.

use crate::kit::figure::Figure;
use crate::kit::sheet::sheet;
use glam::{Vec3, vec3};
use raybook::accel::{Meshed, wide_bvh::WideBvh};
use raybook::camera::pinhole::Pinhole;
use raybook::image::rgb::Rgb;
use raybook::light::{Light, directional::DirectionalLight};
use raybook::material::phong::Phong;
use raybook::math::dir3::Dir3;
use raybook::render::{film::Film, local::Local, shadow};
use raybook::scene::world::{Scene, Thing};
use raybook::shape::teapot;
use std::f32::consts::FRAC_1_PI;

/// So few cells along the side of each of the teapot's patches.
const CELLS: usize = 4;

/// A coarse teapot in the sun: with facets that shadow themselves at once, and with the light taken away before.
pub(super) fn figure(film: &Film) -> Figure {
    let clay = Phong {
        ambient: Rgb::gray(0.8),
        diffuse: Rgb::gray(0.8 * FRAC_1_PI),
        specular: Rgb::BLACK,
        exponent: 1.0,
    };
    let sun = DirectionalLight {
        toward: Dir3::new_or(vec3(-1.0, 0.45, 0.1), Dir3::Y),
        irradiance: Rgb::gray(3.2),
    };
    let pot = Meshed::new(teapot::mesh(CELLS), WideBvh::new);
    let lights: Vec<Box<dyn Light>> = vec![Box::new(sun)];
    let scene = Scene::new(vec![Thing::new(pot, clay)], lights)
        .surrounded_by(Rgb::gray(0.06), |_| Rgb::new(0.35, 0.4, 0.5));
    let eye = vec3(1.5, 3.6, 8.5);
    let camera = Pinhole::look_at(eye, vec3(0.0, 1.45, 0.0), Vec3::Y, 0.037, film.aspect())?;
    let local = Local {
        samples: 1,
        arrives: Some(shadow::lit),
    };
    let draw = |softened: bool| {
        film.refine(|place, numbers| {
            let ray = camera.ray_through(place);
            let Some(seen) = scene.closest(&ray) else {
                return scene.behind_everything(&ray);
            };
            let view = -ray.direction;
            if softened {
                return local.follow(&scene, &seen, view, numbers).radiance;
            }
            let sample = sun.sample(seen.surface.position, glam::Vec2::ZERO);
            let arrives = sample.filter(|sample| shadow::lit(&scene, &seen.surface, sample));
            let lit = arrives.map(|sample| seen.material.lit(&seen.surface, view, &sample));
            seen.material.ambient(&seen.surface) * scene.ambient + lit.unwrap_or(Rgb::BLACK)
        })
    };
    let tiles = [
        ("each facet shadows itself", draw(false)),
        ("light taken away before", draw(true)),
    ];
    sheet(2, &tiles)
}
