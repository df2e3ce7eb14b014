//! Described scenes as rows.

use crate::choice::choice_of;
use crate::row::{Row, RowError, Words, row_of};
use glam::Vec3;
use raybook::image::rgb::Rgb;
use raybook::light::point::PointLight;
use raybook::material::{mirror::Mirror, phong::Phong};
use raybook::math::dir3::Dir3;
use raybook::scene::description::{Backdrop, Clear, Corners, Description, Form, Matter, Object};
use raybook::shape::{plane::Plane, sphere::Sphere};

row_of!(Description {
    ambient: Rgb,
    backdrop: Backdrop,
    lamps: Vec<PointLight>,
    objects: Vec<Object>,
});

row_of!(Backdrop {
    below: Rgb,
    above: Rgb
});

row_of!(PointLight {
    position: Vec3,
    intensity: Rgb
});

impl Row for Object {
    const ALONE: bool = true;

    fn names(name: &str) -> Vec<String> {
        [Form::names(name), Matter::names(name)].concat()
    }

    fn write(&self) -> String {
        [self.form.write(), self.matter.write()].join("  ")
    }

    fn read(words: &mut Words<'_>, name: &str) -> Result<Self, RowError> {
        Ok(Self {
            form: Form::read(words, name)?,
            matter: Matter::read(words, name)?,
        })
    }
}

choice_of!(Form {
    "sphere": Sphere(Sphere),
    "plane": Plane(Plane),
    "triangle": Triangle(Corners),
});

row_of!(Sphere {
    center: Vec3,
    radius: f32
});

row_of!(Plane {
    normal: Dir3,
    offset: f32
});

row_of!(Corners {
    p0: Vec3,
    p1: Vec3,
    p2: Vec3
});

choice_of!(Matter {
    "phong": Phong(Phong),
    "mirror": Mirror(Mirror),
    "glass": Glass(Clear),
});

row_of!(Phong {
    ambient: Rgb,
    diffuse: Rgb,
    specular: Rgb,
    exponent: f32
});

row_of!(Mirror { share: Rgb });

row_of!(Clear { index: f32 });
