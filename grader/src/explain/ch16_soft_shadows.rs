//! Chapter 16: samples of lights with an extent, and how much of a light is seen.

use super::Explained;
use super::ch03_sphere;
use super::way::Way;
use glam::{DVec2, DVec3, Vec3, dvec2};
use raybook::math::{basis::Basis, dir3::Dir3, interval::Interval, ray::Ray};
use raybook_workbook::exercises::ch16_soft_shadows::{
    Chosen, SampleRect, SampleSphereLight, VisibleFraction,
};
use std::f64::consts::TAU;

/// The middles of the cells of an n × n lattice of the unit square, with i running fastest.
fn lattice(n: u32) -> impl Iterator<Item = DVec2> {
    (0..n * n).map(move |k| (dvec2(f64::from(k % n), f64::from(k / n)) + 0.5) / f64::from(n))
}

fn chosen(way: &mut Way, toward: DVec3, distance: f64, radiance: f32, pdf: f64) -> Chosen {
    let radiance = way.part("radiance", f64::from(radiance));
    let arriving = way.number("radiance/density", "W/m²", radiance / pdf);
    let pdf = way.part("the density, returned", pdf);
    Chosen {
        toward: toward.as_vec3(),
        distance: distance as f32,
        pdf: pdf as f32,
        arriving: arriving as f32,
    }
}

impl Explained for SampleRect {
    fn work(&self, way: &mut Way) -> Option<Vec<Chosen>> {
        let [at, corner, a, b] = [self.at, self.corner, self.a, self.b].map(Vec3::as_dvec3);
        let normal = way.vector(
            "the light's normal, a × b of length 1",
            "",
            a.cross(b).normalize_or(DVec3::Y),
        );
        let at = way.part("at", at);
        let corner = way.part("corner", corner);
        let length = way.part("|a|", a.length());
        let area = way.number("its area", "m²", length * b.length());
        way.remark("The first sample; the others go the same way:");
        let samples = way.of_first(lattice(self.n), |way, u| {
            let u = way.pair("u", "", u);
            let side_a = way.part("a, along which u.x goes", a);
            let side_b = way.part("b, along which u.y goes", b);
            let along_a = way.part("u.x·a", u.x * side_a);
            let along_b = way.part("u.y·b", u.y * side_b);
            let r = corner + along_a + along_b - at;
            let r = way.vector("r = corner + u.x·a + u.y·b − at", "m", r);
            let long = way.part("r, whose length is |r|", r);
            let distance = way.part("|r|", long.length());
            let products = way.part("the products that r·normal adds up", r * normal);
            let cosine = way.number(
                "the cosine at the light, −r·normal/|r|",
                "",
                -products.element_sum() / distance,
            );
            if way.is_at_most("the light turns its back to the point", cosine, 0.0) {
                way.remark("It is not positive: the light turns its back to the point.");
                return None;
            }
            let square = way.part("|r|²", distance * distance);
            let seen = way.part("area · cosine, what is seen of the light", area * cosine);
            let pdf = way.number(
                "the density per steradian, |r|²/(area · cosine)",
                "1/sr",
                square / seen,
            );
            let toward = way.part("r/|r|", r / distance);
            Some(chosen(way, toward, distance, self.radiance, pdf))
        });
        samples.into_iter().collect()
    }
}

impl Explained for SampleSphereLight {
    fn work(&self, way: &mut Way) -> Vec<Chosen> {
        let (c, r) = (
            self.center.as_dvec3() - self.at.as_dvec3(),
            f64::from(self.radius),
        );
        let r = way.part("r", r);
        let d = way.number("d, the distance to the centre", "m", c.length());
        let inside = way.is_at_most("the point is inside of the light", d, r);
        let height = if inside {
            way.remark("The point is inside of the light, which is seen in every direction.");
            2.0
        } else {
            let squared = way.number("sin² of the cone's half angle, (r/d)²", "", (r / d).powi(2));
            squared / (1.0 + (1.0 - squared).sqrt())
        };
        let height = way.number("h = 1 − the cosine of that angle", "", height);
        let pdf = way.number(
            "the density per steradian, 1/(2π h)",
            "1/sr",
            1.0 / (TAU * height),
        );
        way.remark("The first sample; the others go the same way:");
        let around = Basis::around(Dir3::new_or(c.as_vec3(), Dir3::Y));
        let [x_axis, y_axis, axis] = [around.x, around.y, around.z].map(|v| v.as_dvec3());
        way.of_first(lattice(self.n), |way, u| {
            let u = way.pair("u", "", u);
            let x = way.part("u.x·h", u.x * height);
            let cosine = way.number("cos θ = 1 − u.x·h", "", 1.0 - x);
            let sine = way.part("sin θ", (x * (2.0 - x)).max(0.0).sqrt());
            let phi = way.part("φ = 2π u.y", TAU * u.y);
            let (sin_phi, cos_phi) = phi.sin_cos();
            let x_axis = way.part("the axis along which cos φ goes", x_axis);
            let y_axis = way.part("the axis along which sin φ goes", y_axis);
            let axis = way.part("the axis to the light", axis);
            let toward = sine * cos_phi * x_axis + sine * sin_phi * y_axis + cosine * axis;
            let toward = way.vector(
                "the direction, θ from the axis and turned by 2π u.y around it",
                "",
                toward,
            );
            let half_chord = way.number(
                "half the chord, √(r² − d² sin²θ)",
                "m",
                (r * r - d * d * sine * sine).max(0.0).sqrt(),
            );
            let middle = way.part("d cos θ", d * cosine);
            let ahead = way.decides("the far side of the sphere is seen, from inside", inside);
            let distance = middle + if ahead { half_chord } else { -half_chord };
            let distance = way.number("the distance, d cos θ ∓ half the chord", "m", distance);
            chosen(way, toward, distance, self.radiance, pdf)
        })
    }
}

impl Explained for VisibleFraction {
    fn work(&self, way: &mut Way) -> Vec<f32> {
        /// Points of the light along each side: an even lattice is nearer to the truth than as many random points.
        const SIDE: u32 = 32;
        let [corner, a, b] = [self.corner, self.a, self.b].map(Vec3::as_dvec3);
        let normal = a.cross(b);
        way.remark(format!(
            "In place of random samples, a lattice of {SIDE} × {SIDE} points of the light:"
        ));
        let mut fractions = Vec::new();
        for (i, point) in self.points.iter().enumerate() {
            let mut is_seen = |u: DVec2| {
                let to = corner + u.x * a + u.y * b - point.as_dvec3();
                let Some(direction) = Dir3::new(to.as_vec3()) else {
                    return false;
                };
                let (ray, before) = (
                    Ray::new(*point, direction),
                    Interval::new(0.0, to.length() as f32),
                );
                let mut blocks = |center: DVec3, radius: f32| {
                    way.silently(|way| ch03_sphere::meets(way, &ray, before, center, radius.into()))
                        .is_some()
                };
                to.dot(normal) < 0.0
                    && !self
                        .balls
                        .iter()
                        .any(|ball| blocks(ball.center.as_dvec3(), ball.radius))
            };
            let seen = lattice(SIDE).filter(|u| is_seen(*u)).count();
            let seen = way.number(
                format!("point {i}: the number of points of the light that are seen"),
                "",
                seen as f64,
            );
            let fraction = seen / f64::from(SIDE * SIDE);
            fractions.push(way.number(format!("point {i}: their fraction"), "", fraction) as f32);
        }
        fractions
    }
}
