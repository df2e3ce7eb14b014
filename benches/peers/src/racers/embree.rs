//! Embree 3, as its users call it: high build quality, default flags, one ray at a time.

use crate::racer::{MISS, Question, Racer, Search};
use embree3::{
    BufferUsage, BuildQuality, Config, Device, Error, Format, GeometryKind, IntersectContext, Ray,
    RayHit, Scene, SceneFlags,
};
use glam::{Vec2, Vec3};
use raybook::shape::{Hit, mesh::Mesh};
use std::sync::Arc;
use std::sync::atomic::{AtomicIsize, Ordering};

/// A scene of one mesh.
pub(crate) struct Embree {
    scene: Scene<'static>,
    /// What Embree has allocated since before the scene was made; the memory of the mesh's buffers counts too.
    bytes: usize,
}

/// Builds it.
///
/// # Errors
/// If Embree fails.
pub(crate) fn build(mesh: &Mesh, threads: usize) -> Result<Box<dyn Racer>, String> {
    Ok(Box::new(Embree::new(mesh, threads)?))
}

/// Builds it in its robust mode, whose triangle test is watertight.
///
/// # Errors
/// If Embree fails.
pub(crate) fn build_robust(mesh: &Mesh, threads: usize) -> Result<Box<dyn Racer>, String> {
    Ok(Box::new(Embree::with(mesh, threads, SceneFlags::ROBUST)?))
}

impl Embree {
    /// A scene of high build quality (Embree's own default is medium), made by this number of threads.
    ///
    /// # Errors
    /// If Embree fails.
    pub(crate) fn new(mesh: &Mesh, threads: usize) -> Result<Self, String> {
        Self::with(mesh, threads, SceneFlags::NONE)
    }

    fn with(mesh: &Mesh, threads: usize, flags: SceneFlags) -> Result<Self, String> {
        let told = |error: Error| format!("Embree: {error}");
        let config = Config {
            threads: threads as u32,
            ..Config::default()
        };
        let device = Device::with_config(config).map_err(told)?;
        let allocated = Arc::new(AtomicIsize::new(0));
        let sum = Arc::clone(&allocated);
        device.set_memory_monitor_function(move |bytes, _| {
            sum.fetch_add(bytes, Ordering::Relaxed);
            true
        });
        let mut scene = device.create_scene().map_err(told)?;
        scene.set_build_quality(BuildQuality::HIGH);
        scene.set_flags(flags);
        let mut geometry = device
            .create_geometry(GeometryKind::TRIANGLE)
            .map_err(told)?;
        let positions: Vec<_> = mesh.positions().iter().map(Vec3::to_array).collect();
        geometry
            .set_new_buffer::<[f32; 3]>(BufferUsage::VERTEX, 0, Format::FLOAT3, 12, positions.len())
            .map_err(told)?
            .copy_from_slice(&positions);
        let triangles = mesh.triangles();
        geometry
            .set_new_buffer::<[u32; 3]>(BufferUsage::INDEX, 0, Format::UINT3, 12, triangles.len())
            .map_err(told)?
            .copy_from_slice(triangles);
        scene.attach_geometry(&geometry.commit());
        scene.commit();
        match device.get_error() {
            Error::NONE => Ok(Self {
                scene,
                bytes: allocated.load(Ordering::Relaxed).max(0) as usize,
            }),
            error => Err(told(error)),
        }
    }

    /// The nearest hit: `rtcIntersect1`.
    pub(crate) fn hit(&self, (ray, within): &Question) -> Option<Hit> {
        let (o, d) = (ray.origin.to_array(), ray.direction.to_array());
        let mut answer = RayHit::from(Ray::segment(o, d, within.min, within.max));
        let mut context = IntersectContext::incoherent();
        self.scene.intersect(&mut context, &mut answer);
        let hit = answer.hit;
        hit.is_valid().then(|| Hit {
            t: answer.ray.tfar,
            uv: Vec2::from(hit.barycentric()),
            id: hit.primID,
        })
    }
}

impl Search for Embree {
    fn closest(&self, question: &Question) -> f32 {
        self.hit(question).map_or(MISS, |hit| hit.t)
    }

    /// `rtcOccluded1`.
    fn any(&self, (ray, within): &Question) -> bool {
        let (o, d) = (ray.origin.to_array(), ray.direction.to_array());
        let mut segment = Ray::segment(o, d, within.min, within.max);
        let mut context = IntersectContext::incoherent();
        self.scene.occluded(&mut context, &mut segment)
    }

    fn bytes(&self) -> Option<usize> {
        Some(self.bytes)
    }
}
