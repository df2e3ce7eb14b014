//! Where a line meets a shape, and its normal there.

use glam::{DVec3, Vec3};
use raybook::scene::description::Form;

/// Nearer than this a ray does not meet anything: it has just left there.
const LEAVES: f64 = 1e-5;

/// A line that light takes to the eye, backwards.
#[derive(Clone, Copy)]
pub struct Line {
    pub origin: DVec3,
    pub direction: DVec3,
}

impl Line {
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + t * self.direction
    }
}

/// The distance at which a line meets a shape ahead, if it does.
pub fn meets(form: &Form, line: Line) -> Option<f64> {
    let Line {
        origin: o,
        direction: d,
    } = line;
    let ahead = |t: f64| (t > LEAVES && t.is_finite()).then_some(t);
    match form {
        Form::Sphere(sphere) => {
            let m = o - sphere.center.as_dvec3();
            let (half, radius) = (m.dot(d), f64::from(sphere.radius));
            let root = (half * half - m.length_squared() + radius * radius).sqrt();
            // Of a line that misses the root is NaN, which is never ahead.
            ahead(-half - root).or_else(|| ahead(-half + root))
        }
        Form::Plane(plane) => {
            let n = plane.normal.as_dvec3();
            ahead((f64::from(plane.offset) - n.dot(o)) / n.dot(d))
        }
        Form::Triangle(corners) => {
            let [p0, p1, p2] = [corners.p0, corners.p1, corners.p2].map(Vec3::as_dvec3);
            let n = (p1 - p0).cross(p2 - p0);
            let t = ahead((p0 - o).dot(n) / d.dot(n))?;
            let p = line.at(t);
            let inside = |a: DVec3, b: DVec3| (b - a).cross(p - a).dot(n) >= 0.0;
            (inside(p0, p1) && inside(p1, p2) && inside(p2, p0)).then_some(t)
        }
    }
}

/// The normal of a shape at a point, which points outside.
pub fn normal(form: &Form, p: DVec3) -> DVec3 {
    match form {
        Form::Sphere(sphere) => (p - sphere.center.as_dvec3()).normalize_or(DVec3::Y),
        Form::Plane(plane) => plane.normal.as_dvec3(),
        Form::Triangle(corners) => {
            let [p0, p1, p2] = [corners.p0, corners.p1, corners.p2].map(Vec3::as_dvec3);
            (p1 - p0).cross(p2 - p0).normalize_or(DVec3::Y)
        }
    }
}
