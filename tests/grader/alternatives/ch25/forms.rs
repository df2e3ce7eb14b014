//! Where rays meet the three shapes, each by two methods.

use super::scene::Form;
use glam::DVec3;

impl Form {
    /// The nearest distance ahead, and the outward normal there.
    pub fn hit(&self, o: DVec3, d: DVec3, other: bool) -> Option<(f64, DVec3)> {
        let t = match (self, other) {
            (Self::Sphere(c, r), false) => by_formula(*c - o, d, *r),
            (Self::Sphere(c, r), true) => by_pythagoras(*c - o, d, *r),
            (Self::Plane(n, offset), _) => Some((offset - n.dot(o)) / n.dot(d)),
            (Self::Triangle(corners), false) => by_cramer(o, d, corners),
            (Self::Triangle(corners), true) => by_edges(o, d, corners),
        };
        let t = t.filter(|&t| t > 0.0 && t < f64::INFINITY)?;
        let normal = match self {
            Self::Sphere(c, r) => (o + t * d - c) / r,
            Self::Plane(n, _) => *n,
            Self::Triangle([p0, p1, p2]) => (p1 - p0).cross(p2 - p0).normalize(),
        };
        Some((t, normal))
    }
}

/// (−b ± √(b² − 4c))/2.
fn by_formula(to_center: DVec3, d: DVec3, r: f64) -> Option<f64> {
    let (b, c) = (-2.0 * to_center.dot(d), to_center.length_squared() - r * r);
    let root = (b * b - 4.0 * c).sqrt();
    [0.5 * (-b - root), 0.5 * (-b + root)]
        .into_iter()
        .find(|&t| t > 0.0)
}

/// Half a chord before and behind the point nearest to the centre.
fn by_pythagoras(to_center: DVec3, d: DVec3, r: f64) -> Option<f64> {
    let middle = to_center.dot(d);
    let aside = to_center.cross(d).length();
    let half = ((r + aside) * (r - aside)).sqrt();
    [middle - half, middle + half]
        .into_iter()
        .find(|&t| t > 0.0)
}

fn by_cramer(o: DVec3, d: DVec3, [p0, p1, p2]: &[DVec3; 3]) -> Option<f64> {
    let (e1, e2, s) = (p1 - p0, p2 - p0, o - p0);
    let determinant = d.cross(e2).dot(e1);
    let b1 = d.cross(e2).dot(s) / determinant;
    let b2 = s.cross(e1).dot(d) / determinant;
    let t = s.cross(e1).dot(e2) / determinant;
    (b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0).then_some(t)
}

/// The point of the triangle's plane, if it is on the same side of all edges.
fn by_edges(o: DVec3, d: DVec3, corners: &[DVec3; 3]) -> Option<f64> {
    let [p0, p1, p2] = *corners;
    let normal = (p1 - p0).cross(p2 - p0);
    let t = normal.dot(p0 - o) / normal.dot(d);
    let p = o + t * d;
    let inside = [(p0, p1), (p1, p2), (p2, p0)]
        .iter()
        .all(|(a, b)| (b - a).cross(p - a).dot(normal) >= 0.0);
    inside.then_some(t)
}
