//! Eight boxes and eight triangles at once by the instructions AVX-512 of x86-64 processors.
//!
//! The sums are those of [`avx2`](super::avx2). What a comparison says goes into a register of masks, without a detour, and there
//! are twice as many registers for numbers: so the test of a leaf can be part of the loop over the nodes.
#![expect(unsafe_code, reason = "vector instructions")]

use super::avx2::{array, prefetch, seen, size, slabs};
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
    /// The proof that this processor has AVX-512 (its parts F, VL and DQ), AVX2, FMA and BMI.
    Avx512: "avx2", "fma", "bmi1", "bmi2", "avx512f", "avx512vl", "avx512dq"
}

#[target_feature(enable = "avx2,fma,bmi1,bmi2,avx512f,avx512vl,avx512dq")]
#[inline]
fn boxes(node: &Node, ray: &WideRay, max: f32) -> (u32, [f32; CHILDREN]) {
    let [enter, leave] = slabs(node, ray, max);
    let met = _mm256_cmple_epi32_mask(enter, leave);
    (met.into(), array(_mm256_castsi256_ps(enter)))
}

#[target_feature(enable = "avx2,fma,bmi1,bmi2,avx512f,avx512vl,avx512dq")]
#[inline]
fn triangles(leaf: &Leaf, ray: &WideRay, max: f32) -> Option<Struck> {
    let seen = seen(leaf, ray);
    let [u, v, w] = seen.areas;
    let zero = _mm256_setzero_ps();
    let [least, most] = seen.extremes();
    let inside = _mm256_cmp_ps_mask::<_CMP_GE_OQ>(least, zero)
        | _mm256_cmp_ps_mask::<_CMP_LE_OQ>(most, zero);
    if inside == 0 {
        return None;
    }
    let on_edge = _mm256_cmp_ps_mask::<_CMP_EQ_OQ>(u, zero)
        | _mm256_cmp_ps_mask::<_CMP_EQ_OQ>(v, zero)
        | _mm256_cmp_ps_mask::<_CMP_EQ_OQ>(w, zero);
    let whole = seen.whole();
    let size = size(whole);
    let extreme = _mm256_cmp_ps_mask::<_CMP_LT_OQ>(size, _mm256_set1_ps(AREA_MIN))
        | _mm256_cmp_ps_mask::<_CMP_GT_OQ>(size, _mm256_set1_ps(AREA_MAX));
    let unsure = inside & (on_edge | extreme);
    let met = seen.met(whole);
    let counts = _mm256_cmp_ps_mask::<_CMP_LT_OQ>(_mm256_set1_ps(ray.min), met.t)
        & _mm256_cmp_ps_mask::<_CMP_LT_OQ>(met.t, _mm256_set1_ps(max));
    let mask = inside & counts & !unsure;
    met.struck(mask.into(), unsure.into())
}
