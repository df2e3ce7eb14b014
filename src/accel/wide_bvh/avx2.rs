//! Eight boxes and eight triangles at once by the instructions AVX2 and FMA of x86-64 processors.
#![expect(
    unsafe_code,
    reason = "vector instructions, and their loads by address"
)]

use super::lanes::{Lanes, Struck, Work};
use super::node::{CHILDREN, Leaf, Link, Node};
use super::proof::proof;
use super::ray::WideRay;
use super::tree::Tree;
use crate::math::domain::{AREA_MAX, AREA_MIN};
#[allow(
    clippy::wildcard_imports,
    reason = "the names of all vector instructions begin with _mm"
)]
use std::arch::x86_64::*;

proof! {
    /// The proof that this processor has AVX2 and FMA.
    Avx2: "avx2", "fma"
}

/// Prefetches a child into the cache that `HINT` names: the six cache lines of a leaf, which are more than a node has.
#[inline(always)]
pub(super) fn prefetch<const HINT: i32>(tree: &Tree, link: Link) {
    let node = tree.nodes.as_ptr().wrapping_add(link.index()).cast::<i8>();
    let leaf = tree.leaves.as_ptr().wrapping_add(link.index()).cast::<i8>();
    let at = std::hint::select_unpredictable(link.as_leaf().is_some(), leaf, node);
    for line in 0..6 {
        // SAFETY: a prefetch reads nothing that the program sees, and of an address without memory it does nothing: so any link
        // will do. The addresses are computed by `wrapping_add`, which may leave the lists. Every x86-64 processor has it.
        unsafe { _mm_prefetch::<HINT>(at.wrapping_add(64 * line)) };
    }
}

/// Three numbers, each in all lanes.
#[target_feature(enable = "avx2,fma")]
#[inline]
fn splats(v: glam::Vec3A) -> [__m256; 3] {
    let v: __m128 = v.into();
    [
        _mm256_broadcastss_ps(v),
        _mm256_broadcastss_ps(_mm_permute_ps::<0x55>(v)),
        _mm256_broadcastss_ps(_mm_permute_ps::<0xAA>(v)),
    ]
}

/// Where the ray enters and where it leaves each of eight boxes, as integers in the same order as the distances.
#[target_feature(enable = "avx2,fma")]
#[inline]
pub(super) fn slabs(node: &Node, ray: &WideRay, max: f32) -> [__m256i; 2] {
    let rows = node.rows.as_flattened().as_ptr();
    // SAFETY: `start` is a multiple of 8 below 48, so eight of the 48 numbers begin there, at a multiple of 32 bytes: a node
    // begins at one of 64 (`repr(C, align(64))`), and its rows are its first field. That holds for what `WideRay::near`
    // returns, and for it ^ 8; its field is private, and only `WideRay::new` writes it.
    let row = |start: usize| unsafe { _mm256_load_ps(rows.add(start)) };
    let [nx, ny, nz] = ray.near();
    let [ix, iy, iz] = splats(ray.inverse);
    let [ex, ey, ez] = splats(ray.enter);
    let [lx, ly, lz] = splats(ray.leave);
    let plane = |i: usize, inverse: __m256, offset: __m256| {
        _mm256_castps_si256(_mm256_fmadd_ps(row(i), inverse, offset))
    };
    let splat = |v: f32| _mm256_castps_si256(_mm256_set1_ps(v));
    let enter = _mm256_max_epi32(
        _mm256_max_epi32(plane(nx, ix, ex), plane(ny, iy, ey)),
        _mm256_max_epi32(plane(nz, iz, ez), splat(ray.min)),
    );
    let leave = _mm256_min_epi32(
        _mm256_min_epi32(plane(nx ^ CHILDREN, ix, lx), plane(ny ^ CHILDREN, iy, ly)),
        _mm256_min_epi32(plane(nz ^ CHILDREN, iz, lz), splat(max)),
    );
    [enter, leave]
}

#[target_feature(enable = "avx2,fma")]
#[inline]
fn boxes(node: &Node, ray: &WideRay, max: f32) -> (u32, [f32; CHILDREN]) {
    let [enter, leave] = slabs(node, ray, max);
    let missed = _mm256_movemask_ps(_mm256_castsi256_ps(_mm256_cmpgt_epi32(enter, leave)));
    (missed as u32 ^ 255, array(_mm256_castsi256_ps(enter)))
}

/// Eight numbers in memory.
#[target_feature(enable = "avx2,fma")]
#[inline]
pub(super) fn array(v: __m256) -> [f32; 8] {
    let mut array = [0.0; 8];
    // SAFETY: `array` has room for eight numbers, and this store takes any address.
    unsafe { _mm256_storeu_ps(array.as_mut_ptr(), v) };
    array
}

/// Eight triangles seen along the ray: their areas u, v and w, and the distances of their corners along the ray; see
/// [`hit`](crate::shape::triangle_watertight::hit).
pub(super) struct Seen {
    pub(super) areas: [__m256; 3],
    pub(super) z: [__m256; 3],
}

/// Moves eight triangles into the ray's frame.
#[target_feature(enable = "avx2,fma")]
#[inline]
pub(super) fn seen(leaf: &Leaf, ray: &WideRay) -> Seen {
    let [ax, ay, az] = ray.shear.axes();
    let [sx, sy, sz] = ray.shear.slopes().map(|v| _mm256_set1_ps(v));
    let [ox, oy, oz] = ray.origin.map(|v| _mm256_set1_ps(v));
    let corner = |i: usize| {
        let rows = leaf.corners[i].as_ptr();
        // SAFETY: `axis` is 0, 1 or 2: it comes from `Shear::axes`, whose field is private, and only `Shear::along` writes it.
        // So it is one of the three rows of a corner, of eight numbers; it begins at a multiple of 32 bytes, as the leaf does
        // (`repr(C, align(32))`) whose first field the corners are.
        let row = |axis: usize| unsafe { _mm256_load_ps(rows.add(axis).cast()) };
        let x = _mm256_sub_ps(row(ax), ox);
        let y = _mm256_sub_ps(row(ay), oy);
        let z = _mm256_sub_ps(row(az), oz);
        [
            _mm256_sub_ps(x, _mm256_mul_ps(sx, z)),
            _mm256_sub_ps(y, _mm256_mul_ps(sy, z)),
            _mm256_mul_ps(sz, z),
        ]
    };
    let (a, b, c) = (corner(0), corner(1), corner(2));
    let cross = |p: [__m256; 3], q: [__m256; 3]| {
        _mm256_sub_ps(_mm256_mul_ps(p[0], q[1]), _mm256_mul_ps(p[1], q[0]))
    };
    Seen {
        areas: [cross(c, b), cross(a, c), cross(b, a)],
        z: [a[2], b[2], c[2]],
    }
}

/// Eight triangles as they are hit, if they are: the distances, and two barycentrics.
pub(super) struct Met {
    pub(super) t: __m256,
    b1: __m256,
    b2: __m256,
}

impl Seen {
    /// The least and the greatest of u, v and w.
    #[target_feature(enable = "avx2,fma")]
    #[inline]
    pub(super) fn extremes(&self) -> [__m256; 2] {
        let [u, v, w] = self.areas;
        [
            _mm256_min_ps(u, _mm256_min_ps(v, w)),
            _mm256_max_ps(u, _mm256_max_ps(v, w)),
        ]
    }

    /// u + v + w.
    #[target_feature(enable = "avx2,fma")]
    #[inline]
    pub(super) fn whole(&self) -> __m256 {
        let [u, v, w] = self.areas;
        _mm256_add_ps(_mm256_add_ps(u, v), w)
    }

    /// Where the triangles are met.
    #[target_feature(enable = "avx2,fma")]
    #[inline]
    pub(super) fn met(&self, whole: __m256) -> Met {
        let ([u, v, w], [a, b, c]) = (self.areas, self.z);
        let two = _mm256_add_ps(_mm256_mul_ps(u, a), _mm256_mul_ps(v, b));
        let depth = _mm256_add_ps(two, _mm256_mul_ps(w, c));
        let inverse = _mm256_div_ps(_mm256_set1_ps(1.0), whole);
        Met {
            t: _mm256_mul_ps(depth, inverse),
            b1: _mm256_mul_ps(v, inverse),
            b2: _mm256_mul_ps(w, inverse),
        }
    }
}

impl Met {
    /// The triangles that count, if there are any.
    #[target_feature(enable = "avx2,fma")]
    #[inline]
    pub(super) fn struck(&self, mask: u32, unsure: u32) -> Option<Struck> {
        if mask | unsure == 0 {
            return None;
        }
        Some(Struck {
            mask,
            unsure,
            t: array(self.t),
            b1: array(self.b1),
            b2: array(self.b2),
        })
    }
}

/// |v|.
#[target_feature(enable = "avx2,fma")]
#[inline]
pub(super) fn size(v: __m256) -> __m256 {
    _mm256_andnot_ps(_mm256_set1_ps(-0.0), v)
}

#[target_feature(enable = "avx2,fma")]
#[inline]
fn triangles(leaf: &Leaf, ray: &WideRay, max: f32) -> Option<Struck> {
    let seen = seen(leaf, ray);
    let [u, v, w] = seen.areas;
    let zero = _mm256_setzero_ps();
    let [least, most] = seen.extremes();
    let inside = _mm256_or_ps(
        _mm256_cmp_ps::<_CMP_GE_OQ>(least, zero),
        _mm256_cmp_ps::<_CMP_LE_OQ>(most, zero),
    );
    if _mm256_movemask_ps(inside) == 0 {
        return None;
    }
    let on_edge = _mm256_or_ps(
        _mm256_cmp_ps::<_CMP_EQ_OQ>(u, zero),
        _mm256_or_ps(
            _mm256_cmp_ps::<_CMP_EQ_OQ>(v, zero),
            _mm256_cmp_ps::<_CMP_EQ_OQ>(w, zero),
        ),
    );
    let whole = seen.whole();
    let size = size(whole);
    let extreme = _mm256_or_ps(
        _mm256_cmp_ps::<_CMP_LT_OQ>(size, _mm256_set1_ps(AREA_MIN)),
        _mm256_cmp_ps::<_CMP_GT_OQ>(size, _mm256_set1_ps(AREA_MAX)),
    );
    let doubtful = _mm256_and_ps(inside, _mm256_or_ps(on_edge, extreme));
    let unsure = _mm256_movemask_ps(doubtful) as u32;
    let met = seen.met(whole);
    let counts = _mm256_and_ps(
        _mm256_cmp_ps::<_CMP_LT_OQ>(_mm256_set1_ps(ray.min), met.t),
        _mm256_cmp_ps::<_CMP_LT_OQ>(met.t, _mm256_set1_ps(max)),
    );
    let mask = _mm256_movemask_ps(_mm256_and_ps(inside, counts)) as u32 & !unsure;
    met.struck(mask, unsure)
}
