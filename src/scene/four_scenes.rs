//! Four described scenes of increasing difficulty, to test a complete ray tracer.
//!
//! ```
//! use raybook::scene::four_scenes::FOUR;
//!
//! assert_eq!(FOUR.map(|staged| staged.name), ["spheres", "lamps", "mirrors", "glass"]);
//! assert_eq!((FOUR[0].scene)().objects.len(), 4); // three balls and a plane
//! ```

use crate::image::rgb::Rgb;
use crate::light::point::PointLight;
use crate::math::dir3::Dir3;
use crate::scene::description::{Backdrop, Description, Matter, Object};
use glam::{Vec3, vec3};

/// A scene with its camera.
#[derive(Clone, Copy, Debug)]
pub struct Staged {
    /// The scene's name.
    pub name: &'static str,
    /// The alternative text of the picture, for people who cannot see it.
    pub alt: &'static str,
    /// The scene.
    pub scene: fn() -> Description,
    /// The maximum number of surfaces along one path.
    pub depth: u32,
    /// The camera's place, and the point in the middle of its picture, in metres.
    pub view: [Vec3; 2],
    /// The camera's focal length, in metres.
    pub focal_length: f32,
}

/// Width over height of the pictures.
pub const ASPECT: f32 = 1.5;

/// The scenes, the easiest first.
pub const FOUR: [Staged; 4] = [
    Staged {
        name: "spheres",
        alt: "Three glossy balls on a plane, and their shadows in the light of one lamp",
        scene: spheres,
        depth: 1,
        view: [vec3(0.0, 2.2, 6.5), vec3(0.0, 0.75, 0.0)],
        focal_length: 0.036,
    },
    Staged {
        name: "lamps",
        alt: "A pyramid and a ball before a wall, and their coloured shadows in the light of three lamps",
        scene: lamps,
        depth: 1,
        view: [vec3(0.4, 2.3, 6.6), vec3(0.1, 0.95, 0.0)],
        focal_length: 0.036,
    },
    Staged {
        name: "mirrors",
        alt: "Two mirror balls and a pyramid of gold that show each other, coloured balls and the sky",
        scene: mirrors,
        depth: 5,
        view: [vec3(0.0, 2.4, 6.6), vec3(0.0, 0.8, 0.0)],
        focal_length: 0.036,
    },
    Staged {
        name: "glass",
        alt: "A ball of glass in which all is upside down, a ball with a bubble, a pyramid of glass and a mirror ball, before a wall",
        scene: glass,
        depth: 6,
        view: [vec3(0.0, 2.0, 6.6), vec3(0.0, 0.85, 0.0)],
        focal_length: 0.036,
    },
];

const RED: Rgb = Rgb::new(0.26, 0.04, 0.02);
const OCHRE: Rgb = Rgb::new(0.27, 0.16, 0.02);
const BLUE: Rgb = Rgb::new(0.02, 0.1, 0.2);
const GREEN: Rgb = Rgb::new(0.02, 0.14, 0.09);
const SAND: Rgb = Rgb::new(0.25, 0.22, 0.18);
const CREAM: Rgb = Rgb::new(0.28, 0.27, 0.24);

const AMBIENT: Rgb = Rgb::new(0.7, 0.75, 0.85);
const DAY: Backdrop = Backdrop {
    below: Rgb::new(0.95, 0.9, 0.8),
    above: Rgb::new(0.2, 0.42, 0.72),
};

fn spheres() -> Description {
    Description {
        ambient: AMBIENT,
        backdrop: DAY,
        lamps: vec![lamp(vec3(-5.0, 8.0, 6.0), Rgb::new(240.0, 222.0, 192.0))],
        objects: vec![
            Object::plane(Dir3::Y, 0.0, matte(SAND)),
            Object::sphere(vec3(-1.7, 0.9, 0.1), 0.9, glossy(BLUE, 30.0)),
            Object::sphere(vec3(0.25, 1.2, -0.9), 1.2, glossy(OCHRE, 120.0)),
            Object::sphere(vec3(1.75, 0.65, 0.8), 0.65, glossy(RED, 60.0)),
        ],
    }
}

fn lamps() -> Description {
    let mut objects = vec![
        Object::plane(Dir3::Y, 0.0, matte(SAND)),
        Object::plane(Dir3::Z, -2.5, matte(CREAM)),
        Object::sphere(vec3(1.6, 0.8, 0.3), 0.8, glossy(CREAM, 60.0)),
    ];
    objects.extend(pyramid(
        [[-0.77, 0.83], [-0.14, -1.06], [-2.09, -0.67]],
        0.0,
        vec3(-1.0, 2.1, -0.3),
        &glossy(OCHRE, 40.0),
    ));
    Description {
        ambient: Rgb::new(0.25, 0.25, 0.3),
        backdrop: DAY,
        lamps: vec![
            lamp(vec3(-4.0, 4.0, 4.0), Rgb::new(70.0, 24.0, 10.0)),
            lamp(vec3(0.5, 5.0, 4.5), Rgb::new(26.0, 30.0, 22.0)),
            lamp(vec3(4.5, 3.5, 3.5), Rgb::new(8.0, 26.0, 58.0)),
        ],
        objects,
    }
}

fn mirrors() -> Description {
    let gold = Matter::mirror(Rgb::new(0.95, 0.75, 0.4));
    let mut objects = vec![
        Object::plane(Dir3::Y, 0.0, matte(SAND)),
        Object::sphere(
            vec3(-1.6, 1.1, -0.4),
            1.1,
            Matter::mirror(Rgb::new(0.94, 0.95, 0.96)),
        ),
        Object::sphere(vec3(0.35, 0.45, 1.5), 0.45, glossy(RED, 60.0)),
        Object::sphere(vec3(-0.75, 0.3, 1.75), 0.3, glossy(GREEN, 60.0)),
        Object::sphere(vec3(0.35, 0.75, -1.5), 0.75, glossy(BLUE, 60.0)),
    ];
    objects.extend(pyramid(
        [[1.97, 0.88], [2.58, -0.93], [0.7, -0.55]],
        0.0,
        vec3(1.75, 1.9, -0.2),
        &gold,
    ));
    Description {
        ambient: AMBIENT,
        backdrop: DAY,
        lamps: vec![lamp(vec3(-4.0, 8.0, 6.5), Rgb::new(230.0, 214.0, 188.0))],
        objects,
    }
}

fn glass() -> Description {
    let glass = Matter::glass(1.5);
    let mut objects = vec![
        Object::plane(Dir3::Y, 0.0, matte(SAND)),
        Object::plane(Dir3::Z, -4.0, matte(CREAM)),
        Object::sphere(vec3(-0.4, 1.05, 0.6), 1.0, glass.clone()),
        Object::sphere(vec3(1.6, 0.75, 0.9), 0.7, glass.clone()),
        Object::sphere(vec3(1.6, 0.75, 0.9), 0.6, Matter::glass(0.667)),
        Object::sphere(
            vec3(1.0, 1.1, -1.8),
            1.1,
            Matter::mirror(Rgb::new(0.94, 0.95, 0.96)),
        ),
        Object::sphere(vec3(-1.0, 0.6, -2.2), 0.6, glossy(RED, 60.0)),
        Object::sphere(vec3(2.6, 0.6, -1.2), 0.6, glossy(BLUE, 60.0)),
    ];
    objects.extend(pyramid(
        [[-2.19, 0.78], [-1.75, -0.53], [-3.11, -0.26]],
        0.02,
        vec3(-2.35, 1.72, 0.0),
        &glass,
    ));
    Description {
        ambient: Rgb::new(1.1, 1.1, 1.15),
        backdrop: DAY,
        lamps: vec![
            lamp(vec3(-3.0, 5.5, 3.0), Rgb::new(60.0, 52.0, 42.0)),
            lamp(vec3(3.5, 5.0, 3.0), Rgb::new(26.0, 30.0, 36.0)),
        ],
        objects,
    }
}

/// Three sides and the base of a pyramid; the base's corners x, z at height y run counter-clockwise as seen from above.
fn pyramid(base: [[f32; 2]; 3], y: f32, top: Vec3, matter: &Matter) -> [Object; 4] {
    let [a, b, c] = base.map(|[x, z]| vec3(x, y, z));
    let sides = [[a, b, top], [b, c, top], [c, a, top], [a, c, b]];
    sides.map(|corners| Object::triangle(corners, matter.clone()))
}

fn lamp(position: Vec3, intensity: Rgb) -> PointLight {
    PointLight {
        position,
        intensity,
    }
}

fn matte(colour: Rgb) -> Matter {
    Matter::phong(colour, 0.0, 1.0)
}

fn glossy(colour: Rgb, exponent: f32) -> Matter {
    Matter::phong(colour, 0.25, exponent)
}
