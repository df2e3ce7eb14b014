//! Chapter 1: the point on a ray, and the ray through a place of the film.

use super::Explained;
use super::diagram::{Diagram, Ink};
use super::rays::{self, nonzero};
use super::section::Section;
use super::way::Way;
use glam::{DVec3, Vec2, Vec3, dvec2};
use raybook::math::interval::Interval;
use raybook_workbook::exercises::ch01_rays::{CameraRay, CameraRayAnswer, RayAt};

impl Explained for RayAt {
    fn work(&self, way: &mut Way) -> Vec3 {
        let (o, d) = rays::parts(&self.ray);
        let along = way.vector("t·d", "m", f64::from(self.t) * d);
        way.vector("o + t·d", "m", o + along).as_vec3()
    }

    fn draw(&self, right: &Vec3, yours: Option<&Vec3>) -> Option<Diagram> {
        let (o, d) = rays::parts(&self.ray);
        let [right, yours] = [Some(right), yours].map(|p| p.map(|p| p.as_dvec3()));
        let section = Section::spanned(o, d, yours.unwrap_or(o + DVec3::Y) - o);
        let mut drawing = Diagram::new(
            "The point at the distance t along a ray, in the plane of the ray and your point",
        );
        let far = 1.3 * nonzero(f64::from(self.t).abs());
        rays::ray(
            &mut drawing,
            &section,
            &self.ray,
            Interval::new(0.0, 0.0),
            far,
        );
        for (p, ink, beside, name) in rays::answers(right, yours) {
            drawing.point(section.at(p), ink);
            drawing.label(section.at(p), beside, name, ink);
        }
        Some(drawing)
    }
}

impl Explained for CameraRay {
    fn work(&self, way: &mut Way) -> CameraRayAnswer {
        let [forward, right, up] = [self.forward, self.right, self.up].map(|d| d.as_dvec3());
        let (film, plane) = (self.film.as_dvec2(), self.plane.as_dvec2());
        let x = way.number("x = (film.x − ½) · plane.x", "m", (film.x - 0.5) * plane.x);
        let y = way.number("y = (½ − film.y) · plane.y", "m", (0.5 - film.y) * plane.y);
        let f = f64::from(self.focal_length);
        let toward = way.vector(
            "v = focal_length·forward + x·right + y·up",
            "m",
            f * forward + x * right + y * up,
        );
        let length = way.number("|v|", "m", toward.length());
        let direction = way.vector("v/|v|", "", toward / length);
        CameraRayAnswer {
            origin: self.focal_point,
            direction: direction.as_vec3(),
        }
    }

    fn draw(&self, right: &CameraRayAnswer, yours: Option<&CameraRayAnswer>) -> Option<Diagram> {
        let camera = Seen {
            focal_point: self.focal_point,
            axes: [*self.forward, *self.right, *self.up],
            film: self.film,
            plane: self.plane,
        };
        let (section, half, name) = camera.section();
        let f = f64::from(self.focal_length);
        let mut drawing = Diagram::new(format!(
            "The camera from its side: the ray through the film, along `forward` and `{name}`"
        ));
        drawing.line(&[dvec2(f, -half), dvec2(f, half)], Ink::Shape);
        drawing.label(
            dvec2(f, half),
            dvec2(0.0, 0.6),
            "the image plane",
            Ink::Shape,
        );
        drawing.arrow(dvec2(0.0, 0.0), dvec2(1.3 * f, 0.0), Ink::Guide);
        drawing.label(dvec2(1.3 * f, 0.0), dvec2(0.5, 0.0), "forward", Ink::Guide);
        drawing.point(dvec2(0.0, 0.0), Ink::Ray);
        drawing.label(dvec2(0.0, 0.0), dvec2(-1.0, 0.0), "focal point", Ink::Ray);
        answers(
            &mut drawing,
            &section,
            1.6 * f.hypot(half),
            [Some(right), yours],
        );
        Some(drawing)
    }
}

/// A camera of which a section is drawn.
pub struct Seen {
    /// All of its rays pass here.
    pub focal_point: Vec3,
    /// Forward, right and up.
    pub axes: [Vec3; 3],
    /// The place on the film.
    pub film: Vec2,
    /// The film's extents.
    pub plane: Vec2,
}

impl Seen {
    /// The section along `forward` in which the place on the film is farther from the middle, half the film's extent in it, and
    /// the name of the axis that points upwards in it.
    pub fn section(&self) -> (Section, f64, &'static str) {
        let from_middle = ((self.film - 0.5) * self.plane).abs();
        let across = if from_middle.x > from_middle.y { 1 } else { 2 };
        let section = Section::spanned(
            self.focal_point.as_dvec3(),
            self.axes[0].as_dvec3(),
            self.axes[across].as_dvec3(),
        );
        let extents = [self.plane.x, self.plane.y];
        (
            section,
            0.5 * f64::from(extents[across - 1]),
            ["right", "up"][across - 1],
        )
    }
}

/// Draws rays of this length as they were answered: the right one, and the student's.
pub fn answers(
    drawing: &mut Diagram,
    section: &Section,
    far: f64,
    [right, yours]: [Option<&CameraRayAnswer>; 2],
) {
    for (ray, ink, beside, name) in rays::answers(right, yours) {
        let from = section.at(ray.origin.as_dvec3());
        // A direction of any length goes as far.
        let to = from + far * section.along(ray.direction.as_dvec3().normalize_or_zero());
        drawing.arrow(from, to, ink);
        drawing.label(to, beside, name, ink);
    }
}
