//! Four mirror balls that touch each other: between them, mirrors show mirrors without end.

use glam::{Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::material::mirror::Mirror;
use raybook::math::dir3::Dir3;
use raybook::math::ray::Ray;
use raybook::scene::world::{Scene, Thing};
use raybook::shape::sphere::Sphere;

/// Where the camera stands, and where it looks: it sees the fourth ball through the gap between the other three.
pub const VIEW: [Vec3; 2] = [vec3(0.0, 0.0, 5.2), Vec3::ZERO];

/// The directions of three coloured lights in the backdrop, and their colours; there is a fourth behind the camera.
const GLOWS: [(Vec3, Rgb); 4] = [
    (vec3(0.0, 1.0, -0.1), Rgb::new(0.95, 0.60, 0.05)),
    (vec3(-0.87, -0.5, -0.1), Rgb::new(0.01, 0.35, 0.75)),
    (vec3(0.87, -0.5, -0.1), Rgb::new(0.80, 0.16, 0.03)),
    (vec3(0.0, 0.0, 1.0), Rgb::new(0.45, 0.47, 0.50)),
];

/// Balls of radius 1 at the corners of a regular tetrahedron, one behind the other three; no lights but the backdrop.
pub fn scene() -> Scene {
    let share = Rgb::gray(0.93);
    let (r, behind) = (2.0 / 3.0_f32.sqrt(), -(8.0 / 3.0_f32).sqrt());
    let corner = |turns: f32| {
        let (y, x) = (std::f32::consts::TAU * turns).sin_cos();
        vec3(r * x, r * y, 0.0)
    };
    let centres = [
        corner(0.25),
        corner(0.25 + 1.0 / 3.0),
        corner(0.25 + 2.0 / 3.0),
        vec3(0.0, 0.0, behind),
    ];
    let ball = |centre| -> Thing { Thing::new(Sphere::new(centre, 1.0), Mirror { share }) };
    Scene::new(centres.map(ball).into(), Vec::new()).surrounded_by(Rgb::BLACK, glows)
}

/// Soft lights in four directions on a pale ground.
fn glows(ray: &Ray) -> Rgb {
    let pale = Rgb::new(0.10, 0.11, 0.13);
    let glow = |(toward, colour): (Vec3, Rgb)| {
        let toward = Dir3::new_or(toward, Dir3::Y);
        colour * ray.direction.dot(*toward).max(0.0).powi(2)
    };
    pale + GLOWS.map(glow).into_iter().sum()
}
