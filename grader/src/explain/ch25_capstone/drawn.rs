//! The way of a ray in a drawing.

use super::tracer::traced;
use crate::explain::diagram::{Diagram, Ink};
use crate::explain::view::View;
use crate::explain::way::Way;
use glam::{DVec3, Vec3, dvec2};
use raybook::scene::description::Form;
use raybook_workbook::exercises::ch25_capstone::Trace;

/// The ray from surface to surface, and to the lamps, in front of the shapes that are near.
pub fn drawn(q: &Trace) -> Diagram {
    let (traced, _) = traced(q, &mut Way::default());
    let (o, d) = (q.ray.origin.as_dvec3(), q.ray.direction.as_dvec3());
    let ends = || traced.iter().flat_map(|part| part.ends).chain([o]);
    let (min, max) = ends().fold((o, o + d), |(min, max), p| (min.min(p), max.max(p)));
    let view = View::least(max - min);
    let size = (max - min).length();
    let mut drawing = Diagram::new(format!(
        "The way of the ray through the scene, {}; dashed from a surface to the lamps",
        view.words()
    ));
    for (i, object) in q.scene.objects.iter().enumerate() {
        let near = |p: DVec3| p.clamp(min, max).distance(p) < size;
        let mut name =
            |at: DVec3| drawing.label(view.at(at), dvec2(0.0, 0.0), format!("{i}"), Ink::Shape);
        match &object.form {
            Form::Sphere(sphere) if near(sphere.center.as_dvec3()) => {
                name(sphere.center.as_dvec3());
                drawing.circle(
                    view.at(sphere.center.as_dvec3()),
                    sphere.radius.into(),
                    Ink::Shape,
                );
            }
            Form::Triangle(corners) => {
                let corners = [corners.p0, corners.p1, corners.p2].map(Vec3::as_dvec3);
                if corners.into_iter().all(near) {
                    name((corners[0] + corners[1] + corners[2]) / 3.0);
                    drawing.area(&corners.map(|p| view.at(p)), Ink::Shape);
                }
            }
            Form::Plane(plane) => {
                let n = plane.normal.as_dvec3();
                let middle = 0.5 * (min + max);
                let foot = middle + (f64::from(plane.offset) - n.dot(middle)) * n;
                let across = view.at(n).perp();
                // A plane that is seen from above is everywhere; one from its side is a line.
                if across.length() > 0.99 && near(foot) {
                    let half = 0.5 * size * across;
                    drawing.line(&[view.at(foot) - half, view.at(foot) + half], Ink::Shape);
                    drawing.label(
                        view.at(foot) + half,
                        dvec2(0.0, 0.9),
                        format!("{i}"),
                        Ink::Shape,
                    );
                }
            }
            Form::Sphere(_) => {}
        }
    }
    for part in &traced {
        let [from, to] = part.ends.map(|p| view.at(p));
        if part.is_to_lamp {
            drawing.line(&[from, to], Ink::Guide);
            drawing.label(to, dvec2(0.0, 0.9), "lamp", Ink::Guide);
        } else {
            drawing.arrow(from, to, Ink::Ray);
        }
    }
    if traced.is_empty() {
        drawing.arrow(view.at(o), view.at(o + d), Ink::Ray);
    }
    drawing
}
