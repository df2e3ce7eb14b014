//! The scene of the picture: balls, one of them a mirror and one of glass, on a floor with a box, a pyramid and a teapot, under a lamp.

use glam::{Vec2, Vec3, vec2, vec3};
use raybook::image::rgb::Rgb;
use raybook::math::dir3::Dir3;
use raybook_workbook::exercises::ch01_rays::CameraRay;

/// A shape that is asked about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// A sphere.
    Ball {
        /// Its centre, in metres.
        center: Vec3,
        /// Its radius, in metres.
        radius: f32,
    },
    /// The plane y = 0.
    Floor,
    /// An axis-aligned box, by its least and its greatest corner.
    Block([Vec3; 2]),
    /// A triangle.
    Triangle([Vec3; 3]),
    /// The teapot, a mesh.
    Teapot,
}

/// What a surface is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Made {
    /// It only scatters light.
    Matte,
    /// A mirror, over its colour.
    Mirror,
    /// Glass.
    Glass,
}

/// A shape and its looks.
#[derive(Clone, Copy, Debug)]
pub struct Thing {
    /// Its shape.
    pub shape: Shape,
    /// Its diffuse colour.
    pub colour: Rgb,
    /// What it is made of.
    pub made: Made,
}

/// Where the lamp hangs, in metres, and its intensity in W/sr.
pub const LAMP: (Vec3, Rgb) = (vec3(-3.0, 6.0, 4.0), Rgb::new(150.0, 145.0, 135.0));
/// The index of refraction of the glass.
pub const GLASS: f32 = 1.5;

/// Everything that can be seen.
pub fn things() -> Vec<Thing> {
    let thing = |shape, [r, g, b]: [f32; 3], made| Thing {
        shape,
        colour: Rgb::new(r, g, b),
        made,
    };
    let ball = |center, radius| Shape::Ball { center, radius };
    let mut all = vec![
        thing(
            ball(vec3(-1.7, 1.0, -1.0), 1.0),
            [0.2, 0.35, 0.7],
            Made::Mirror,
        ),
        thing(
            ball(vec3(0.3, 0.7, 0.6), 0.7),
            [0.25, 0.6, 0.45],
            Made::Glass,
        ),
        thing(
            ball(vec3(1.5, 0.35, 1.4), 0.35),
            [0.85, 0.45, 0.15],
            Made::Matte,
        ),
        thing(
            ball(vec3(-0.7, 0.25, 1.7), 0.25),
            [0.75, 0.2, 0.3],
            Made::Matte,
        ),
        thing(Shape::Floor, [0.55, 0.55, 0.52], Made::Matte),
        thing(
            Shape::Block([vec3(0.9, 0.0, -2.6), vec3(2.3, 1.5, -1.4)]),
            [0.7, 0.6, 0.25],
            Made::Matte,
        ),
    ];
    let top = vec3(2.6, 1.1, 0.2);
    let feet = [
        [2.0, 0.0, 0.8],
        [3.2, 0.0, 0.8],
        [3.2, 0.0, -0.4],
        [2.0, 0.0, -0.4],
    ]
    .map(Vec3::from);
    let faces = (0..4).map(|i| Shape::Triangle([feet[i], feet[(i + 1) % 4], top]));
    all.push(thing(Shape::Teapot, [0.2, 0.6, 0.65], Made::Matte));
    all.extend(faces.map(|face| thing(face, [0.5, 0.35, 0.65], Made::Matte)));
    all
}

/// The question of the camera's ray through a place on the film.
pub fn camera(film: Vec2) -> CameraRay {
    let eye = vec3(0.6, 1.9, 7.0);
    let forward = Dir3::new_or(vec3(0.35, 0.75, 0.0) - eye, -Dir3::Z);
    let right = Dir3::new_or(forward.cross(Vec3::Y), Dir3::X);
    CameraRay {
        focal_point: eye,
        forward,
        right,
        up: Dir3::new_or(right.cross(*forward), Dir3::Y),
        focal_length: 0.035,
        plane: vec2(0.036, 0.02025),
        film,
    }
}

/// What is seen of the sky in a direction.
pub fn sky(direction: Vec3) -> Rgb {
    let up = (0.5 + 0.5 * direction.y).clamp(0.0, 1.0);
    Rgb::new(0.85, 0.88, 0.92) * (1.0 - up) + Rgb::new(0.25, 0.45, 0.8) * up
}
