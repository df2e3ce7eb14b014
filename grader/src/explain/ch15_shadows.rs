//! Chapter 15: the shadow ray, magnified where it leaves the surface, and what is in its way.

use super::Explained;
use super::ch03_sphere;
use super::diagram::{Diagram, Ink};
use super::rays;
use super::section::Section;
use super::way::Way as Steps;
use glam::{DVec3, dvec2};
use raybook::math::{interval::Interval, ray::Ray};
use raybook_workbook::exercises::ch15_shadows::{Lit, ShadowRay, Way};

impl Explained for ShadowRay {
    fn work(&self, steps: &mut Steps) -> Way {
        /// The way ends this share of the distance before the light.
        const BEFORE_LIGHT: f64 = 1e-4;
        let (n, error, distance) = (
            self.normal.as_dvec3(),
            f64::from(self.error),
            f64::from(self.distance),
        );
        let off = steps.number(
            "off = error · (|n.x| + |n.y| + |n.z|)",
            "m",
            error * n.abs().element_sum(),
        );
        let cosine = steps.number("n·toward", "", n.dot(self.toward.as_dvec3()));
        let side = if cosine < 0.0 { -off } else { off };
        let origin = steps.vector(
            "position ± off·n, to the light's side",
            "m",
            self.position.as_dvec3() + side * n,
        );
        let end = if distance.is_finite() {
            let margin = steps.number(
                "margin = 2 error + 10⁻⁴ distance",
                "m",
                2.0 * error + BEFORE_LIGHT * distance,
            );
            steps.number(
                "end = distance − margin, 0 at least",
                "m",
                (distance - margin).max(0.0),
            )
        } else {
            steps.remark("The light is infinitely far away: everything ahead is before it.");
            f64::INFINITY
        };
        Way {
            origin: origin.as_vec3(),
            direction: *self.toward,
            within: Interval::new(0.0, end as f32),
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
        let ray = Ray::new(shadow.origin, self.toward);
        let mut lit = 1;
        for (i, ball) in self.spheres.iter().enumerate() {
            let center: DVec3 = ball.center.as_dvec3();
            // Its own steps are those of `sphere_hit`.
            match ch03_sphere::meets(
                &mut Steps::default(),
                &ray,
                shadow.within,
                center,
                ball.radius.into(),
            ) {
                Some(t) => {
                    way.number(format!("sphere {i} is in the way, at t ="), "m", t);
                    lit = 0;
                }
                None => way.remark(format!("Sphere {i} is not in the way.")),
            }
        }
        way.number("lit", "", f64::from(lit));
        lit
    }
}
