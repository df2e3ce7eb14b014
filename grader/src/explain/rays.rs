//! What the chapters' explanations share about rays: in double precision, and drawn in a section.

use super::diagram::{Diagram, Ink};
use super::section::Section;
use glam::{DVec2, DVec3, dvec2};
use raybook::math::{interval::Interval, ray::Ray};

/// A ray's origin and direction.
pub fn parts(ray: &Ray) -> (DVec3, DVec3) {
    (ray.origin.as_dvec3(), ray.direction.as_dvec3())
}

/// Whether a distance counts.
pub fn counts(within: Interval, t: f64) -> bool {
    f64::from(within.min) < t && t < f64::from(within.max)
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
