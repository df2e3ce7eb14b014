//! Chapter 21: a step around a black hole, and the angle by which it turns a ray, in the plane of the ray.

use super::Explained;
use super::diagram::{Diagram, Ink};
use super::rays;
use super::section::Section;
use super::way::Way;
use glam::{DVec2, DVec3, dvec2};
use raybook::render::curved::{CRITICAL, PHOTON_SPHERE, Photon};
use raybook_workbook::exercises::ch21_black_hole::{
    DeflectionAngle, GeodesicStep, GeodesicStepAnswer,
};
use std::f64::consts::PI;

/// How position and velocity change: dx/dλ = v, dv/dλ = −(3/2) h² x/|x|⁵.
fn slope(p: Photon) -> Photon {
    let h = p.angular_momentum();
    Photon {
        x: p.v,
        v: -1.5 * h * h / p.x.length().powi(5) * p.x,
    }
}

/// A step by four slopes, exact to the fourth order (Runge and Kutta).
fn stepped(p: Photon, step: f64) -> Photon {
    let k1 = slope(p);
    let k2 = slope(p + k1 * (0.5 * step));
    let k3 = slope(p + k2 * (0.5 * step));
    let k4 = slope(p + k3 * step);
    p + (k1 + k2 * 2.0 + k3 * 2.0 + k4) * (step / 6.0)
}

/// How the velocity changes at a place, by its steps.
fn pull_by_steps(way: &mut Way, p: Photon) -> DVec3 {
    let across = way.part("x, in x × v", p.x);
    let along = way.part("v, in x × v", p.v);
    let moment = way.part("x × v", across.cross(along));
    let squares = way.part("the squares that h² adds up", moment * moment);
    let h = way.part("h = |x × v|", squares.element_sum().sqrt());
    let square = way.part("h²", h * h);
    let long = way.part("x, whose length is |x|", p.x);
    let r = way.part("|x|", long.length());
    let power = way.part("|x|⁵", r.powi(5));
    let factor = way.part("−3/2", -1.5);
    let toward = way.part("x, along which it pulls", p.x);
    factor * square / power * toward
}

/// The slope at a place, by its steps; `told` writes the change of the velocity down.
fn slope_by_steps(way: &mut Way, p: Photon, told: fn(&mut Way, DVec3) -> DVec3) -> Photon {
    let x = way.part("dx/dλ = v", p.v);
    let bend = pull_by_steps(way, p);
    Photon {
        x,
        v: told(way, bend),
    }
}

/// Draws the hole, the photon sphere and their names.
fn hole(drawing: &mut Diagram) {
    drawing.circle(DVec2::ZERO, 1.0, Ink::Shape);
    drawing.label(DVec2::ZERO, DVec2::ZERO, "the hole", Ink::Shape);
    drawing.circle(DVec2::ZERO, PHOTON_SPHERE, Ink::Guide);
}

/// The same by halves of a step (Verlet): the velocity turns for half of it, moves the photon, and turns for the other half.
fn by_halves(asked: &GeodesicStep, way: &mut Way) -> GeodesicStepAnswer {
    let start = Photon {
        x: asked.position.as_dvec3(),
        v: asked.velocity.as_dvec3(),
    };
    let step = way.part("step", f64::from(asked.step));
    let first = pull_by_steps(way, start);
    let first = way.part("dv/dλ at the start", first);
    let turns = way.part("the step, in which the velocity turns", step);
    let half = way.part("the first half of the step", 0.5 * turns);
    let turned = way.part("v in the middle of the step", start.v + half * first);
    let moved = way.part("the step, in which the photon moves", step);
    let x = way.part("x after the step", start.x + moved * turned);
    let there = Photon { x, v: turned };
    let last = pull_by_steps(way, there);
    let last = way.part("dv/dλ at the end", last);
    let half = way.part("the second half of the step", 0.5 * turns);
    let v = way.part("v after the step", turned + half * last);
    GeodesicStepAnswer {
        position: x.as_vec3(),
        velocity: v.as_vec3(),
    }
}

impl Explained for GeodesicStep {
    const WAYS: &'static [fn(&Self, &mut Way) -> GeodesicStepAnswer] = &[Self::work, by_halves];

    fn work(&self, way: &mut Way) -> GeodesicStepAnswer {
        let start = Photon {
            x: self.position.as_dvec3(),
            v: self.velocity.as_dvec3(),
        };
        way.number(
            "h = |x × v|, which does not change",
            "",
            start.angular_momentum(),
        );
        way.number("|x|", "", start.x.length());
        let step = way.part("step", f64::from(self.step));
        let k1 = slope_by_steps(way, start, |way, v| {
            way.vector("k₁ = dv/dλ at the start", "", v)
        });
        let to_k2 = way.part("half a step, to k₂", 0.5 * step);
        let k2 = slope_by_steps(way, start + k1 * to_k2, |way, v| {
            way.vector("k₂ = dv/dλ half a step along k₁", "", v)
        });
        let to_k3 = way.part("half a step, to k₃", 0.5 * step);
        let k3 = slope_by_steps(way, start + k2 * to_k3, |way, v| {
            way.vector("k₃ = dv/dλ half a step along k₂", "", v)
        });
        let to_k4 = way.part("the whole step, to k₄", step);
        let k4 = slope_by_steps(way, start + k3 * to_k4, |way, v| {
            way.vector("k₄ = dv/dλ a step along k₃", "", v)
        });
        let twice = way.part("the weight 2 of k₂ and k₃", 2.0);
        let share = way.part("step/6", step / 6.0);
        let after = start + (k1 + k2 * twice + k3 * twice + k4) * share;
        let straight = start.x + f64::from(self.step) * start.v;
        way.vector("x + step·v, straight on", "", straight);
        way.remark(
            "Position and velocity change by step · (k₁ + 2k₂ + 2k₃ + k₄)/6, with the k of each:",
        );
        GeodesicStepAnswer {
            position: way.vector("x after the step", "", after.x).as_vec3(),
            velocity: way.vector("v after the step", "", after.v).as_vec3(),
        }
    }

    fn draw(
        &self,
        right: &GeodesicStepAnswer,
        yours: Option<&GeodesicStepAnswer>,
    ) -> Option<Diagram> {
        let (x, v) = (self.position.as_dvec3(), self.velocity.as_dvec3());
        let mut section = Section::spanned(x, v, x);
        // The straight step is the unit of lengths in the drawing.
        let size = rays::nonzero((f64::from(self.step) * v).length());
        section.origin = x;
        let mut drawing = Diagram::new(
            "The step, in the plane of the photon and the hole, which is below: dashed straight on; the arrows are the velocities",
        );
        let at = |p: DVec3| section.at(p);
        let straight = x + f64::from(self.step) * v;
        drawing.point(at(x), Ink::Ray);
        drawing.label(at(x), dvec2(-0.8, 0.5), "x", Ink::Ray);
        drawing.line(&[at(x), at(straight)], Ink::Guide);
        let toward = -section.along(x).normalize_or_zero();
        drawing.arrow(at(x), at(x) + 0.4 * size * toward, Ink::Shape);
        drawing.label(
            at(x) + 0.4 * size * toward,
            toward,
            "to the hole",
            Ink::Shape,
        );
        let speed = rays::nonzero(v.length());
        for (answer, ink, beside, name) in rays::answers(Some(right), yours) {
            let (p, v) = (at(answer.position.as_dvec3()), answer.velocity.as_dvec3());
            let is_near = p.length() <= 4.0 * size;
            let p = p.clamp_length_max(4.0 * size);
            let beyond = if is_near {
                ""
            } else {
                ", outside of the picture"
            };
            if is_near {
                drawing.point(p, ink);
                let arrow = 0.5 * size / speed * section.along(v);
                drawing.arrow(p, p + arrow.clamp_length_max(2.0 * size), ink);
            }
            drawing.label(p, beside, format!("{name}{beyond}"), ink);
        }
        Some(drawing)
    }
}

/// The same by steps along the ray: u = 1/r as a function of the angle φ obeys u″ = (3/2) u² − u (Runge and Kutta's method).
fn by_the_orbit(asked: &DeflectionAngle, way: &mut Way) -> Option<f32> {
    /// Radians. With a fourth of it no angle that is asked for changes by a part in a hundred thousand.
    const STEP: f64 = 0.02;
    /// Radians, after which a ray circles for ever.
    const MOST: f64 = 40.0;
    let b = way.part("b", f64::from(asked.impact_parameter));
    let factor = way.part("3/2 before u²", 1.5);
    let power = way.part("2, the power of u", 2.0);
    let linear = way.part("1, the factor of u", 1.0);
    let first = way.part("u at the beginning, 0", 0.0);
    let slope = way.part("u′ at the beginning, 1/b", b.recip());
    let horizon = way.part("u at the hole, 1", 1.0);
    let less = way.part("π, which is subtracted", PI);
    let bend = |u: f64| factor * u.powf(power) - linear * u;
    let mut at = dvec2(first, slope);
    let change = |p: DVec2| dvec2(p.y, bend(p.x));
    let mut angle = 0.0;
    while at.x < horizon && angle < MOST {
        let k1 = change(at);
        let k2 = change(at + 0.5 * STEP * k1);
        let k3 = change(at + 0.5 * STEP * k2);
        let k4 = change(at + STEP * k3);
        let next = at + STEP / 6.0 * (k1 + 2.0 * (k2 + k3) + k4);
        if next.x < 0.0 {
            // Far away the ray is straight: u falls evenly.
            return Some((angle - at.x / at.y - less) as f32);
        }
        (at, angle) = (next, angle + STEP);
    }
    None
}

impl Explained for DeflectionAngle {
    const WAYS: &'static [fn(&Self, &mut Way) -> Option<f32>] = &[Self::work, by_the_orbit];

    fn work(&self, way: &mut Way) -> Option<f32> {
        /// Even. Next to b_c the integrand has a peak as narrow as the distance to b_c.
        const INTERVALS: u32 = 4000;
        let b = way.part("b", f64::from(self.impact_parameter));
        let critical = way.number("b_c = 3√3/2", "", CRITICAL);
        if way.is_at_most("b is not above b_c", b, critical) {
            way.remark("b is not above b_c: the ray falls in.");
            return None;
        }
        way.remark(
            "With u = 1/r the ray obeys (du/dφ)² = 1/b² − u² + u³. It turns where that is 0.",
        );
        let turns = 2.0 * b / 3.0_f64.sqrt() * ((-critical / b).acos() / 3.0).cos();
        let turns = way.number(
            "r₀ = (2b/√3) cos(⅓ arccos(−b_c/b)), where it turns",
            "",
            turns,
        );
        let u0 = way.number("u₀ = 1/r₀", "", 1.0 / turns);
        // u = u₀ (1 − s²) takes the root out of the integrand.
        let integrand = |s: f64| {
            let u = u0 * (1.0 - s * s);
            2.0 * (u0 / (u0 * (1.0 - u0) + (1.0 - u0) * u - u * u)).sqrt()
        };
        let width = 1.0 / f64::from(INTERVALS);
        let simpson = |i: u32| {
            let weight = [2.0, 4.0][(i % 2) as usize];
            let weight = if i == 0 || i == INTERVALS {
                1.0
            } else {
                weight
            };
            weight * integrand(f64::from(i) * width)
        };
        let swept = (0..=INTERVALS).map(simpson).sum::<f64>() * width / 3.0;
        let swept = way.number(
            "∫ du/√(1/b² − u² + u³) from 0 to u₀: half of the angle that it sweeps",
            "rad",
            swept,
        );
        let whole = way.part("twice that", 2.0 * swept);
        Some(way.number("twice that, less π", "rad", whole - PI) as f32)
    }

    fn draw(&self, _: &Option<f32>, yours: Option<&Option<f32>>) -> Option<Diagram> {
        /// Where the ray begins and ends, in radii of the hole: the bend before it is hardly to be seen.
        const FAR: f64 = 12.0;
        let b = f64::from(self.impact_parameter);
        let mut drawing = Diagram::new(
            "The ray around the hole: dashed as it would go on straight; the dashed circle is where light can circle",
        );
        hole(&mut drawing);
        if b > FAR {
            drawing.title = format!(
                "The ray passes {} radii from the hole: too far for its bend to be seen in a drawing",
                self.impact_parameter
            );
        }
        let from = FAR.max(2.0 * b);
        let mut photon = Photon {
            x: DVec3::new(-from, b, 0.0),
            v: DVec3::X,
        };
        let seen = |p: Photon| dvec2(p.x.x, p.x.y);
        let mut points = vec![seen(photon)];
        // A step is a part of the distance from the hole: as fine as the curve is.
        for _ in 0..4000 {
            let r = photon.x.length();
            if r < 1.0 || r > 1.2 * from {
                break;
            }
            photon = stepped(photon, 0.03 * r / photon.v.length());
            points.push(seen(photon));
        }
        drawing.line(&[dvec2(-from, b), dvec2(0.7 * from, b)], Ink::Guide);
        drawing.line(&points, Ink::Right);
        drawing.label(
            dvec2(-from, b),
            dvec2(0.6, 1.0),
            format!("b = {}", self.impact_parameter),
            Ink::Ray,
        );
        drawing.arrow(dvec2(-from, b), dvec2(-0.9 * from, b), Ink::Ray);
        if let Some(Some(angle)) = yours {
            let (sin, cos) = f64::from(-angle).sin_cos();
            let middle = dvec2(0.0, b.min(from));
            let tip = middle + 0.6 * from * dvec2(cos, sin);
            drawing.arrow(middle, tip, Ink::Yours);
            drawing.label(
                tip,
                dvec2(0.0, -1.0),
                format!("yours: turned by {angle} rad"),
                Ink::Yours,
            );
        }
        Some(drawing)
    }
}
