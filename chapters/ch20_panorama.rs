//! # Panorama
//!
//! A ray can start anywhere and go anywhere, so a camera need not have an image plane. One whose film holds all directions
//! takes a picture that is an environment map; a fisheye sees nearly as much, in a disc.
//!
//! New: camera/pose.rs camera/panorama.rs camera/fisheye.rs scene/pavilion.rs scene/summer.rs

use raybook::camera::{panorama::Panorama, pose::Pose};
use raybook::lab::chapter;
use raybook::lab::stage::{Drawn, Stage};
use raybook::render::local::Local;
use raybook::render::{shadow, whitted::Whitted};
use raybook::scene::pavilion;
use std::process::ExitCode;

/// Draws the chapter's pictures.
pub(crate) fn draw(stage: &Stage) -> Drawn {
    let film = stage.film_of(960, 9, 2.0);
    let camera = Panorama {
        pose: Pose::level(pavilion::EYE),
    };
    let local = Local {
        samples: 1,
        arrives: shadow::lit,
    };
    let whitted = Whitted { local, depth: 8 };
    let scene = pavilion::scene();
    let picture =
        film.render(|place, rng| whitted.radiance(&scene, &camera.ray_through(place), rng));
    stage.picture("picture", "All around.", &picture)
}

fn main() -> ExitCode {
    chapter::run("ch20_panorama", draw)
}
