//! What the questions are made of.

use crate::{Edge, sample};
use raybook::image::rgb::Rgb;
use raybook::light::point::PointLight;
use raybook::material::phong::Phong;
use raybook::math::dir3::Dir3;
use raybook::scene::description::{Backdrop, Description, Matter, Object};
use raybook_workbook::exercises::ch25_capstone::{Trace, TraceQuestion};
use glam::{Vec3, vec3};

const AMBIENT: Rgb = Rgb::new(0.4, 0.5, 0.6);
const SKY: Backdrop = Backdrop {
    below: Rgb::new(0.9, 0.8, 0.7),
    above: Rgb::new(0.1, 0.3, 0.95),
};
pub const RED: Rgb = Rgb::new(0.25, 0.05, 0.03);
pub const BLUE: Rgb = Rgb::new(0.03, 0.1, 0.2);
const GOLD: Rgb = Rgb::new(0.95, 0.7, 0.3);
/// Where the viewer is, in most of them.
const EYE: Vec3 = vec3(0.0, 0.0, 5.0);

/// A little aside of what is straight before the viewer.
pub const AHEAD: Vec3 = vec3(0.1, 0.15, -1.0);

/// A lamp beside the viewer.
pub const SIDE: PointLight = lamp(3.0, 4.0, 4.0, 60.0);

/// A question by name.
pub fn edge((name, question): (&'static str, TraceQuestion)) -> Edge<Trace> {
    Edge::new(name, question)
}

/// A question from the viewer's place.
pub fn ask(depth: u32, toward: Vec3, lamps: &[PointLight], objects: Vec<Object>) -> TraceQuestion {
    TraceQuestion {
        depth,
        ray: sample::ray(EYE, toward),
        scene: Description {
            ambient: AMBIENT,
            backdrop: SKY,
            lamps: lamps.to_vec(),
            objects,
        },
    }
}

pub fn from(origin: Vec3, mut question: TraceQuestion) -> TraceQuestion {
    question.ray.origin = origin;
    question
}

pub const fn lamp(x: f32, y: f32, z: f32, i: f32) -> PointLight {
    PointLight {
        position: vec3(x, y, z),
        intensity: Rgb::new(i, 0.9 * i, 0.8 * i),
    }
}

pub fn ball(x: f32, y: f32, z: f32, matter: Matter) -> Object {
    Object::sphere(vec3(x, y, z), 1.0, matter)
}

/// k_a and k_d differ, so that who mixes them up is seen.
pub fn shiny(colour: Rgb) -> Matter {
    Matter::Phong(Phong {
        ambient: colour * 2.0,
        diffuse: colour,
        specular: Rgb::new(0.3, 0.25, 0.2),
        exponent: 12.0,
    })
}

pub fn mirror() -> Matter {
    Matter::mirror(GOLD)
}

pub fn glass() -> Matter {
    Matter::glass(1.5)
}

/// A blue wall behind everything.
pub fn wall() -> Object {
    Object::plane(Dir3::Z, -2.0, shiny(BLUE))
}
