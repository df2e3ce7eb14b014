//! Embree 4, from a library that the environment names: no Debian package has it, but wheels for Python do.
#![expect(
    unsafe_code,
    reason = "functions of a C library that is loaded while the program runs"
)]

use crate::meshes::Scene;
use crate::racer::{MISS, Question, Racer, Search};
use libloading::Library;
use raybook::shape::mesh::Mesh;
use std::ffi::{CString, c_char, c_int, c_uint, c_void};
use std::path::PathBuf;
use std::ptr::null_mut;
use std::sync::atomic::{AtomicIsize, Ordering};

/// The environment's variable that names the library.
const NAME: &str = "RAYBOOK_EMBREE4";

/// What Embree has allocated since it was last asked, of all its devices.
static ALLOCATED: AtomicIsize = AtomicIsize::new(0);

/// `RTCMemoryMonitorFunction`: Embree tells of memory that it takes, and, below 0, that it gives back.
unsafe extern "C" fn monitor(_: *mut c_void, bytes: isize, _post: bool) -> bool {
    ALLOCATED.fetch_add(bytes, Ordering::Relaxed);
    true
}

/// Whether the environment names a library.
pub(crate) fn is_here() -> bool {
    std::env::var_os(NAME).is_some()
}

/// A device, a scene or a geometry of Embree's.
type Handle = *mut c_void;

/// `RTCRay` and `RTCHit` of `rtcore_ray.h`, and some bytes to spare: versions differ in how many instances a hit names.
#[repr(C, align(16))]
struct RayHit {
    origin: [f32; 3],
    near: f32,
    direction: [f32; 3],
    time: f32,
    far: f32,
    mask: c_uint,
    id: c_uint,
    flags: c_uint,
    normal: [f32; 3],
    uv: [f32; 2],
    primitive: c_uint,
    geometry: c_uint,
    instances: [c_uint; 9],
}

/// `RTC_INVALID_GEOMETRY_ID`.
const NONE: c_uint = c_uint::MAX;

impl RayHit {
    fn new((ray, within): &Question) -> Self {
        Self {
            origin: ray.origin.to_array(),
            near: within.min,
            direction: ray.direction.to_array(),
            time: 0.0,
            far: within.max,
            mask: NONE,
            id: 0,
            flags: 0,
            normal: [0.0; 3],
            uv: [0.0; 2],
            primitive: NONE,
            geometry: NONE,
            instances: [NONE; 9],
        }
    }
}

/// `rtcIntersect1` or `rtcOccluded1`, without arguments of ours.
type Ask = unsafe extern "C" fn(Handle, *mut RayHit, *mut c_void);

/// `RTCMemoryMonitorFunction`.
type Monitor = unsafe extern "C" fn(*mut c_void, isize, bool) -> bool;

/// A scene of one mesh.
pub(crate) struct Embree4 {
    scene: Handle,
    intersect: Ask,
    occluded: Ask,
    /// What Embree has allocated for it.
    bytes: usize,
    /// It must stay as long as its functions are called.
    _library: Library,
}

// SAFETY: Embree's scenes may be used by any thread once they are committed (its manual, "rtcCommitScene").
unsafe impl Send for Embree4 {}

/// Builds it, in its default mode.
///
/// # Errors
/// If the library cannot be loaded, or Embree fails.
pub(crate) fn build(scene: &Scene, threads: usize) -> Result<Box<dyn Racer>, String> {
    Ok(Box::new(Embree4::new(&scene.mesh, threads, 0)?))
}

/// Builds it in its robust mode, whose triangle test is watertight.
///
/// # Errors
/// As [`build`].
pub(crate) fn build_robust(scene: &Scene, threads: usize) -> Result<Box<dyn Racer>, String> {
    const ROBUST: c_int = 1 << 2;
    Ok(Box::new(Embree4::new(&scene.mesh, threads, ROBUST)?))
}

impl Embree4 {
    /// A scene of high build quality, made by this number of threads.
    #[allow(
        clippy::too_many_lines,
        reason = "one call after another, each with its type"
    )]
    fn new(mesh: &Mesh, threads: usize, flags: c_int) -> Result<Self, String> {
        const HIGH: c_int = 2;
        const TRIANGLES: c_int = 0;
        const INDICES: c_int = 0;
        const CORNERS: c_int = 1;
        const UINT3: c_int = 0x5003;
        const FLOAT3: c_int = 0x9003;
        let path = std::env::var_os(NAME).map(PathBuf::from);
        let path = path.ok_or_else(|| format!("{NAME} names no library"))?;
        let told = |error: libloading::Error| format!("{}: {error}", path.display());
        // SAFETY: who starts the race names the library, and loading Embree runs nothing but its own initialisation.
        let library = unsafe { Library::new(&path) }.map_err(told)?;
        /// A function of the library, by its name and its type in C.
        macro_rules! function {
            ($name:literal: fn($($argument:ty),*) $(-> $answer:ty)?) => {
                // SAFETY: the type is that of the declaration in Embree 4's headers, and the library stays loaded.
                *unsafe { library.get::<unsafe extern "C" fn($($argument),*) $(-> $answer)?>($name.as_bytes()) }
                    .map_err(told)?
            };
        }
        let new_device = function!("rtcNewDevice": fn(*const c_char) -> Handle);
        let error = function!("rtcGetDeviceError": fn(Handle) -> c_int);
        let set_monitor =
            function!("rtcSetDeviceMemoryMonitorFunction": fn(Handle, Monitor, *mut c_void));
        let new_scene = function!("rtcNewScene": fn(Handle) -> Handle);
        let set_quality = function!("rtcSetSceneBuildQuality": fn(Handle, c_int));
        let set_flags = function!("rtcSetSceneFlags": fn(Handle, c_int));
        let new_geometry = function!("rtcNewGeometry": fn(Handle, c_int) -> Handle);
        let new_buffer = function!(
            "rtcSetNewGeometryBuffer": fn(Handle, c_int, c_uint, c_int, usize, usize) -> *mut c_void
        );
        let commit_geometry = function!("rtcCommitGeometry": fn(Handle));
        let attach = function!("rtcAttachGeometry": fn(Handle, Handle) -> c_uint);
        let release_geometry = function!("rtcReleaseGeometry": fn(Handle));
        let commit_scene = function!("rtcCommitScene": fn(Handle));
        let intersect = function!("rtcIntersect1": fn(Handle, *mut RayHit, *mut c_void));
        let occluded = function!("rtcOccluded1": fn(Handle, *mut RayHit, *mut c_void));
        let config = CString::new(format!("threads={threads}")).map_err(|e| e.to_string())?;
        let (corners, triangles) = (mesh.positions(), mesh.triangles());
        // SAFETY: each function is called as Embree's manual says, with what an earlier one returned. A buffer that is not null
        // has room for as many items as it was asked for, of twelve bytes each, which is the size of what is copied there; Embree
        // adds the bytes of padding that it wants itself. The device and the scene are never released: a race has a few.
        let scene = unsafe {
            let device = new_device(config.as_ptr());
            set_monitor(device, monitor, null_mut());
            let scene = new_scene(device);
            set_quality(scene, HIGH);
            set_flags(scene, flags);
            let geometry = new_geometry(device, TRIANGLES);
            let to = new_buffer(geometry, CORNERS, 0, FLOAT3, 12, corners.len());
            if !to.is_null() {
                to.cast::<glam::Vec3>()
                    .copy_from_nonoverlapping(corners.as_ptr(), corners.len());
            }
            let to = new_buffer(geometry, INDICES, 0, UINT3, 12, triangles.len());
            if !to.is_null() {
                to.cast::<[u32; 3]>()
                    .copy_from_nonoverlapping(triangles.as_ptr(), triangles.len());
            }
            commit_geometry(geometry);
            attach(scene, geometry);
            release_geometry(geometry);
            commit_scene(scene);
            match error(device) {
                0 => scene,
                code => return Err(format!("Embree 4: error {code}")),
            }
        };
        Ok(Self {
            scene,
            intersect,
            occluded,
            bytes: ALLOCATED.swap(0, Ordering::Relaxed).max(0) as usize,
            _library: library,
        })
    }
}

impl Search for Embree4 {
    fn closest(&self, question: &Question) -> f32 {
        let mut answer = RayHit::new(question);
        // SAFETY: the scene is committed, and the ray and its hit are at least as large as Embree's, and aligned as it wants.
        unsafe { (self.intersect)(self.scene, &raw mut answer, null_mut()) };
        if answer.geometry == NONE {
            MISS
        } else {
            answer.far
        }
    }

    /// A ray that is stopped ends at −∞.
    fn any(&self, question: &Question) -> bool {
        let mut answer = RayHit::new(question);
        // SAFETY: as above; `RTCRay` is the first part of it.
        unsafe { (self.occluded)(self.scene, &raw mut answer, null_mut()) };
        answer.far < 0.0
    }

    fn bytes(&self) -> Option<usize> {
        Some(self.bytes)
    }
}
