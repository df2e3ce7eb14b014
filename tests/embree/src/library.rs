//! Embree's library, loaded while the program runs: version 4 or 3, whichever the system has. All that is unsafe is here.
#![expect(
    unsafe_code,
    reason = "functions of a C library that is loaded while the program runs"
)]

use libloading::Library;
use std::env;
use std::ffi::{CStr, OsString, c_char, c_int, c_uint, c_void};
use std::ptr::{null, null_mut};
use std::sync::OnceLock;

/// The environment's variable that names a library to be taken in place of the system's.
const NAME: &str = "RAYBOOK_EMBREE";

/// The names that the library has, first that of the newest version, on Linux, macOS and Windows.
const FILES: [&str; 6] = [
    "libembree4.so.4",
    "libembree3.so.3",
    "libembree4.dylib",
    "libembree3.dylib",
    "embree4.dll",
    "embree3.dll",
];

/// `RTC_INVALID_GEOMETRY_ID`.
const NONE: c_uint = c_uint::MAX;

/// A device, a scene or a geometry of Embree's.
type Handle = *mut c_void;

/// `RTCRay` and `RTCHit` of `rtcore_ray.h`, and some bytes to spare: versions differ in how many instances a hit names.
#[repr(C, align(16))]
#[derive(Clone, Copy, Debug)]
pub(crate) struct RayHit {
    /// Where the ray starts.
    pub(crate) origin: [f32; 3],
    /// The distance at which it begins to count.
    pub(crate) near: f32,
    /// Where it goes.
    pub(crate) direction: [f32; 3],
    time: f32,
    /// The distance up to which it counts; of a hit, its distance.
    pub(crate) far: f32,
    mask: c_uint,
    id: c_uint,
    flags: c_uint,
    /// The hit's normal, of any length.
    pub(crate) normal: [f32; 3],
    /// The hit's place in its triangle.
    pub(crate) uv: [f32; 2],
    /// The number of the triangle that is hit.
    pub(crate) primitive: c_uint,
    geometry: c_uint,
    instances: [c_uint; 9],
}

impl RayHit {
    /// A ray that has not been asked yet.
    pub(crate) fn new(origin: [f32; 3], direction: [f32; 3], near: f32, far: f32) -> Self {
        Self {
            origin,
            near,
            direction,
            time: 0.0,
            far,
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

    /// Whether it hit anything.
    pub(crate) fn is_hit(&self) -> bool {
        self.geometry != NONE
    }
}

/// `RTCIntersectContext` of Embree 3, of which Embree 4 needs none, and some bytes to spare.
#[repr(C)]
struct Context {
    flags: c_int,
    filter: *const c_void,
    instances: [c_uint; 10],
}

/// `rtcIntersect1`, which has another form in each version.
#[derive(Clone, Copy)]
enum Intersect {
    Three(unsafe extern "C" fn(Handle, *mut Context, *mut RayHit)),
    Four(unsafe extern "C" fn(Handle, *mut RayHit, *mut c_void)),
}

/// The functions of Embree that are called here.
struct Functions {
    new_device: unsafe extern "C" fn(*const c_char) -> Handle,
    release_device: unsafe extern "C" fn(Handle),
    error: unsafe extern "C" fn(Handle) -> c_int,
    property: unsafe extern "C" fn(Handle, c_int) -> isize,
    new_scene: unsafe extern "C" fn(Handle) -> Handle,
    release_scene: unsafe extern "C" fn(Handle),
    set_flags: unsafe extern "C" fn(Handle, c_int),
    commit_scene: unsafe extern "C" fn(Handle),
    new_geometry: unsafe extern "C" fn(Handle, c_int) -> Handle,
    new_buffer: unsafe extern "C" fn(Handle, c_int, c_uint, c_int, usize, usize) -> *mut c_void,
    commit_geometry: unsafe extern "C" fn(Handle),
    attach: unsafe extern "C" fn(Handle, Handle) -> c_uint,
    release_geometry: unsafe extern "C" fn(Handle),
    intersect: Intersect,
}

impl Functions {
    /// Loads the library that the environment names, or the first one that the system has.
    fn load() -> Result<Self, String> {
        let named = env::var_os(NAME);
        let files: Vec<OsString> = match &named {
            Some(file) => vec![file.clone()],
            None => FILES.map(OsString::from).to_vec(),
        };
        // SAFETY: to load Embree runs nothing but its own initialisation.
        let mut loaded = files.iter().map(|file| unsafe { Library::new(file) });
        let library = loaded.find_map(Result::ok).ok_or_else(|| match named {
            Some(file) => format!("{NAME}: {} is no library that can be loaded", file.display()),
            None => format!(
                "neither Embree 4 nor Embree 3 is here: `apt-get install libembree-dev`, `brew install embree`, or name the library in {NAME}"
            ),
        })?;
        Self::of(library).map_err(|error| format!("Embree's library: {error}"))
    }

    /// The functions of a library, which stays loaded to the program's end.
    fn of(library: Library) -> Result<Self, libloading::Error> {
        let library = Box::leak(Box::new(library));
        /// A function of the library, by its name in C; its type is that of the field.
        macro_rules! function {
            ($name:literal) => {
                // SAFETY: the types of the fields are those of the declarations in Embree's headers, and the library stays loaded.
                *unsafe { library.get($name.as_bytes()) }?
            };
        }
        let new_device = function!("rtcNewDevice");
        let release_device = function!("rtcReleaseDevice");
        let property = function!("rtcGetDeviceProperty");
        let version = version_by(new_device, property, release_device)[0];
        Ok(Self {
            new_device,
            release_device,
            error: function!("rtcGetDeviceError"),
            property,
            new_scene: function!("rtcNewScene"),
            release_scene: function!("rtcReleaseScene"),
            set_flags: function!("rtcSetSceneFlags"),
            commit_scene: function!("rtcCommitScene"),
            new_geometry: function!("rtcNewGeometry"),
            new_buffer: function!("rtcSetNewGeometryBuffer"),
            commit_geometry: function!("rtcCommitGeometry"),
            attach: function!("rtcAttachGeometry"),
            release_geometry: function!("rtcReleaseGeometry"),
            intersect: if version < 4 {
                Intersect::Three(function!("rtcIntersect1"))
            } else {
                Intersect::Four(function!("rtcIntersect1"))
            },
        })
    }

    /// The functions, loaded once.
    fn get() -> Result<&'static Self, String> {
        static FUNCTIONS: OnceLock<Result<Functions, String>> = OnceLock::new();
        FUNCTIONS
            .get_or_init(Self::load)
            .as_ref()
            .map_err(Clone::clone)
    }
}

/// The three numbers of a library's version, which a device tells.
fn version_by(
    new_device: unsafe extern "C" fn(*const c_char) -> Handle,
    property: unsafe extern "C" fn(Handle, c_int) -> isize,
    release_device: unsafe extern "C" fn(Handle),
) -> [isize; 3] {
    // SAFETY: a device may be made without a configuration, be asked for its properties, and is released once.
    unsafe {
        let device = new_device(null());
        let version = VERSION.map(|which| property(device, which));
        release_device(device);
        version
    }
}

/// `RTC_DEVICE_PROPERTY_VERSION_MAJOR`, `_MINOR` and `_PATCH`.
const VERSION: [c_int; 3] = [1, 2, 3];

/// Where scenes are made.
pub(crate) struct Device {
    device: Handle,
    functions: &'static Functions,
}

// SAFETY: Embree's devices may be used by several threads at once (its manual, "rtcNewDevice").
unsafe impl Send for Device {}
// SAFETY: as above.
unsafe impl Sync for Device {}

impl Device {
    /// A device of this configuration, as in Embree's manual: "threads=1".
    ///
    /// # Errors
    /// If there is no Embree, or it does not start.
    pub(crate) fn new(config: &CStr) -> Result<Self, String> {
        let functions = Functions::get()?;
        // SAFETY: the configuration ends with a 0.
        let device = unsafe { (functions.new_device)(config.as_ptr()) };
        if device.is_null() {
            // SAFETY: the error of a device that could not be made is asked of none.
            let code = unsafe { (functions.error)(null_mut()) };
            return Err(told(code));
        }
        Ok(Self { device, functions })
    }

    /// The version: 3, 13 and 5.
    pub(crate) fn version(&self) -> [isize; 3] {
        // SAFETY: the device is one.
        VERSION.map(|which| unsafe { (self.functions.property)(self.device, which) })
    }

    /// A scene of triangles, ready to be asked.
    ///
    /// # Errors
    /// If Embree refuses them, or has no memory left.
    pub(crate) fn triangles(
        &self,
        positions: &[[f32; 3]],
        triangles: &[[u32; 3]],
        robust: bool,
    ) -> Result<Scene, String> {
        const TRIANGLE: c_int = 0;
        self.scene(TRIANGLE, robust, |geometry| {
            self.fill(geometry, CORNER, 0x9003, positions)?;
            self.fill(geometry, INDEX, 0x5003, triangles)
        })
    }

    /// A scene of a sphere: its centre and its radius.
    ///
    /// # Errors
    /// As [`triangles`](Self::triangles).
    pub(crate) fn sphere(&self, sphere: [f32; 4], robust: bool) -> Result<Scene, String> {
        const SPHERE_POINT: c_int = 50;
        self.scene(SPHERE_POINT, robust, |geometry| {
            self.fill(geometry, CORNER, 0x9004, &[sphere])
        })
    }

    /// A scene of a geometry that is filled by a function.
    fn scene(
        &self,
        kind: c_int,
        robust: bool,
        fill: impl FnOnce(Handle) -> Result<(), String>,
    ) -> Result<Scene, String> {
        const ROBUST: c_int = 1 << 2;
        let Self { device, functions } = self;
        // SAFETY: each function is called as Embree's manual says, with what an earlier one returned. The scene keeps its geometry.
        unsafe {
            let scene = Scene {
                scene: (functions.new_scene)(*device),
                functions,
            };
            let geometry = (functions.new_geometry)(*device, kind);
            let filled = fill(geometry);
            if robust {
                (functions.set_flags)(scene.scene, ROBUST);
            }
            (functions.commit_geometry)(geometry);
            (functions.attach)(scene.scene, geometry);
            (functions.release_geometry)(geometry);
            (functions.commit_scene)(scene.scene);
            filled?;
            match (functions.error)(*device) {
                0 => Ok(scene),
                code => Err(told(code)),
            }
        }
    }

    /// Fills a buffer of a geometry with items of a format: `RTC_FORMAT_UINT3`, `_FLOAT3` or `_FLOAT4`.
    fn fill<T: Copy>(
        &self,
        geometry: Handle,
        buffer: c_int,
        format: c_int,
        items: &[T],
    ) -> Result<(), String> {
        let size = size_of::<T>();
        // SAFETY: a buffer that is not null has room for as many items as it was asked for, each of their size; Embree adds the
        // bytes of padding that it wants itself.
        unsafe {
            let to = (self.functions.new_buffer)(geometry, buffer, 0, format, size, items.len());
            if to.is_null() {
                return Err(told((self.functions.error)(self.device)));
            }
            to.cast::<T>()
                .copy_from_nonoverlapping(items.as_ptr(), items.len());
        }
        Ok(())
    }
}

/// `RTC_BUFFER_TYPE_INDEX`.
const INDEX: c_int = 0;
/// `RTC_BUFFER_TYPE_VERTEX`.
const CORNER: c_int = 1;

impl Drop for Device {
    fn drop(&mut self) {
        // SAFETY: it is released once; scenes keep what they need of it.
        unsafe { (self.functions.release_device)(self.device) }
    }
}

/// A scene that can be asked.
pub(crate) struct Scene {
    scene: Handle,
    functions: &'static Functions,
}

// SAFETY: Embree's scenes may be used by any thread, and by several at once, when they are committed (its manual, "rtcCommitScene").
unsafe impl Send for Scene {}
// SAFETY: as above.
unsafe impl Sync for Scene {}

impl Scene {
    /// Fills in the nearest hit of a ray.
    pub(crate) fn intersect(&self, ray: &mut RayHit) {
        // SAFETY: the scene is committed, and ray, hit and context are at least as large as Embree's, and aligned as it wants.
        unsafe {
            match self.functions.intersect {
                Intersect::Three(intersect) => {
                    let context = &mut Context {
                        flags: 0,
                        filter: null(),
                        instances: [NONE; 10],
                    };
                    intersect(self.scene, context, ray);
                }
                Intersect::Four(intersect) => intersect(self.scene, ray, null_mut()),
            }
        }
    }
}

impl Drop for Scene {
    fn drop(&mut self) {
        // SAFETY: it is released once.
        unsafe { (self.functions.release_scene)(self.scene) }
    }
}

/// What an error of Embree's says, by its number in `rtcore_common.h`.
fn told(code: c_int) -> String {
    let what = match code {
        2 => "an argument is invalid",
        3 => "an operation is not allowed",
        4 => "there is not enough memory",
        5 => "this processor is not supported",
        _ => "an unknown error",
    };
    format!("Embree: {what} (error {code})")
}
