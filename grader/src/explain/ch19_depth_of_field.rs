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
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

/// The same by rings: the root of one number is the distance from the middle, the other one the angle.
fn by_rings(asked: &ConcentricDisk, way: &mut Way) -> Vec<Vec2> {
    way.of_first(asked.points(), |way, u| {
        let first = way.part("u.x", f64::from(u.x));
        let second = way.part("u.y", f64::from(u.y));
        let r = way.part("r = √u.x", first.sqrt());
        let phi = way.part("φ = 2π u.y", TAU * second);
        let cos = way.part("cos φ", phi.cos());
        let sin = way.part("sin φ", phi.sin());
        way.part("r (cos φ, sin φ)", r * dvec2(cos, sin)).as_vec2()
    })
}

impl Explained for ConcentricDisk {
    fn work(&self, way: &mut Way) -> Vec<Vec2> {
        way.remark("The first point; the others go the same way:");
        way.of_first(self.points(), |way, u| {
            let u = way.pair("u", "", u.as_dvec2());
            let ab = way.pair("(a, b) = 2u − 1", "", 2.0 * u - 1.0);
            let (a, b) = (ab.x, ab.y);
            let is_wide = way.decides("a is farther from 0 than b", a.abs() > b.abs());
            let (r, phi) = if (a, b) == (0.0, 0.0) {
                (0.0, 0.0)
            } else if is_wide {
                (a, way.part("π/4 · b/a", FRAC_PI_4 * b / a))
            } else {
                let less = way.part("π/4 · a/b", FRAC_PI_4 * a / b);
                (b, FRAC_PI_2 - less)
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

    const WAYS: &'static [fn(&Self, &mut Way) -> Vec<Vec2>] = &[Self::work, by_rings];
}

/// The same by the point in focus, which is on the film as it would be in the plane in focus, larger.
fn by_the_plane_in_focus(asked: &ThinLensRay, way: &mut Way) -> CameraRayAnswer {
    let [forward, right, up] = [asked.forward, asked.right, asked.up].map(|d| d.as_dvec3());
    let f = way.part("f", f64::from(asked.focal_length));
    let stop = way.part("f_number", f64::from(asked.f_number));
    let focus = way.part("s", f64::from(asked.focus));
    let longer = way.part("s − f", focus - f);
    let distance = way.part("the film's distance, f·s/(s − f)", f * focus / longer);
    let larger = way.part("s over the film's distance", focus / distance);
    let from_middle = asked.film.as_dvec2() - 0.5;
    let on_film = from_middle * asked.plane.as_dvec2() * dvec2(1.0, -1.0);
    let on_film = way.part("the place on the film from its middle", on_film);
    let place = way.part("the place in the plane in focus", on_film * larger);
    let ahead = way.part("s, along forward", focus);
    let in_focus = place.x * right + place.y * up + ahead * forward;
    let radius = way.part("the aperture's radius, f/(2 f_number)", 0.5 * f / stop);
    let lens = way.part("on_lens", asked.on_lens.as_dvec2());
    let offset = way.part("on_lens · the radius", lens * radius);
    let offset = offset.x * right + offset.y * up;
    let from = way.part("the point of the lens, from its middle", offset);
    CameraRayAnswer {
        origin: (asked.lens_middle.as_dvec3() + offset).as_vec3(),
        direction: (in_focus - from).normalize().as_vec3(),
    }
}

impl Explained for ThinLensRay {
    const WAYS: &'static [fn(&Self, &mut Way) -> CameraRayAnswer] =
        &[Self::work, by_the_plane_in_focus];

    fn work(&self, way: &mut Way) -> CameraRayAnswer {
        let [forward, right, up] = [self.forward, self.right, self.up].map(|d| d.as_dvec3());
        let f = way.part("f", f64::from(self.focal_length));
        let stop = way.part("f_number", f64::from(self.f_number));
        let focus = way.part("s", f64::from(self.focus));
        let film = way.part("film", self.film.as_dvec2());
        let plane = way.part("plane", self.plane.as_dvec2());
        let longer = way.part("s − f", focus - f);
        let product = way.part("f·s", f * focus);
        let distance = way.number("the film's distance, f·s/(s − f)", "m", product / longer);
        let from_middle = way.part("film − ½", film - 0.5);
        let on_film = from_middle * plane * dvec2(1.0, -1.0);
        let on_film = way.pair(
            "the place on the film from its middle, to the right and upwards",
            "m",
            on_film,
        );
        let ahead = way.part("distance · forward", distance * forward);
        let aside = way.part("what goes along right", on_film.x * right);
        let upwards = way.part("what goes along up", on_film.y * up);
        let central = ahead + aside + upwards;
        let central = way.vector("v, through the middle of the lens", "m", central);
        let times = way.part("s/distance", focus / distance);
        let in_focus = way.vector(
            "v · s/distance: from the middle of the lens to the point in focus",
            "m",
            central * times,
        );
        let radius = way.number("the aperture's radius, f/(2 f_number)", "m", 0.5 * f / stop);
        let lens = way.part("on_lens", self.on_lens.as_dvec2());
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
        let middle = way.part("lens_middle", self.lens_middle.as_dvec3());
        let origin = way.vector("the origin", "m", middle + offset);
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

/// The same by the lens equation: where the film is, and where the cone has its tip.
fn by_the_lens_equation(asked: &CircleOfConfusion, way: &mut Way) -> f32 {
    let f = way.part("focal_length", f64::from(asked.focal_length));
    let stop = way.part("f_number", f64::from(asked.f_number));
    let s = way.part("s", f64::from(asked.focus));
    let x = way.part("x", f64::from(asked.distance));
    let of_lens = way.part("1/f at the film", f.recip());
    let of_focus = way.part("1/s", s.recip());
    let of_film = way.part("1/f − 1/s", of_lens - of_focus);
    let film = way.part("the film's distance, 1/(1/f − 1/s)", of_film.recip());
    let of_lens = way.part("1/f at the tip", f.recip());
    let of_point = way.part("1/x", x.recip());
    let of_tip = way.part("1/f − 1/x, 1 over the tip's distance", of_lens - of_point);
    let ratio = way.part("the film's distance over the tip's", film * of_tip);
    let share = way.part("1 − that ratio", 1.0 - ratio);
    let share = way.part("that without its sign", share.abs());
    let aperture = way.part("f/f_number", f / stop);
    way.part("the circle's diameter", aperture * share) as f32
}

impl Explained for CircleOfConfusion {
    fn work(&self, way: &mut Way) -> f32 {
        let f = way.part("focal_length", f64::from(self.focal_length));
        let stop = way.part("f_number", f64::from(self.f_number));
        let s = way.part("s", f64::from(self.focus));
        let x = way.part("x", f64::from(self.distance));
        let aperture = way.number(
            "A = focal_length/f_number, the aperture's diameter",
            "m",
            f / stop,
        );
        let ratio = way.part("s/x", s / x);
        let share = way.part("(x − s)/x", 1.0 - ratio);
        let share = way.number(
            "|x − s|/x: how much of that the cone has in the plane in focus",
            "",
            share.abs(),
        );
        let longer = way.part("s − f", s - f);
        let smaller = way.number(
            "f/(s − f): so much smaller the film shows it",
            "",
            f / longer,
        );
        way.number("A · |x − s|/x · f/(s − f)", "m", aperture * share * smaller) as f32
    }

    const WAYS: &'static [fn(&Self, &mut Way) -> f32] = &[Self::work, by_the_lens_equation];
}
