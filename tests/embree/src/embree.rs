//! Embree behind raybook's question: what does this ray hit first?

use embree3::{
    BufferUsage, Config, Device, DeviceProperty, Error, Format, Geometry, GeometryKind,
    IntersectContext, Isa, RayHit, Scene, SceneFlags,
};
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
        Self::with(None)
    }

    /// A device that uses these instructions, or the best.
    ///
    /// # Errors
    /// If Embree does not start, or this processor lacks the instructions.
    pub fn with(isa: Option<Isa>) -> Result<Self, String> {
        let threads = 1; // to build a tree; thousands of scenes of one triangle need no more
        Device::with_config(Config {
            isa,
            threads,
            ..Config::default()
        })
        .map(Self)
        .map_err(told)
    }

    /// The library's version: "3.13.5".
    ///
    /// # Errors
    /// If Embree does not tell.
    pub fn version(&self) -> Result<String, String> {
        let part = |property| self.0.get_property(property).map_err(told);
        Ok(format!(
            "{}.{}.{}",
            part(DeviceProperty::VERSION_MAJOR)?,
            part(DeviceProperty::VERSION_MINOR)?,
            part(DeviceProperty::VERSION_PATCH)?
        ))
    }

    /// A scene of one shape, ready to be asked.
    ///
    /// # Errors
    /// If Embree refuses the shape, or has no memory left.
    pub fn scene(&self, solid: &Solid, mode: Mode) -> Result<Oracle, String> {
        let mut scene = self.0.create_scene().map_err(told)?;
        if mode == Mode::Robust {
            scene.set_flags(SceneFlags::ROBUST);
        }
        scene.attach_geometry(&self.geometry(solid).map_err(told)?);
        scene.commit();
        match self.0.get_error() {
            Error::NONE => Ok(Oracle(scene)),
            error => Err(told(error)),
        }
    }

    fn geometry(&self, solid: &Solid) -> Result<Geometry<'static>, Error> {
        use BufferUsage as Use;
        Ok(match solid {
            Solid::Triangles(mesh) => {
                let mut geometry = self.0.create_geometry(GeometryKind::TRIANGLE)?;
                let positions: Vec<_> = mesh.positions().iter().map(Vec3::to_array).collect();
                geometry
                    .set_new_buffer::<[f32; 3]>(
                        Use::VERTEX,
                        0,
                        Format::FLOAT3,
                        12,
                        positions.len(),
                    )?
                    .copy_from_slice(&positions);
                let triangles = mesh.triangles();
                geometry
                    .set_new_buffer::<[u32; 3]>(Use::INDEX, 0, Format::UINT3, 12, triangles.len())?
                    .copy_from_slice(triangles);
                geometry.commit()
            }
            Solid::Sphere(sphere) => {
                let mut geometry = self.0.create_geometry(GeometryKind::SPHERE_POINT)?;
                geometry
                    .set_new_buffer::<[f32; 4]>(Use::VERTEX, 0, Format::FLOAT4, 16, 1)?
                    .copy_from_slice(&[sphere.center.extend(sphere.radius).to_array()]);
                geometry.commit()
            }
        })
    }
}

/// Embree's errors are no Rust errors: they only print.
fn told(error: Error) -> String {
    format!("Embree: {error}")
}

/// A scene of Embree that answers raybook's question.
pub struct Oracle(Scene<'static>);

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
        let mut answer = RayHit::from(embree3::Ray::segment(o, d, within.min, within.max));
        self.0
            .intersect(&mut IntersectContext::incoherent(), &mut answer);
        let hit = answer.hit;
        hit.is_valid().then(|| Answer {
            t: answer.ray.tfar,
            id: hit.primID,
            uv: Vec2::from(hit.barycentric()),
            normal: *Dir3::new_or(Vec3::from(hit.normal()), Dir3::Y),
        })
    }
}
