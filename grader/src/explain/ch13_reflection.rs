//! Chapter 13: the mirror, in the plane of the ray and the normal.

use super::Explained;
use super::diagram::{Diagram, Ink};
use super::rays;
use super::section::Section;
use super::way::Way;
use glam::{DVec3, Vec3, dvec2};
use raybook_workbook::exercises::ch13_reflection::Reflect;

impl Explained for Reflect {
    fn work(&self, way: &mut Way) -> Vec3 {
        let (i, n) = (self.incoming.as_dvec3(), self.normal.as_dvec3());
        let i = way.part("i", i);
        let n = way.part("n", n);
        let products = way.part("the products that i·n adds up", i * n);
        let cosine = way.number("i·n", "", products.element_sum());
        let twice = way.part("2 (i·n)", 2.0 * cosine);
        let along = way.part("n, behind 2 (i·n)", n);
        let part = way.vector("2 (i·n) n: twice the part of i along n", "", twice * along);
        let reflected = way.vector("i − 2 (i·n) n", "", i - part);
        way.vector("the same of length 1", "", reflected.normalize_or(-i))
            .as_vec3()
    }

    fn draw(&self, right: &Vec3, yours: Option<&Vec3>) -> Option<Diagram> {
        let mut drawing =
            Diagram::new("The mirror from its side, in the plane of the ray and the normal");
        surface(
            &mut drawing,
            self.incoming.as_dvec3(),
            self.normal.as_dvec3(),
            ["", ""],
            [Some(*right), yours.copied()],
        );
        Some(drawing)
    }
}

/// Draws a surface from its side with its normal, a ray that arrives, and where the answers send it on. `sides` names what is where
/// the normal points, and what is behind.
pub fn surface(
    drawing: &mut Diagram,
    incoming: DVec3,
    n: DVec3,
    sides: [&str; 2],
    [right, yours]: [Option<Vec3>; 2],
) {
    let mut section = Section::spanned(DVec3::ZERO, incoming - incoming.dot(n) * n, n);
    section.v = n;
    let middle = dvec2(0.0, 0.0);
    drawing.line(&[dvec2(-1.2, 0.0), dvec2(1.2, 0.0)], Ink::Shape);
    drawing.label(dvec2(-1.2, 0.0), dvec2(0.5, 0.8), sides[0], Ink::Shape);
    drawing.label(dvec2(-1.2, 0.0), dvec2(0.5, -1.2), sides[1], Ink::Shape);
    drawing.line(&[dvec2(0.0, -0.8), dvec2(0.0, 0.0)], Ink::Guide);
    drawing.arrow(middle, dvec2(0.0, 0.8), Ink::Shape);
    drawing.label(dvec2(0.0, 0.8), dvec2(0.0, 0.9), "n", Ink::Shape);
    let from = -section.along(incoming);
    drawing.arrow(from, middle, Ink::Ray);
    drawing.label(from, from.normalize_or_zero(), "i", Ink::Ray);
    for (direction, ink, beside, name) in rays::answers(right, yours) {
        let tip = section.along(direction.as_dvec3()).clamp_length_max(3.0);
        drawing.arrow(middle, tip, ink);
        drawing.label(tip, beside, name, ink);
    }
}
