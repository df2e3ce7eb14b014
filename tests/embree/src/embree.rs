//! Embree behind raybook's question: what does this ray hit first?

use crate::library::{Device, RayHit, Scene};
use glam::{Vec2, Vec3};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook_common::oracle::judge::Answer;
use raybook_common::oracle::target::Solid;

/// How Embree intersects triangles. Spheres know no difference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// By the method of Möller and Trumbore, for speed.
    Fast,
    /// By Plücker coordinates, watertight at shared edges.
    Robust,
}

/// An Embree device: where scenes are made.
pub struct Embree(Device);

impl Embree {
    /// A device that uses the best instructions of this processor.
    ///
    /// # Errors
    /// If Embree does not start.
    pub fn new() -> Result<Self, String> {
        // One thread, to build a tree: thousands of scenes of one triangle need no more.
        Device::new(c"threads=1").map(Self)
    }

    /// A device that uses the instructions that every x86-64 processor has.
    ///
    /// # Errors
    /// If Embree does not start.
    pub fn of_sse2() -> Result<Self, String> {
        Device::new(c"threads=1,isa=sse2").map(Self)
    }

    /// The library's version: "3.13.5".
    pub fn version(&self) -> String {
        self.0.version().map(|part| part.to_string()).join(".")
    }

    /// A scene of one shape, ready to be asked.
    ///
    /// # Errors
    /// If Embree refuses the shape, or has no memory left.
    pub fn scene(&self, solid: &Solid, mode: Mode) -> Result<Oracle, String> {
        let robust = mode == Mode::Robust;
        let scene = match solid {
            Solid::Triangles(mesh) => {
                let positions: Vec<_> = mesh.positions().iter().map(Vec3::to_array).collect();
                self.0.triangles(&positions, mesh.triangles(), robust)
            }
            Solid::Sphere(sphere) => {
                let sphere = sphere.center.extend(sphere.radius).to_array();
                self.0.sphere(sphere, robust)
            }
        };
        scene.map(Oracle)
    }
}

/// A scene of Embree that answers raybook's question.
pub struct Oracle(Scene);

impl Oracle {
    /// The nearest hit within the interval; whether its ends belong to it, `tests/facts.rs` tells.
    ///
    /// # Panics
    /// If the interval begins before 0, where Debian's Embree would end the process by an assertion of its own,
    /// or if the ray is not finite.
    pub fn closest(&self, ray: &Ray, within: Interval) -> Option<Answer> {
        assert!(
            ray.origin.is_finite() && ray.direction.is_finite() && within.min >= 0.0,
            "Embree takes finite rays and intervals from 0, not {ray:?} {within:?}"
        );
        let (o, d) = (ray.origin.to_array(), ray.direction.to_array());
        let mut answer = RayHit::new(o, d, within.min, within.max);
        self.0.intersect(&mut answer);
        answer.is_hit().then(|| Answer {
            t: answer.far,
            id: answer.primitive,
            uv: Vec2::from(answer.uv),
            normal: *Dir3::new_or(Vec3::from(answer.normal), Dir3::Y),
        })
    }
}
