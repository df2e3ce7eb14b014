//! Chapter 19: the unit disc, the ray through a lens, and the circle of confusion.

use super::Explained;
use super::ch01_rays::{Seen, answers};
use super::diagram::{Diagram, Ink};
use super::way::Way;
use glam::{DVec2, Vec2, dvec2};
use raybook_workbook::exercises::ch01_rays::CameraRayAnswer;
use raybook_workbook::exercises::ch19_depth_of_field::{
    CircleOfConfusion, ConcentricDisk, ThinLensRay,
};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

impl Explained for ConcentricDisk {
    fn work(&self, way: &mut Way) -> Vec<Vec2> {
        way.remark("The first point; the others go the same way:");
        way.of_first(self.points(), |way, u| {
            let u = way.pair("u", "", u.as_dvec2());
            let ab = way.pair("(a, b) = 2u − 1", "", 2.0 * u - 1.0);
            let (r, phi) = match (ab.x, ab.y) {
                (0.0, 0.0) => (0.0, 0.0),
                (a, b) if a.abs() > b.abs() => (a, FRAC_PI_4 * b / a),
                (a, b) => (b, FRAC_PI_2 - FRAC_PI_4 * a / b),
            };
            let r = way.number("r, of a and b the one that is larger", "", r);
            let phi = way.number(
                "φ, π/4 times the other over it, or π/2 less that",
                "rad",
                phi,
            );
            way.pair("r (cos φ, sin φ)", "", r * DVec2::from_angle(phi))
                .as_vec2()
        })
    }
}

impl Explained for ThinLensRay {
    fn work(&self, way: &mut Way) -> CameraRayAnswer {
        let [forward, right, up] = [self.forward, self.right, self.up].map(|d| d.as_dvec3());
        let [f, stop, focus] = [self.focal_length, self.f_number, self.focus].map(f64::from);
        let (film, plane) = (self.film.as_dvec2(), self.plane.as_dvec2());
        let distance = way.number(
            "the film's distance, f·s/(s − f)",
            "m",
            f * focus / (focus - f),
        );
        let on_film = (film - 0.5) * plane * dvec2(1.0, -1.0);
        let on_film = way.pair(
            "the place on the film from its middle, to the right and upwards",
            "m",
            on_film,
        );
        let central = distance * forward + on_film.x * right + on_film.y * up;
        let central = way.vector("v, through the middle of the lens", "m", central);
        let in_focus = way.vector(
            "v · s/distance: from the middle of the lens to the point in focus",
            "m",
            central * (focus / distance),
        );
        let radius = way.number("the aperture's radius, f/(2 f_number)", "m", 0.5 * f / stop);
        let lens = self.on_lens.as_dvec2();
        let offset = way.vector(
            "from the middle of the lens to the ray's origin",
            "m",
            radius * (lens.x * right + lens.y * up),
        );
        let direction = way.vector(
            "from there to the point in focus, of length 1",
            "",
            (in_focus - offset).normalize(),
        );
        let origin = way.vector("the origin", "m", self.lens_middle.as_dvec3() + offset);
        CameraRayAnswer {
            origin: origin.as_vec3(),
            direction: direction.as_vec3(),
        }
    }

    fn draw(&self, right: &CameraRayAnswer, yours: Option<&CameraRayAnswer>) -> Option<Diagram> {
        let camera = Seen {
            focal_point: self.lens_middle,
            axes: [*self.forward, *self.right, *self.up],
            film: self.film,
            plane: self.plane,
        };
        let (section, _, name) = camera.section();
        let focus = f64::from(self.focus);
        let radius = 0.5 * f64::from(self.focal_length) / f64::from(self.f_number);
        let across = usize::from(name != "right");
        // The point in focus, in the section.
        let on_film = (self.film.as_dvec2() - 0.5) * self.plane.as_dvec2() * dvec2(1.0, -1.0);
        let distance =
            f64::from(self.focal_length) * focus / (focus - f64::from(self.focal_length));
        let sharp = dvec2(focus, on_film[across] * focus / distance);
        let mut drawing = Diagram::new(format!(
            "The lens from its side: the ray, seen in the plane of `forward` and `{name}`"
        ));
        drawing.stretched = true;
        drawing.line(&[dvec2(0.0, -radius), dvec2(0.0, radius)], Ink::Shape);
        drawing.label(
            dvec2(0.0, radius),
            dvec2(0.0, 1.0),
            "the aperture",
            Ink::Shape,
        );
        let half = sharp.y.abs().max(radius);
        drawing.line(&[dvec2(focus, -half), dvec2(focus, half)], Ink::Guide);
        drawing.label(
            dvec2(focus, half),
            dvec2(0.0, 1.0),
            "the plane in focus",
            Ink::Guide,
        );
        drawing.arrow(dvec2(0.0, 0.0), sharp, Ink::Guide);
        drawing.point(sharp, Ink::Shape);
        answers(
            &mut drawing,
            &section,
            1.15 * sharp.length(),
            [Some(right), yours],
        );
        Some(drawing)
    }
}

impl Explained for CircleOfConfusion {
    fn work(&self, way: &mut Way) -> f32 {
        let [f, stop, s, x] =
            [self.focal_length, self.f_number, self.focus, self.distance].map(f64::from);
        let aperture = way.number(
            "A = focal_length/f_number, the aperture's diameter",
            "m",
            f / stop,
        );
        let share = way.number(
            "|x − s|/x: how much of that the cone has in the plane in focus",
            "",
            (1.0 - s / x).abs(),
        );
        let smaller = way.number(
            "f/(s − f): so much smaller the film shows it",
            "",
            f / (s - f),
        );
        way.number("A · |x − s|/x · f/(s − f)", "m", aperture * share * smaller) as f32
    }
}
