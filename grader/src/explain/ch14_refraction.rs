//! Chapter 14: Snell's law in the plane of the ray and the normal, and Fresnel's equations.

use super::Explained;
use super::ch13_reflection;
use super::diagram::Diagram;
use super::way::Way;
use glam::Vec3;
use raybook_workbook::exercises::ch14_refraction::{Fresnel, FresnelAnswer, Refract};

impl Explained for Refract {
    fn work(&self, way: &mut Way) -> Option<Vec3> {
        let (i, normal) = (self.direction.as_dvec3(), self.normal.as_dvec3());
        let cosine = way.number("i·normal", "", i.dot(normal));
        let [outside, inside] = [self.outside, self.inside].map(f64::from);
        let (n, eta) = if cosine < 0.0 {
            way.remark("It is negative: the ray comes from the outside, and n is the normal.");
            (normal, outside / inside)
        } else {
            way.remark(
                "It is not negative: the ray comes from the inside, and n is minus the normal.",
            );
            (-normal, inside / outside)
        };
        way.number("cos θ₁ = −i·n", "", -i.dot(n));
        let eta = way.number("η = n₁/n₂, the index before over the index behind", "", eta);
        let along = way.vector(
            "s = η (i − (i·n) n), the part along the surface",
            "",
            eta * (i - i.dot(n) * n),
        );
        let squared = way.number("cos²θ₂ = 1 − s·s", "", 1.0 - along.length_squared());
        if squared < 0.0 {
            way.remark("It is negative: there is no such angle, the ray is totally reflected.");
            return None;
        }
        let cos2 = way.number("cos θ₂", "", squared.sqrt());
        Some(
            way.vector("s − cos θ₂ n", "", (along - cos2 * n).normalize())
                .as_vec3(),
        )
    }

    fn draw(&self, right: &Option<Vec3>, yours: Option<&Option<Vec3>>) -> Option<Diagram> {
        let total = if right.is_none() {
            "; it is totally reflected: nothing goes on behind"
        } else {
            ""
        };
        let mut drawing = Diagram::new(format!(
            "The surface from its side, in the plane of the ray and the normal{total}"
        ));
        let sides = [
            format!("outside, index {}", self.outside),
            format!("inside, index {}", self.inside),
        ];
        let answers = [*right, yours.copied().flatten()];
        ch13_reflection::surface(
            &mut drawing,
            self.direction.as_dvec3(),
            self.normal.as_dvec3(),
            [&sides[0], &sides[1]],
            answers,
        );
        Some(drawing)
    }
}

impl Explained for Fresnel {
    fn work(&self, way: &mut Way) -> FresnelAnswer {
        let [cos1, n1, n2] = [self.cos1, self.n1, self.n2].map(f64::from);
        let both = |rs: f64, rp: f64| FresnelAnswer {
            rs: rs as f32,
            rp: rp as f32,
            r: (0.5 * (rs + rp)) as f32,
        };
        if self.n1 == self.n2 {
            way.remark("n₁ is n₂: there is no surface for the light, and nothing is reflected.");
            return both(0.0, 0.0);
        }
        let sin2 = way.number(
            "sin²θ₂ = (n₁/n₂)² (1 − cos²θ₁)",
            "",
            (n1 / n2).powi(2) * (1.0 - cos1 * cos1),
        );
        let squared = way.number("cos²θ₂ = 1 − sin²θ₂", "", 1.0 - sin2);
        if squared <= 0.0 {
            way.remark("It is not positive: all light is reflected.");
            return both(1.0, 1.0);
        }
        let cos2 = way.number("cos θ₂", "", squared.sqrt());
        let share = |a: f64, b: f64| ((a - b) / (a + b)).powi(2);
        let rs = way.number(
            "Rs = ((n₁ cos θ₁ − n₂ cos θ₂)/(n₁ cos θ₁ + n₂ cos θ₂))²",
            "",
            share(n1 * cos1, n2 * cos2),
        );
        let rp = way.number(
            "Rp = ((n₁ cos θ₂ − n₂ cos θ₁)/(n₁ cos θ₂ + n₂ cos θ₁))²",
            "",
            share(n1 * cos2, n2 * cos1),
        );
        way.number("R = (Rs + Rp)/2", "", 0.5 * (rs + rp));
        both(rs, rp)
    }
}
