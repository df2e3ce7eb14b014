//! The judge of `shadow_ray`: where the way to the light begins and where it ends.

use crate::judge::size;
use crate::{Verdict, judge};
use glam::{DVec3, Vec3};
use raybook_workbook::exercises::ch15_shadows::{ShadowRay, Way};

/// How far off the surface a shadow ray may start, in error bounds: beyond, shadows come loose.
const FARTHEST: f64 = 5.0;

/// The part of the step off the surface that must be there: the rest is rounding.
const ROUNDED: f64 = 0.9;

/// A shadow ray must end at least this share of the way before the light, and at most this.
const NEAREST_END: f64 = 5e-7;
const FARTHEST_END: f64 = 0.01;

/// A step of less than this part of the one that is needed is next to nothing: how little it is does not matter, but that it is not nothing
/// tells a fixed step from none, also where it is small beside the place itself.
const LITTLE: f64 = 0.02;

/// The part of the step that is needed as which a step that is next to nothing is shown.
const SHOWN: f64 = 0.05;

/// Where a ray starts whose step along the normal, to the light's side, is next to nothing: a twentieth of the needed step off the point.
pub(super) fn next_to_nothing(q: &ShadowRay, got: &Way) -> Option<Vec3> {
    let [normal, toward, position] = [*q.normal, *q.toward, q.position].map(Vec3::as_dvec3);
    let step = got.origin.as_dvec3() - position;
    let needed = f64::from(q.error) * normal.abs().element_sum();
    let off = normal.dot(step) * normal.dot(toward).signum();
    let is_little = off > 0.0 && step.length() < LITTLE * needed;
    let origin = position + (SHOWN * needed).copysign(normal.dot(toward)) * normal;
    (is_little && beside_the_normal(step, q).is_none()).then(|| origin.as_vec3())
}

/// Where the stretch that counts begins, seen from the point, and where it ends.
fn ends(q: &ShadowRay, got: &Way) -> [DVec3; 2] {
    let from = got.origin.as_dvec3() - q.position.as_dvec3();
    let at = |t: f32| from + f64::from(t) * got.direction.as_dvec3();
    [at(got.within.min), at(got.within.max)]
}

/// Whether the ray goes to the light from where it starts, which is as sound as the direction from the point.
pub(super) fn aimed_anew(q: &ShadowRay, got: &Way) -> Option<()> {
    let light = q.position.as_dvec3() + f64::from(q.distance) * q.toward.as_dvec3();
    let toward = (light - got.origin.as_dvec3()).try_normalize()?;
    judge::direction("the ray", toward.as_vec3(), got.direction).ok()
}

/// Where a step from the point goes that is not along the normal, but to the light or along an axis, on the light's side.
fn beside_the_normal(step: DVec3, q: &ShadowRay) -> Option<&'static str> {
    /// What rounding leaves, as a share of the step's length.
    const NONE: f64 = 1e-3;
    /// What is another direction.
    const SOME: f64 = 1e-2;
    let [toward, normal] = [q.toward, q.normal].map(|d| d.as_dvec3());
    let beside = |d: DVec3| step.cross(d).length() / step.length();
    let is_on_lights_side = step.dot(normal) * toward.dot(normal) > 0.0;
    if beside(normal) <= SOME || !is_on_lights_side {
        None
    } else if beside(toward) < NONE {
        Some("along its way")
    } else if DVec3::AXES.iter().any(|axis| beside(*axis) < NONE) {
        Some("away along one axis of the world")
    } else {
        None
    }
}

/// The start is on the light's side of all places where the surface may be, and not much farther.
pub(super) fn starts_off(q: &ShadowRay, got: &Way) -> Verdict {
    let [start, _] = ends(q, got);
    if !start.is_finite() {
        return Err("the ray starts nowhere: a number is missing or infinite".into());
    }
    let normal = q.normal.as_dvec3();
    let cosine = normal.dot(q.toward.as_dvec3());
    let needed = f64::from(q.error) * normal.abs().element_sum();
    let (off, far) = (normal.dot(start) * cosine.signum(), start.length());
    let origin = got.origin.as_dvec3() - q.position.as_dvec3();
    let is_behind = normal.dot(origin) * cosine.signum() >= ROUNDED * needed;
    if off < ROUNDED * needed && got.within.min < 0.0 && is_behind {
        Err(format!(
            "the interval begins {} m behind the ray's origin, where it may find its own surface again",
            -got.within.min
        ))
    } else if off < ROUNDED * needed
        && got.within.min >= 0.0
        && let Some(aside) = beside_the_normal(origin, q)
    {
        Err(format!(
            "the ray starts {} m {aside}: that is {} m off the surface, and {} m are needed",
            size(origin.length()),
            size(off),
            size(needed)
        ))
    } else if off < ROUNDED * needed {
        let side = if off < 0.0 {
            "on the wrong side of"
        } else {
            "off"
        };
        Err(format!(
            "the ray starts {} m {side} the point, but the surface may be {} m off: it may find its own surface again",
            size(off.abs()),
            size(needed)
        ))
    } else if far * cosine.abs() > FARTHEST * needed {
        Err(format!(
            "the ray starts {} m from the point, where {} m off the surface are enough: what is in between throws no shadow",
            size(far),
            size(needed)
        ))
    } else {
        Ok(())
    }
}

/// The end is before the light, and not much.
pub(super) fn ends_before(q: &ShadowRay, got: &Way) -> Verdict {
    let (distance, max) = (f64::from(q.distance), got.within.max);
    if distance.is_infinite() {
        // The largest f32 will do.
        return if max > 1e30 {
            Ok(())
        } else {
            Err(format!(
                "the light is infinitely far away, and the interval ends at {max} m"
            ))
        };
    }
    if max.is_infinite() {
        return Err(format!(
            "the interval does not end, but the light is at {distance} m"
        ));
    }
    let before = distance - ends(q, got)[1].dot(q.toward.as_dvec3());
    if before.is_nan() || before < NEAREST_END * distance {
        if before.abs() < f64::from(f32::EPSILON) * distance {
            return Err("the interval ends at the light, and not before it".to_owned());
        }
        Err(format!(
            "the interval ends {} m behind the light, and not before it",
            size((-before).max(0.0))
        ))
    } else if before > FARTHEST_END * distance + FARTHEST * f64::from(q.error) {
        Err(format!(
            "the interval ends {} m before the light, too soon",
            size(before)
        ))
    } else {
        Ok(())
    }
}
