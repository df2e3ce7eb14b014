//! The line where light ends on a coarse mesh, with shadow rays from the facets and from the round surface.

use crate::kit::sheet::{Sheet, sheet};
use glam::{Vec3, vec3};
use raybook::accel::{Meshed, wide_bvh::WideBvh};
use raybook::camera::Camera;
use raybook::camera::pinhole::Pinhole;
use raybook::image::rgb::Rgb;
use raybook::light::directional::DirectionalLight;
use raybook::material::phong::Phong;
use raybook::math::dir3::Dir3;
use raybook::render::{film::Film, local::Local, shadow};
use raybook::scene::world::{Scene, Thing};
use raybook::shape::teapot;
use std::f32::consts::FRAC_1_PI;

/// A coarse teapot in the sun: shadow rays that start on its facets, and shadow rays that start on the round surface that the
/// facets stand for. Each patch has `cells` cells along each side.
pub(super) fn figure(film: &Film, cells: usize) -> Sheet {
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
    let pot = Meshed::new(teapot::mesh(cells), WideBvh::new);
    let scene = Scene::new(vec![Thing::new(pot, clay)], vec![Box::new(sun)])
        .surrounded_by(Rgb::gray(0.06), |_| Rgb::new(0.35, 0.4, 0.5));
    let eye = vec3(1.5, 3.6, 8.5);
    let camera = Pinhole::look_at(eye, vec3(0.0, 1.45, 0.0), Vec3::Y, 0.037, film.aspect())?;
    let local = Local {
        samples: 1,
        arrives: Some(shadow::lit),
    };
    let draw = |round: bool| {
        film.refine(|place, numbers| {
            let ray = camera.central_ray(place);
            let Some(mut seen) = scene.closest(&ray) else {
                return scene.behind_everything(&ray);
            };
            if !round {
                seen.surface.lift = Vec3::ZERO;
            }
            local
                .follow(&scene, &seen, -ray.direction, numbers)
                .radiance
        })
    };
    let tiles = [
        ("from the facet", draw(false)),
        ("from the round surface", draw(true)),
    ];
    sheet(2, &tiles)
}
