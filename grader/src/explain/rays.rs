//! What the chapters' explanations share about rays: in double precision, and drawn in a section.

use super::diagram::{Diagram, Ink};
use super::section::Section;
use super::view::View;
use super::way::Way;
use glam::{DVec2, DVec3, dvec2};
use raybook::math::{interval::Interval, ray::Ray};

/// A ray's origin and direction.
pub fn parts(ray: &Ray) -> (DVec3, DVec3) {
    (ray.origin.as_dvec3(), ray.direction.as_dvec3())
}

/// The interval of distances that count, for a search that hands it on.
pub fn interval(way: &mut Way, within: Interval) -> Interval {
    let min = way.part("within.min", f64::from(within.min));
    let max = way.part("within.max", f64::from(within.max));
    let max = way.made("to end the search at within.max", f64::INFINITY, max);
    Interval::new(min as f32, max as f32)
}

/// Whether a distance counts.
pub fn counts(way: &mut Way, within: Interval, t: f64) -> bool {
    let min = way.part("min", f64::from(within.min));
    let max = way.part("max", f64::from(within.max));
    way.is_less("t is larger than min", min, t) && way.is_less("t is smaller than max", t, max)
}

/// The distances of an interval at which a ray is in a box, or on its surface.
pub fn clipped(
    (o, d): (DVec3, DVec3),
    [mut enter, mut leave]: [f64; 2],
    min: DVec3,
    max: DVec3,
) -> Option<[f64; 2]> {
    for axis in 0..3 {
        let planes = [min[axis], max[axis]].map(|plane| (plane - o[axis]) / d[axis]);
        // The sign bit, so that −0.0 is the mirror image of 0.0.
        let backward = usize::from(d[axis].is_sign_negative());
        // `max` and `min` drop the NaN of a ray that runs in a face.
        (enter, leave) = (enter.max(planes[backward]), leave.min(planes[1 - backward]));
    }
    (enter <= leave).then_some([enter, leave])
}

/// Draws a ray up to a distance, its origin, and the distances on it that count.
pub fn ray(drawing: &mut Diagram, section: &Section, ray: &Ray, within: Interval, far: f64) {
    let (o, d) = parts(ray);
    let at = |t: f64| section.at(o + t * d);
    let [from, to] = [within.min, within.max].map(|t| f64::from(t).clamp(0.0, far));
    if from < to {
        drawing.line(&[at(from), at(to)], Ink::Interval);
    }
    drawing.arrow(at(0.0), at(far), Ink::Ray);
    drawing.point(at(0.0), Ink::Ray);
    drawing.label(at(0.0), dvec2(-1.0, 0.0), "o", Ink::Ray);
}

/// Draws a ray, seen along an axis, to a little behind a box, and the distances on it that count.
pub fn across(
    drawing: &mut Diagram,
    view: &View,
    ray: &Ray,
    within: Interval,
    [min, max]: [DVec3; 2],
) {
    let (o, d) = parts(ray);
    let size = (max - min).length();
    let passage = clipped((o, d), [0.0, f64::INFINITY], min, max);
    let far = passage.map_or((0.5 * (min + max) - o).length() + size, |[_, leave]| {
        leave + 0.1 * size
    });
    let at = |t: f64| view.at(o + t * d);
    let [from, to] = [within.min, within.max].map(|t| f64::from(t).clamp(0.0, far));
    if from < to {
        drawing.line(&[at(from), at(to)], Ink::Interval);
    }
    drawing.arrow(at(0.0), at(far), Ink::Ray);
}

/// Draws a ray as [`ray`] does, and where it hits, rightly and by the student.
pub fn hits(
    drawing: &mut Diagram,
    section: &Section,
    through: &Ray,
    within: Interval,
    far: f64,
    [right, yours]: [Option<f32>; 2],
) {
    ray(drawing, section, through, within, far);
    let (o, d) = parts(through);
    for (t, ink, beside, name) in answers(right, yours) {
        // What is far beyond the end would make all the rest a dot.
        let is_near = f64::from(t).abs() <= 2.0 * far;
        let at = section.at(o + if is_near { f64::from(t) } else { far } * d);
        let beyond = if is_near {
            ""
        } else {
            ", outside of the picture"
        };
        if is_near {
            drawing.point(at, ink);
        }
        drawing.label(at, beside, format!("{name}: t = {t}{beyond}"), ink);
    }
}

/// The answers that there are, the right one and the student's: each with its ink, the side of its label, and what it is called.
pub fn answers<T>(
    right: Option<T>,
    yours: Option<T>,
) -> impl Iterator<Item = (T, Ink, DVec2, &'static str)> {
    /// Upwards, beside a point.
    const UP: DVec2 = dvec2(0.2, 1.4);
    let both = [
        (right, Ink::Right, UP, "right"),
        (yours, Ink::Yours, -UP, "yours"),
    ];
    let both = both.into_iter();
    both.filter_map(|(answer, ink, beside, name)| Some((answer?, ink, beside, name)))
}

/// A length, or 1 where it is 0 or not finite: what is divided by it stays finite.
pub fn nonzero(length: f64) -> f64 {
    if length.is_finite() && length > 0.0 {
        length
    } else {
        1.0
    }
}
