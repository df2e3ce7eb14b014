//! A described scene, as its words say.

use crate::alternatives::student::Question;
use glam::DVec3;

pub struct Scene {
    pub ambient: DVec3,
    pub below: DVec3,
    pub above: DVec3,
    pub lamps: Vec<(DVec3, DVec3)>,
    pub objects: Vec<(Form, Matter)>,
}

pub enum Form {
    Sphere(DVec3, f64),
    Plane(DVec3, f64),
    Triangle([DVec3; 3]),
}

pub enum Matter {
    Phong {
        ambient: DVec3,
        diffuse: DVec3,
        specular: DVec3,
        exponent: f64,
    },
    Mirror(DVec3),
    Glass(f64),
}

impl Scene {
    pub fn read(q: &mut Question) -> Self {
        Self {
            ambient: q.vector(),
            below: q.vector(),
            above: q.vector(),
            lamps: q.list(|q| (q.vector(), q.vector())),
            objects: q.list(|q| (Form::read(q), Matter::read(q))),
        }
    }
}

impl Form {
    fn read(q: &mut Question) -> Self {
        match q.word().as_str() {
            "sphere" => Self::Sphere(q.vector(), q.number()),
            "plane" => Self::Plane(q.vector(), q.number()),
            "triangle" => Self::Triangle([q.vector(), q.vector(), q.vector()]),
            word => panic!("`{word}` is no shape"),
        }
    }
}

impl Matter {
    fn read(q: &mut Question) -> Self {
        match q.word().as_str() {
            "phong" => Self::Phong {
                ambient: q.vector(),
                diffuse: q.vector(),
                specular: q.vector(),
                exponent: q.number(),
            },
            "mirror" => Self::Mirror(q.vector()),
            "glass" => Self::Glass(q.number()),
            word => panic!("`{word}` is no material"),
        }
    }
}
