//! Chapter 15: the shadow ray, magnified where it leaves the surface, and what is in its way.

use super::Explained;
use super::ch03_sphere;
use super::diagram::{Diagram, Ink};
use super::rays;
use super::section::Section;
use super::way::Way as Steps;
use glam::{DVec3, dvec2};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook_workbook::exercises::ch15_shadows::{Lit, ShadowRay, Way};

impl Explained for ShadowRay {
    fn work(&self, steps: &mut Steps) -> Way {
        /// The way ends this share of the distance before the light.
        const BEFORE_LIGHT: f64 = 1e-4;
        let error = steps.part("error", f64::from(self.error));
        let distance = steps.part("distance", f64::from(self.distance));
        let n = steps.part("n", self.normal.as_dvec3());
        let toward = steps.part("toward", self.toward.as_dvec3());
        let position = steps.part("position", self.position.as_dvec3());
        let sum = steps.part("|n.x| + |n.y| + |n.z|", n.abs().element_sum());
        let off = steps.number("off = error · (|n.x| + |n.y| + |n.z|)", "m", error * sum);
        let products = steps.part("the products that n·toward adds up", n * toward);
        let cosine = steps.number("n·toward", "", products.element_sum());
        let is_behind = steps.is_less("the light is on the other side of the normal", cosine, 0.0);
        let side = steps.part("the shift along n", if is_behind { -off } else { off });
        let shifted = position + side * n;
        let origin = steps.vector("position ± off·n, to the light's side", "m", shifted);
        let end = if steps.decides("the light has a finite distance", distance.is_finite()) {
            let twice = steps.part("2 error", 2.0 * error);
            let share = steps.part("10⁻⁴ distance", BEFORE_LIGHT * distance);
            let margin = steps.number("margin = 2 error + 10⁻⁴ distance", "m", twice + share);
            let left = steps.part("distance − margin", distance - margin);
            let is_near = steps.is_less("the margin is longer than the distance", left, 0.0);
            let end = if is_near { 0.0 } else { left };
            steps.number("end = distance − margin, 0 at least", "m", end)
        } else {
            steps.remark("The light is infinitely far away: everything ahead is before it.");
            f64::INFINITY
        };
        Way {
            origin: origin.as_vec3(),
            direction: toward.as_vec3(),
            within: Interval::new(steps.part("the beginning, 0", 0.0) as f32, end as f32),
        }
    }

    fn draw(&self, right: &Way, yours: Option<&Way>) -> Option<Diagram> {
        let (p, n) = (self.position.as_dvec3(), self.normal.as_dvec3());
        let error = f64::from(self.error);
        let toward = self.toward.as_dvec3();
        let mut section = Section::spanned(p, toward - toward.dot(n) * n, n);
        section.v = n;
        // Where the surface's error is 0 there is nothing to magnify.
        let size = if error > 0.0 { 6.0 * error } else { 1.0 };
        let mut drawing = Diagram::new(format!(
            "Where the shadow ray leaves the surface: the picture is {:.1e} m wide; the true surface is in the band",
            2.0 * size
        ));
        let band = [
            dvec2(-size, -error),
            dvec2(size, -error),
            dvec2(size, error),
            dvec2(-size, error),
        ];
        drawing.area(&band, Ink::Shape);
        drawing.line(&[dvec2(-size, 0.0), dvec2(size, 0.0)], Ink::Shape);
        drawing.arrow(dvec2(0.0, 0.0), dvec2(0.0, 0.8 * size), Ink::Shape);
        drawing.label(dvec2(0.0, 0.8 * size), dvec2(0.0, 0.8), "n", Ink::Shape);
        drawing.point(dvec2(0.0, 0.0), Ink::Ray);
        drawing.label(dvec2(0.0, 0.0), dvec2(-0.7, -0.8), "position", Ink::Ray);
        for (way, ink, beside, name) in rays::answers(Some(right), yours) {
            let from = section.at(way.origin.as_dvec3());
            let is_near = from.length() < 1.5 * size;
            let said = format!("{name}: the way ends at {} m", way.within.max);
            if is_near {
                let tip =
                    from + 0.6 * size * section.along(way.direction.as_dvec3().normalize_or_zero());
                drawing.point(from, ink);
                drawing.arrow(from, tip, ink);
                drawing.label(tip, beside, said, ink);
            } else {
                drawing.label(
                    dvec2(0.0, -0.8 * size),
                    dvec2(0.0, -1.0),
                    format!("{said}, and starts outside of the picture"),
                    ink,
                );
            }
        }
        Some(drawing)
    }
}

impl Explained for Lit {
    fn work(&self, way: &mut Steps) -> u32 {
        let shadow = ShadowRay {
            position: self.position,
            error: self.error,
            normal: self.normal,
            toward: self.toward,
            distance: self.distance,
        };
        let shadow = shadow.work(way);
        let toward = Dir3::new_or(shadow.direction, self.toward);
        let ray = Ray::new(shadow.origin, toward);
        let mut hides = Vec::new();
        for (i, ball) in self.spheres.iter().enumerate() {
            let center: DVec3 = ball.center.as_dvec3();
            // Its own steps are those of `sphere_hit`.
            let meets = way.silently(|way| {
                ch03_sphere::meets(way, &ray, shadow.within, center, ball.radius.into())
            });
            hides.push(meets.is_some());
            match meets {
                Some(t) => {
                    way.number(format!("sphere {i} is in the way, at t ="), "m", t);
                }
                None => way.remark(format!("Sphere {i} is not in the way.")),
            }
        }
        let lit = !way.any("a sphere is in the way", &hides);
        way.number("lit", "", f64::from(u8::from(lit)));
        lit.into()
    }
}
