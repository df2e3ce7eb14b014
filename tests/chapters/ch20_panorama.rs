//! Chapter 20: the environment camera and the fisheye.

mod commands;
mod fisheye;
mod light;
mod panorama;
mod round_trip;
mod scene;

use glam::Vec3;
use rand::RngExt;
use raybook::camera::Camera;
use raybook::camera::{panorama::Panorama, pose::Pose};
use raybook::image::Image;
use raybook::image::rgb::Rgb;
use raybook::math::pcg;
use raybook::math::{dir3::Dir3, pcg::Pcg, ray::Ray};
use raybook::render::{film::Film, local::Local, shadow, whitted::Whitted};
use raybook::scene::world::Scene;

/// A direction, uniform on the sphere: a point in the ball, as long as it takes to find one.
fn direction(rng: &mut Pcg) -> Dir3 {
    loop {
        let p = Vec3::from_array(std::array::from_fn(|_| rng.random_range(-1.0..1.0)));
        if (0.01..1.0).contains(&p.length_squared()) {
            return Dir3::new_or(p, Dir3::X);
        }
    }
}

/// What a ray sees of the pavilion; its only light is the sun's, so that nothing is random.
fn seen(scene: &Scene, ray: &Ray) -> Rgb {
    let local = Local {
        samples: 1,
        arrives: Some(shadow::lit),
    };
    Whitted { local, depth: 4 }.radiance(scene, ray, &mut pcg::stream(1, 0))
}

/// One ray through the middle of each pixel.
fn film(width: usize, height: usize) -> Film<'static> {
    Film {
        seed: 1,
        threads: 2,
        ..Film::new(width, height, 1)
    }
}

/// A panorama of the scene from a point, with one ray for each pixel.
fn panorama(scene: &Scene, from: Vec3, width: usize) -> Image {
    let pose = Pose::level(from);
    let camera = Panorama { pose };
    film(width, width / 2).sample(|place, _| seen(scene, &camera.central_ray(place)))
}
