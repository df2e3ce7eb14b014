//! Chapter 4: the plane, seen from its side.

use super::Explained;
use super::diagram::{Diagram, Ink};
use super::rays::{self, nonzero};
use super::section::Section;
use super::way::Way;
use glam::dvec2;
use raybook_workbook::exercises::ch04_plane::PlaneHit;

/// The same by similar triangles: the height above the plane, and how much of it a metre of the ray takes.
fn by_height(asked: &PlaneHit, way: &mut Way) -> Option<f32> {
    let (o, d) = rays::parts(&asked.ray);
    let n = way.part("n", asked.normal.as_dvec3());
    let offset = way.part("offset", f64::from(asked.offset));
    let start = way.part("n·o", n.dot(o));
    let height = way.part("n·o − offset, the height above the plane", start - offset);
    let speed = way.part("n·d", n.dot(d));
    let sinks = way.part("−n·d, how fast the ray sinks", -speed);
    if way.is_zero("the ray is parallel to the plane", sinks) {
        return None;
    }
    let t = way.part("t = the height/(−n·d)", height / sinks);
    rays::counts(way, asked.within, t).then_some(t as f32)
}

/// The same by a point of the plane.
fn by_point(asked: &PlaneHit, way: &mut Way) -> Option<f32> {
    let (o, d) = rays::parts(&asked.ray);
    let o = way.part("o", o);
    let d = way.part("d", d);
    let n = way.part("n", asked.normal.as_dvec3());
    let offset = way.part("offset", f64::from(asked.offset));
    let point = way.part("a point of the plane, offset · n", offset * n);
    let to_plane = way.part("from o to that point", point - o);
    let beside = way.part("n in the numerator", n);
    let numerator = way.part("(offset · n − o)·n", to_plane.dot(beside));
    let denominator = way.part("n·d", n.dot(d));
    if way.is_zero("the ray is parallel to the plane", denominator) {
        return None;
    }
    let t = way.part("t = (offset · n − o)·n/(n·d)", numerator / denominator);
    rays::counts(way, asked.within, t).then_some(t as f32)
}

impl Explained for PlaneHit {
    const WAYS: &'static [fn(&Self, &mut Way) -> Option<f32>] = &[Self::work, by_height, by_point];

    fn work(&self, way: &mut Way) -> Option<f32> {
        let (o, d) = rays::parts(&self.ray);
        let o = way.part("o", o);
        let n = way.part("n", self.normal.as_dvec3());
        let offset = way.part("offset", f64::from(self.offset));
        let height = way.part("n·o", n.dot(o));
        let n = way.part("n in n·d", n);
        let d = way.part("d in n·d", d);
        let numerator = way.number(
            "offset − n·o: from the ray's start to the plane, along n",
            "m",
            offset - height,
        );
        let denominator = way.number("n·d: how fast the ray gets there", "", n.dot(d));
        if way.is_zero("the ray is parallel to the plane", denominator) {
            way.remark("n·d is 0: the ray is parallel to the plane.");
            return None;
        }
        let t = way.number("t = (offset − n·o)/(n·d)", "m", numerator / denominator);
        if rays::counts(way, self.within, t) {
            Some(t as f32)
        } else {
            way.remark("t is not between min and max.");
            None
        }
    }

    fn draw(&self, right: &Option<f32>, yours: Option<&Option<f32>>) -> Option<Diagram> {
        let (o, d) = rays::parts(&self.ray);
        let n = self.normal.as_dvec3();
        let above = n.dot(o) - f64::from(self.offset);
        let foot = o - above * n;
        let mut section = Section::spanned(foot, d - d.dot(n) * n, n);
        section.v = n;
        let meets = -above / n.dot(d);
        let far = 1.4
            * nonzero(if meets.is_finite() && meets > 0.0 {
                meets
            } else {
                above.abs()
            });
        let mut drawing =
            Diagram::new("The plane from its side: the ray and the normal lie in the picture");
        let end = section.along(far * d).x.abs().max(0.8 * far);
        drawing.line(&[dvec2(-0.3 * end, 0.0), dvec2(1.1 * end, 0.0)], Ink::Shape);
        drawing.label(
            dvec2(1.1 * end, 0.0),
            dvec2(-0.2, -1.0),
            "the plane",
            Ink::Shape,
        );
        drawing.arrow(dvec2(0.0, 0.0), dvec2(0.0, 0.25 * far), Ink::Shape);
        drawing.label(dvec2(0.0, 0.25 * far), dvec2(-0.6, 0.0), "n", Ink::Shape);
        rays::hits(
            &mut drawing,
            &section,
            &self.ray,
            self.within,
            far,
            [*right, yours.copied().flatten()],
        );
        Some(drawing)
    }
}
