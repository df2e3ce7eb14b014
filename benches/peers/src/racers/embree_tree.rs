//! The tree that Embree builds over a mesh. A scene keeps it to itself, but the builder, `rtcBuildBVH`, tells each node.
#![expect(
    unsafe_code,
    reason = "a C library's builder, which calls functions of ours"
)]

use embree3::BuildQuality;
use embree3::sys::{
    RTCBounds, RTCBuildArguments, RTCBuildFlags, RTCBuildPrimitive, RTCError,
    RTCThreadLocalAllocator, rtcBuildBVH, rtcGetDeviceError, rtcNewBVH, rtcNewDevice,
    rtcReleaseBVH, rtcReleaseDevice,
};
use glam::{Vec3, vec3};
use raybook::math::aabb::Aabb;
use raybook::shape::mesh::Mesh;
use raybook_peers::sah::{Inside, Node};
use std::ffi::{c_uint, c_void};
use std::slice::from_raw_parts;
use std::sync::{Mutex, PoisonError};

/// Children of a node, and triangles of a block, of Embree's trees for processors with AVX.
const CHILDREN: c_uint = 8;
const BLOCK: c_uint = 4;

/// Maximum number of blocks in a leaf of these trees, and of levels.
const BLOCKS: c_uint = 7;
const LEVELS: c_uint = 40;

/// Where a build of high quality cuts triangles, this number of parts for each is the most on average: Embree's default.
const PARTS: f64 = 1.2;

/// What `rtcBuildBVH` hands to each of its calls: the `mesh`, and the `nodes` that they have told.
struct Told<'a> {
    mesh: &'a Mesh,
    nodes: Mutex<Vec<Node>>,
}

impl Told<'_> {
    fn add(&self, bounds: impl Iterator<Item = Aabb>, inside: Inside) {
        let bounds = bounds.fold(Aabb::EMPTY, |all, one| all.union(&one));
        let mut nodes = self.nodes.lock().unwrap_or_else(PoisonError::into_inner);
        nodes.push((bounds, inside));
    }
}

/// The nodes of the tree that a scene of this quality has, built with the settings that Embree has for scenes of triangles.
///
/// # Errors
/// If Embree fails.
pub(crate) fn nodes(mesh: &Mesh, quality: BuildQuality) -> Result<Vec<Node>, String> {
    let count = mesh.triangles().len();
    let capacity = (PARTS * count as f64) as usize;
    let mut primitives = Vec::with_capacity(capacity);
    primitives.extend((0..count).map(|i| primitive(mesh, i)));
    let mut told = Told {
        mesh,
        nodes: Mutex::default(),
    };
    // SAFETY: each function is called as Embree's manual says, with what an earlier one returned. The list of primitives has room
    // for `capacity` of them, and lives, as `told` does, until the builder is done.
    let error = unsafe {
        let device = rtcNewDevice(c"threads=1".as_ptr());
        let bvh = rtcNewBVH(device);
        if bvh.is_null() {
            return Err(format!("Embree: {:?}", rtcGetDeviceError(device)));
        }
        let arguments = RTCBuildArguments {
            byteSize: size_of::<RTCBuildArguments>(),
            buildQuality: quality,
            buildFlags: RTCBuildFlags::NONE,
            maxBranchingFactor: CHILDREN,
            maxDepth: LEVELS,
            sahBlockSize: BLOCK,
            minLeafSize: BLOCK,
            maxLeafSize: BLOCKS * BLOCK,
            traversalCost: 1.0,
            intersectionCost: 1.0,
            bvh,
            primitives: primitives.as_mut_ptr(),
            primitiveCount: count,
            primitiveArrayCapacity: primitives.capacity(),
            createNode: Some(create_node),
            setNodeChildren: Some(set_children),
            setNodeBounds: Some(set_bounds),
            createLeaf: Some(create_leaf),
            splitPrimitive: Some(split),
            buildProgress: None,
            userPtr: (&raw mut told).cast(),
        };
        rtcBuildBVH(&raw const arguments);
        let error = rtcGetDeviceError(device);
        rtcReleaseBVH(bvh);
        rtcReleaseDevice(device);
        error
    };
    match error {
        RTCError::NONE => Ok(told.nodes.into_inner().unwrap_or_default()),
        error => Err(format!("Embree's builder: {error:?}")),
    }
}

/// A triangle of the mesh as the builder takes it: its box and its number.
fn primitive(mesh: &Mesh, i: usize) -> RTCBuildPrimitive {
    let Aabb { min, max } = Aabb::of(corners(mesh, i));
    RTCBuildPrimitive {
        lower_x: min.x,
        lower_y: min.y,
        lower_z: min.z,
        geomID: 0,
        upper_x: max.x,
        upper_y: max.y,
        upper_z: max.z,
        primID: i as u32,
    }
}

fn corners(mesh: &Mesh, i: usize) -> [Vec3; 3] {
    mesh.triangles()[i].map(|corner| mesh.positions()[corner as usize])
}

/// The box of a primitive, which is smaller than its triangle's once it is cut.
fn of_primitive(p: &RTCBuildPrimitive) -> Aabb {
    let min = vec3(p.lower_x, p.lower_y, p.lower_z);
    Aabb::new(min, vec3(p.upper_x, p.upper_y, p.upper_z))
}

fn of_bounds(b: &RTCBounds) -> Aabb {
    let min = vec3(b.lower_x, b.lower_y, b.lower_z);
    Aabb::new(min, vec3(b.upper_x, b.upper_y, b.upper_z))
}

fn to_bounds(bounds: &Aabb) -> RTCBounds {
    let Aabb { min, max } = *bounds;
    RTCBounds {
        lower_x: min.x,
        lower_y: min.y,
        lower_z: min.z,
        align0: 0.0,
        upper_x: max.x,
        upper_y: max.y,
        upper_z: max.z,
        align1: 0.0,
    }
}

/// The boxes of the two parts of a triangle, below and above `at` along an axis.
fn halves(corners: [Vec3; 3], axis: usize, at: f32) -> [Aabb; 2] {
    let (mut below, mut above) = (Vec::new(), Vec::new());
    for i in 0..corners.len() {
        let (p, q) = (corners[i], corners[(i + 1) % corners.len()]);
        if p[axis] <= at {
            below.push(p);
        }
        if p[axis] >= at {
            above.push(p);
        }
        if (p[axis] < at) != (q[axis] < at) && p[axis] != at && q[axis] != at {
            let cut = p + (at - p[axis]) / (q[axis] - p[axis]) * (q - p);
            below.push(cut);
            above.push(cut);
        }
    }
    [below, above].map(Aabb::of)
}

fn intersection(a: &Aabb, b: &Aabb) -> Aabb {
    Aabb::new(a.min.max(b.min), a.max.min(b.max))
}

/// Nobody reads what stands for a node: any pointer but null will do.
unsafe extern "C" fn create_node(
    _: RTCThreadLocalAllocator,
    _: c_uint,
    told: *mut c_void,
) -> *mut c_void {
    told
}

unsafe extern "C" fn set_children(_: *mut c_void, _: *mut *mut c_void, _: c_uint, _: *mut c_void) {}

unsafe extern "C" fn set_bounds(
    _: *mut c_void,
    bounds: *mut *const RTCBounds,
    count: c_uint,
    told: *mut c_void,
) {
    let count = count as usize;
    // SAFETY: the builder hands `told` on, and a list of `count` pointers to boxes.
    let (told, bounds) = unsafe { (&*told.cast::<Told>(), from_raw_parts(bounds, count)) };
    // SAFETY: as above.
    let bounds = bounds.iter().map(|&b| of_bounds(unsafe { &*b }));
    told.add(bounds, Inside::Children(count));
}

unsafe extern "C" fn create_leaf(
    _: RTCThreadLocalAllocator,
    primitives: *const RTCBuildPrimitive,
    count: usize,
    told: *mut c_void,
) -> *mut c_void {
    // SAFETY: the builder hands `told` on, and a list of `count` primitives.
    let (of, primitives) = unsafe { (&*told.cast::<Told>(), from_raw_parts(primitives, count)) };
    of.add(
        primitives.iter().map(of_primitive),
        Inside::Triangles(count),
    );
    told
}

unsafe extern "C" fn split(
    primitive: *const RTCBuildPrimitive,
    axis: c_uint,
    at: f32,
    left: *mut RTCBounds,
    right: *mut RTCBounds,
    told: *mut c_void,
) {
    // SAFETY: the builder hands `told` on, and one of its primitives.
    let (told, primitive) = unsafe { (&*told.cast::<Told>(), &*primitive) };
    let whole = of_primitive(primitive);
    let halves = halves(
        corners(told.mesh, primitive.primID as usize),
        axis as usize,
        at,
    );
    let [below, above] = halves.map(|half| to_bounds(&intersection(&half, &whole)));
    // SAFETY: both have room for a box.
    unsafe {
        left.write(below);
        right.write(above);
    }
}
