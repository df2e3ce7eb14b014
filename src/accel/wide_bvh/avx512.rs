//! Eight boxes and eight triangles at once by the instructions AVX-512 of x86-64 processors.
//!
//! The sums are those of [`avx2`](super::avx2). What a comparison says goes into a register of masks, without a detour, and there
//! are twice as many registers for numbers: so the test of a leaf can be part of the loop over the nodes.
#![expect(unsafe_code, reason = "vector instructions")]

use super::avx2::{array, prefetch, seen, slabs};
use super::lanes::{Lanes, Struck, Work};
use super::node::{CHILDREN, Leaf, Link, Node};
use super::ray::WideRay;
use super::tree::Tree;
use crate::math::domain::{AREA_MAX, AREA_MIN};
#[allow(
    clippy::wildcard_imports,
    reason = "the names of all vector instructions begin with _mm"
)]
use std::arch::x86_64::*;

/// The proof that this processor has AVX-512 (its parts F, VL and DQ), AVX2, FMA and BMI: only [`Avx512::detect`] makes one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Avx512(());

impl Avx512 {
    /// The proof, if it can be given.
    pub(super) fn detect() -> Option<Self> {
        let wide = is_x86_feature_detected!("avx512f")
            && is_x86_feature_detected!("avx512vl")
            && is_x86_feature_detected!("avx512dq");
        let narrow = is_x86_feature_detected!("avx2")
            && is_x86_feature_detected!("fma")
            && is_x86_feature_detected!("bmi1")
            && is_x86_feature_detected!("bmi2");
        (wide && narrow).then_some(Self(()))
    }

    /// Does the work, compiled for this processor.
    #[inline(always)]
    pub(super) fn run<W: Work>(self, work: W) -> W::Answer {
        #[target_feature(enable = "avx2,fma,bmi1,bmi2,avx512f,avx512vl,avx512dq")]
        fn compiled<W: Work>(lanes: Avx512, work: W) -> W::Answer {
            work.with(lanes)
        }
        // SAFETY: this processor has all of these. `self` is the proof: only `detect` makes one, for the field is private.
        unsafe { compiled(self, work) }
    }
}

impl Lanes for Avx512 {
    #[inline(always)]
    fn boxes(self, node: &Node, ray: &WideRay, max: f32) -> (u32, [f32; CHILDREN]) {
        // SAFETY: this processor has these instructions; `self` is the proof, which only `detect` makes.
        unsafe { boxes(node, ray, max) }
    }

    #[inline(always)]
    fn triangles(self, leaf: &Leaf, ray: &WideRay, max: f32) -> Option<Struck> {
        // SAFETY: this processor has these instructions; `self` is the proof, which only `detect` makes.
        unsafe { triangles(leaf, ray, max) }
    }

    #[inline(always)]
    fn prefetch(self, tree: &Tree, link: Link) {
        prefetch(tree, link);
    }
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
    let least = _mm256_min_ps(u, _mm256_min_ps(v, w));
    let most = _mm256_max_ps(u, _mm256_max_ps(v, w));
    let inside = _mm256_cmp_ps_mask::<_CMP_GE_OQ>(least, zero)
        | _mm256_cmp_ps_mask::<_CMP_LE_OQ>(most, zero);
    if inside == 0 {
        return None;
    }
    let on_edge = _mm256_cmp_ps_mask::<_CMP_EQ_OQ>(u, zero)
        | _mm256_cmp_ps_mask::<_CMP_EQ_OQ>(v, zero)
        | _mm256_cmp_ps_mask::<_CMP_EQ_OQ>(w, zero);
    let whole = seen.whole();
    let size = _mm256_andnot_ps(_mm256_set1_ps(-0.0), whole);
    let extreme = _mm256_cmp_ps_mask::<_CMP_LT_OQ>(size, _mm256_set1_ps(AREA_MIN))
        | _mm256_cmp_ps_mask::<_CMP_GT_OQ>(size, _mm256_set1_ps(AREA_MAX));
    let unsure = inside & (on_edge | extreme);
    let inverse = _mm256_div_ps(_mm256_set1_ps(1.0), whole);
    let t = _mm256_mul_ps(seen.depth(), inverse);
    let counts = _mm256_cmp_ps_mask::<_CMP_LT_OQ>(_mm256_set1_ps(ray.min), t)
        & _mm256_cmp_ps_mask::<_CMP_LT_OQ>(t, _mm256_set1_ps(max));
    let mask = inside & counts & !unsure;
    if mask | unsure == 0 {
        return None;
    }
    Some(Struck {
        mask: mask.into(),
        unsure: unsure.into(),
        t: array(t),
        b1: array(_mm256_mul_ps(v, inverse)),
        b2: array(_mm256_mul_ps(w, inverse)),
    })
}
