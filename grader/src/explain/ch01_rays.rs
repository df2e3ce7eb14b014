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
        let t = way.part("t", f64::from(self.t));
        let o = way.part("o", o);
        let d = way.part("d", d);
        let along = way.vector("t·d", "m", t * d);
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

/// The same from the film's top left corner, across and down.
fn from_corner(asked: &CameraRay, way: &mut Way) -> CameraRayAnswer {
    let [forward, right, up] = [asked.forward, asked.right, asked.up].map(|d| d.as_dvec3());
    let f = way.part("focal_length", f64::from(asked.focal_length));
    let wide = way.part("plane.x", f64::from(asked.plane.x));
    let high = way.part("plane.y", f64::from(asked.plane.y));
    // Whoever takes one for the other does so in the corner, or on the way from there.
    let of_corner = way.part("plane.x in the corner", wide);
    let left = way.part("half of plane.x", 0.5 * of_corner);
    let of_corner = way.part("plane.y in the corner", high);
    let top = way.part("half of plane.y", 0.5 * of_corner);
    let [right, up] = [way.part("right", right), way.part("up", up)];
    let ahead = way.part("focal_length·forward", f * forward);
    let to_left = way.part("from the middle to the left edge", left * right);
    let to_top = way.part("from the middle to the top edge", top * up);
    let corner = way.part("the top left corner", ahead - to_left + to_top);
    let x = way.part("film.x", f64::from(asked.film.x));
    let y = way.part("film.y", f64::from(asked.film.y));
    let wide = way.part("plane.x, across", wide);
    let high = way.part("plane.y, down", high);
    let right = way.part("right, across", right);
    let up = way.part("up, down", up);
    let across = way.part("film.x · plane.x · right", x * wide * right);
    let down = way.part("film.y · plane.y · up", y * high * up);
    let place = way.part("the place on the film", corner + across - down);
    let direction = way.part("the direction", place.normalize());
    let start = way.part("focal_point", asked.focal_point.as_dvec3());
    CameraRayAnswer {
        origin: start.as_vec3(),
        direction: direction.as_vec3(),
    }
}

/// The same from the place of the film in space: the direction leads there from the focal point.
fn from_place(asked: &CameraRay, way: &mut Way) -> CameraRayAnswer {
    let [forward, right, up] = [asked.forward, asked.right, asked.up].map(|d| d.as_dvec3());
    let (film, plane) = (asked.film.as_dvec2(), asked.plane.as_dvec2());
    let start = way.part("focal_point", asked.focal_point.as_dvec3());
    let ahead = way.part(
        "focal_length·forward",
        f64::from(asked.focal_length) * forward,
    );
    let middle = way.part("the middle of the film", start + ahead);
    let aside = way.part("x·right", (film.x - 0.5) * plane.x * right);
    let upward = way.part("y·up", (0.5 - film.y) * plane.y * up);
    let place = way.part("the place of the film in space", middle + aside + upward);
    let from = way.part("focal_point", asked.focal_point.as_dvec3());
    let toward = way.part("the way to that place", place - from);
    let direction = way.part("the direction", toward.normalize());
    CameraRayAnswer {
        origin: start.as_vec3(),
        direction: direction.as_vec3(),
    }
}

impl Explained for CameraRay {
    const WAYS: &'static [fn(&Self, &mut Way) -> CameraRayAnswer] =
        &[Self::work, from_corner, from_place];

    fn work(&self, way: &mut Way) -> CameraRayAnswer {
        let [forward, right, up] = [self.forward, self.right, self.up].map(|d| d.as_dvec3());
        let (film, plane) = (self.film.as_dvec2(), self.plane.as_dvec2());
        let across = way.part("film.x − ½", film.x - 0.5);
        let wide = way.part("plane.x", plane.x);
        let x = way.number("x = (film.x − ½) · plane.x", "m", across * wide);
        let above = way.part("½ − film.y", 0.5 - film.y);
        let high = way.part("plane.y", plane.y);
        let y = way.number("y = (½ − film.y) · plane.y", "m", above * high);
        let f = way.part("focal_length", f64::from(self.focal_length));
        let ahead = way.part("focal_length·forward", f * forward);
        let aside = way.part("x·right", x * right);
        let upward = way.part("y·up", y * up);
        let toward = way.vector(
            "v = focal_length·forward + x·right + y·up",
            "m",
            ahead + aside + upward,
        );
        let length = way.number("|v|", "m", toward.length());
        let direction = way.vector("v/|v|", "", toward / length);
        let start = way.part("focal_point", self.focal_point.as_dvec3());
        CameraRayAnswer {
            origin: start.as_vec3(),
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
