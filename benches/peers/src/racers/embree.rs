//! Embree 3, as its users call it: high or medium build quality, default flags, one ray at a time.

use crate::forest::Place;
use crate::meshes;
use crate::racer::{MISS, Question, Racer, Search};
use crate::racers::embree_tree;
use embree3::{
    BufferUsage, BuildQuality, Config, Device, Error, Format, GeometryKind, IntersectContext, Ray,
    RayHit, Scene, SceneFlags,
};
use glam::{Mat4, Quat, Vec2, Vec3};
use raybook::shape::{Hit, mesh::Mesh};
use raybook_peers::sah::Node;
use std::sync::Arc;
use std::sync::atomic::{AtomicIsize, Ordering};

/// A scene of one mesh, or of instances of one.
pub(crate) struct Embree {
    scene: Scene<'static>,
    /// What Embree has allocated since before the scene was made; the memory of the mesh's buffers counts too.
    bytes: usize,
    /// The quality with which its builder makes the same tree; none for instances, which are in two trees.
    quality: Option<BuildQuality>,
}

/// Builds it with high quality.
///
/// # Errors
/// If Embree fails.
pub(crate) fn build(scene: &meshes::Scene, threads: usize) -> Result<Box<dyn Racer>, String> {
    Ok(Box::new(Embree::new(&scene.mesh, threads)?))
}

/// Builds it with medium quality, which is Embree's default.
///
/// # Errors
/// If Embree fails.
pub(crate) fn build_medium(
    scene: &meshes::Scene,
    threads: usize,
) -> Result<Box<dyn Racer>, String> {
    let (medium, mesh) = (BuildQuality::MEDIUM, &scene.mesh);
    let of_mesh = |device: &Device| of_mesh(device, mesh, medium, SceneFlags::NONE);
    Ok(Box::new(Embree::with(threads, Some(medium), of_mesh)?))
}

/// Builds it in its robust mode, whose triangle test is watertight. There a build of high quality is one of medium quality.
///
/// # Errors
/// If Embree fails.
pub(crate) fn build_robust(
    scene: &meshes::Scene,
    threads: usize,
) -> Result<Box<dyn Racer>, String> {
    let mesh = &scene.mesh;
    let of_mesh = |device: &Device| of_mesh(device, mesh, BuildQuality::HIGH, SceneFlags::ROBUST);
    let told = Some(BuildQuality::MEDIUM);
    Ok(Box::new(Embree::with(threads, told, of_mesh)?))
}

/// Builds it of instances: a scene of the tree, and a scene of its places.
///
/// # Errors
/// If Embree fails, or the scene is no forest.
pub(crate) fn build_instances(
    scene: &meshes::Scene,
    threads: usize,
) -> Result<Box<dyn Racer>, String> {
    let forest = scene.forest.as_ref().ok_or("this scene has no instances")?;
    Ok(Box::new(Embree::with(threads, None, |device| {
        let (quality, flags) = (BuildQuality::HIGH, SceneFlags::NONE);
        let tree = of_mesh(device, &forest.tree, quality, flags)?;
        let mut all = empty(device, quality, flags)?;
        for place in &forest.places {
            let Place {
                scale,
                rotation,
                translation,
            } = *place;
            let rotation = Quat::from_mat3(&rotation);
            let place =
                Mat4::from_scale_rotation_translation(Vec3::splat(scale), rotation, translation);
            let mut instance = device.create_geometry(GeometryKind::INSTANCE)?;
            instance.set_instanced_scene(&tree);
            instance.set_transform(0, &place.to_cols_array());
            all.attach_geometry(&instance.commit());
        }
        all.commit();
        Ok(all)
    })?))
}

/// A scene with nothing in it.
fn empty(
    device: &Device,
    quality: BuildQuality,
    flags: SceneFlags,
) -> Result<Scene<'static>, Error> {
    let mut scene = device.create_scene()?;
    scene.set_build_quality(quality);
    scene.set_flags(flags);
    Ok(scene)
}

/// A scene of a mesh.
fn of_mesh(
    device: &Device,
    mesh: &Mesh,
    quality: BuildQuality,
    flags: SceneFlags,
) -> Result<Scene<'static>, Error> {
    let mut scene = empty(device, quality, flags)?;
    let mut geometry = device.create_geometry(GeometryKind::TRIANGLE)?;
    let positions: Vec<_> = mesh.positions().iter().map(Vec3::to_array).collect();
    geometry
        .set_new_buffer::<[f32; 3]>(BufferUsage::VERTEX, 0, Format::FLOAT3, 12, positions.len())?
        .copy_from_slice(&positions);
    let triangles = mesh.triangles();
    geometry
        .set_new_buffer::<[u32; 3]>(BufferUsage::INDEX, 0, Format::UINT3, 12, triangles.len())?
        .copy_from_slice(triangles);
    scene.attach_geometry(&geometry.commit());
    scene.commit();
    Ok(scene)
}

impl Embree {
    /// A scene of a mesh, made by this number of threads with high quality.
    ///
    /// # Errors
    /// If Embree fails.
    pub(crate) fn new(mesh: &Mesh, threads: usize) -> Result<Self, String> {
        let high = BuildQuality::HIGH;
        Self::with(threads, Some(high), |device| {
            of_mesh(device, mesh, high, SceneFlags::NONE)
        })
    }

    /// A scene that `make` makes with a device of this number of threads, whose tree has this quality.
    fn with(
        threads: usize,
        quality: Option<BuildQuality>,
        make: impl FnOnce(&Device) -> Result<Scene<'static>, Error>,
    ) -> Result<Self, String> {
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
        let scene = make(&device).map_err(told)?;
        match device.get_error() {
            Error::NONE => Ok(Self {
                scene,
                bytes: allocated.load(Ordering::Relaxed).max(0) as usize,
                quality,
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

    fn nodes(&self, mesh: &Mesh) -> Result<Vec<Node>, String> {
        let ask = |quality| embree_tree::nodes(mesh, quality);
        self.quality.map_or(Ok(Vec::new()), ask)
    }
}
