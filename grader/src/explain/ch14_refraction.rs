//! Chapter 14: Snell's law in the plane of the ray and the normal, and Fresnel's equations.

use super::Explained;
use super::ch13_reflection;
use super::diagram::Diagram;
use super::way::Way;
use glam::Vec3;
use raybook_workbook::exercises::ch14_refraction::{Fresnel, FresnelAnswer, Refract};

/// The ratio of the indices before the surface and behind it.
fn ratio(way: &mut Way, [before, behind]: [f64; 2]) -> f64 {
    let before = way.part("n₁, before the surface", before);
    let behind = way.part("n₂, behind the surface", behind);
    before / behind
}

/// The same by one formula: η i + (η cos θ₁ − cos θ₂) n.
fn by_the_formula(asked: &Refract, way: &mut Way) -> Option<Vec3> {
    let i = way.part("i", asked.direction.as_dvec3());
    let normal = way.part("the normal", asked.normal.as_dvec3());
    let outside = way.part("outside", f64::from(asked.outside));
    let inside = way.part("inside", f64::from(asked.inside));
    let products = way.part("the products that i·normal adds up", i * normal);
    let cosine = way.part("i·normal", products.element_sum());
    let cos1 = way.part("−i·normal", -cosine);
    let is_below = way.is_at_most("cos θ₁ would be negative", 0.0, cosine);
    let cos1 = way.part("cos θ₁", if is_below { -cos1 } else { cos1 });
    let indices = if way.is_at_most("the indices are exchanged, for the ray leaves", 0.0, cosine) {
        [inside, outside]
    } else {
        [outside, inside]
    };
    let eta = ratio(way, indices);
    let eta = way.part("η = n₁/n₂", eta);
    let is_turned = way.is_at_most("the normal is turned, for the ray leaves", 0.0, cosine);
    let n = way.part(
        "n, which is added in the end",
        if is_turned { -normal } else { normal },
    );
    let factor = way.part("η²", eta * eta);
    let square = way.part("cos²θ₁", cos1 * cos1);
    let sine = way.part("1 − cos²θ₁", 1.0 - square);
    let squared = way.part("cos²θ₂ = 1 − η² (1 − cos²θ₁)", 1.0 - factor * sine);
    if way.is_less("cos²θ₂ is negative", squared, 0.0) {
        return None;
    }
    let cos2 = way.part("cos θ₂", squared.sqrt());
    let product = way.part("η cos θ₁", eta * cos1);
    let across = way.part("η cos θ₁ − cos θ₂", product - cos2);
    let along = way.part("η i", eta * i);
    let refracted = way.part("η i + (η cos θ₁ − cos θ₂) n", along + across * n);
    Some(refracted.as_vec3())
}

/// The same by the sine along the surface and the cosine across it.
fn by_angles(asked: &Refract, way: &mut Way) -> Option<Vec3> {
    let i = way.part("i", asked.direction.as_dvec3());
    let normal = way.part("the normal", asked.normal.as_dvec3());
    let outside = way.part("outside", f64::from(asked.outside));
    let inside = way.part("inside", f64::from(asked.inside));
    let cosine = way.part("i·normal", i.dot(normal));
    let n = if way.is_at_most("the normal is turned, for the ray leaves", 0.0, cosine) {
        -normal
    } else {
        normal
    };
    let indices = if way.is_at_most("the indices are exchanged, for the ray leaves", 0.0, cosine) {
        [inside, outside]
    } else {
        [outside, inside]
    };
    let eta = ratio(way, indices);
    let eta = way.part("n₁/n₂", eta);
    let across = way.part("(i·n) n, the part across the surface", i.dot(n) * n);
    let along = way.part("the part along the surface", i - across);
    let long = way.part("the part along the surface, whose length is sin θ₁", along);
    let sin1 = way.part("sin θ₁, its length", long.length());
    let sin2 = way.part("sin θ₂ = n₁/n₂ sin θ₁", eta * sin1);
    if way.is_less("sin θ₂ is greater than 1", 1.0, sin2) {
        return None;
    }
    let forward = along.try_normalize().unwrap_or(along);
    let forward = way.part("the direction along the surface, of length 1", forward);
    let square = way.part("sin²θ₂", sin2 * sin2);
    let cos2 = way.part("cos θ₂", (1.0 - square).sqrt());
    let refracted = way.part("sin θ₂ times it − cos θ₂ n", sin2 * forward - cos2 * n);
    Some(refracted.as_vec3())
}

impl Explained for Refract {
    const WAYS: &'static [fn(&Self, &mut Way) -> Option<Vec3>] =
        &[Self::work, by_the_formula, by_angles];

    fn work(&self, way: &mut Way) -> Option<Vec3> {
        let (i, normal) = (self.direction.as_dvec3(), self.normal.as_dvec3());
        let i = way.part("i", i);
        let normal = way.part("the normal", normal);
        let products = way.part("the products that i·normal adds up", i * normal);
        let cosine = way.number("i·normal", "", products.element_sum());
        let outside = way.part("outside", f64::from(self.outside));
        let inside = way.part("inside", f64::from(self.inside));
        let (n, indices) = if way.is_less("the ray comes from the outside", cosine, 0.0) {
            way.remark("It is negative: the ray comes from the outside, and n is the normal.");
            (normal, [outside, inside])
        } else {
            way.remark(
                "It is not negative: the ray comes from the inside, and n is minus the normal.",
            );
            (-normal, [inside, outside])
        };
        let n = way.part("n", n);
        let cos1 = way.number("cos θ₁ = −i·n", "", -i.dot(n));
        let eta = ratio(way, indices);
        let eta = way.number("η = n₁/n₂, the index before over the index behind", "", eta);
        let along = way.vector(
            "s = η (i − (i·n) n), the part along the surface",
            "",
            eta * (i + cos1 * n),
        );
        let sin2 = way.part("sin²θ₂ = s·s", along.length_squared());
        let squared = way.number("cos²θ₂ = 1 − s·s", "", 1.0 - sin2);
        if way.is_less("cos²θ₂ is negative", squared, 0.0) {
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

/// The same by n = n₂/n₁ and g = n cos θ₂, whose square is n² − 1 + cos²θ₁.
fn by_one_ratio(asked: &Fresnel, way: &mut Way) -> FresnelAnswer {
    let c = way.part("cos θ₁", f64::from(asked.cos1));
    let n = way.part("n = n₂/n₁", f64::from(asked.n2) / f64::from(asked.n1));
    let under_root = way.part("n² in g²", n * n);
    let square = way.part("cos²θ₁", c * c);
    let squared = way.part("g² = n² − 1 + cos²θ₁", under_root - 1.0 + square);
    if way.is_at_most("g² is not positive", squared, 0.0) {
        return FresnelAnswer {
            rs: 1.0,
            rp: 1.0,
            r: 1.0,
        };
    }
    let g = way.part("g", squared.sqrt());
    let over = way.part("cos θ₁ − g", c - g);
    let under = way.part("cos θ₁ + g", c + g);
    let rs = way.part("the root of Rs", over / under);
    let rs = way.part("Rs", rs * rs);
    let factor = way.part("n² in Rp", n * n);
    let inside = way.part("n² cos θ₁", factor * c);
    let over = way.part("n² cos θ₁ − g", inside - g);
    let under = way.part("n² cos θ₁ + g", inside + g);
    let rp = way.part("the root of Rp", over / under);
    let rp = way.part("Rp", rp * rp);
    let sum = way.part("Rs + Rp", rs + rp);
    let r = way.part("R = (Rs + Rp)/2", 0.5 * sum);
    let [rs, rp, r] = [rs, rp, r].map(|v| v as f32);
    FresnelAnswer { rs, rp, r }
}

impl Explained for Fresnel {
    const WAYS: &'static [fn(&Self, &mut Way) -> FresnelAnswer] = &[Self::work, by_one_ratio];

    fn work(&self, way: &mut Way) -> FresnelAnswer {
        let cos1 = way.part("cos θ₁", f64::from(self.cos1));
        let n1 = way.part("n₁", f64::from(self.n1));
        let n2 = way.part("n₂", f64::from(self.n2));
        let both = |rs: f64, rp: f64| FresnelAnswer {
            rs: rs as f32,
            rp: rp as f32,
            r: (0.5 * (rs + rp)) as f32,
        };
        if way.is_zero("n₁ is n₂", n1 - n2) {
            way.remark("n₁ is n₂: there is no surface for the light, and nothing is reflected.");
            return both(0.0, 0.0);
        }
        let square = way.part("cos²θ₁", cos1 * cos1);
        let sin1 = way.part("sin²θ₁ = 1 − cos²θ₁", 1.0 - square);
        let eta = way.part("n₁/n₂", n1 / n2);
        let eta = way.part("(n₁/n₂)²", eta * eta);
        let sin2 = way.number("sin²θ₂ = (n₁/n₂)² (1 − cos²θ₁)", "", eta * sin1);
        let squared = way.number("cos²θ₂ = 1 − sin²θ₂", "", 1.0 - sin2);
        if way.is_at_most("cos²θ₂ is not positive", squared, 0.0) {
            way.remark("It is not positive: all light is reflected.");
            return both(1.0, 1.0);
        }
        let cos2 = way.number("cos θ₂", "", squared.sqrt());
        let first = way.part("n₁ cos θ₁ above the line", n1 * cos1);
        let second = way.part("n₂ cos θ₂ above the line", n2 * cos2);
        let over = way.part("n₁ cos θ₁ − n₂ cos θ₂", first - second);
        let first = way.part("n₁ cos θ₁ below the line", n1 * cos1);
        let second = way.part("n₂ cos θ₂ below the line", n2 * cos2);
        let under = way.part("n₁ cos θ₁ + n₂ cos θ₂", first + second);
        let rs = way.part("the root of Rs", over / under);
        let rs = way.number(
            "Rs = ((n₁ cos θ₁ − n₂ cos θ₂)/(n₁ cos θ₁ + n₂ cos θ₂))²",
            "",
            rs * rs,
        );
        let first = way.part("n₁ cos θ₂ above the line", n1 * cos2);
        let second = way.part("n₂ cos θ₁ above the line", n2 * cos1);
        let over = way.part("n₁ cos θ₂ − n₂ cos θ₁", first - second);
        let first = way.part("n₁ cos θ₂ below the line", n1 * cos2);
        let second = way.part("n₂ cos θ₁ below the line", n2 * cos1);
        let under = way.part("n₁ cos θ₂ + n₂ cos θ₁", first + second);
        let rp = way.part("the root of Rp", over / under);
        let rp = way.number(
            "Rp = ((n₁ cos θ₂ − n₂ cos θ₁)/(n₁ cos θ₂ + n₂ cos θ₁))²",
            "",
            rp * rp,
        );
        let sum = way.part("Rs + Rp", rs + rp);
        let mean = way.number("R = (Rs + Rp)/2", "", 0.5 * sum);
        let [rs, rp, r] = [
            way.part("Rs, returned", rs),
            way.part("Rp, returned", rp),
            way.part("R, returned", mean),
        ]
        .map(|v| v as f32);
        FresnelAnswer { rs, rp, r }
    }
}
