//! Chapter 19: lenses, and what is in focus.

mod aperture;
mod blur;
mod lens;
mod numbers;
mod samples;

use glam::{Vec2, Vec3, vec3};
use raybook::camera::aperture::Aperture;
use raybook::camera::pinhole::Pinhole;
use raybook::camera::thin_lens::ThinLens;

/// A camera of 50 mm that looks along −z, with a film of this size in metres.
fn camera(plane: Vec2, f_number: f32, focus: f32, aperture: Aperture) -> ThinLens {
    let from = vec3(0.3, -0.2, 1.0);
    let body = Pinhole::look_at(from, from - Vec3::Z, Vec3::Y, 0.05, 1.0).expect("a camera");
    ThinLens::new(&Pinhole { plane, ..body }, f_number, focus, aperture).expect("a lens")
}
