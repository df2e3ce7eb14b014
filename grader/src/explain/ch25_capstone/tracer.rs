//! The radiance along a line, surface by surface.

use super::shapes::{Line, meets, normal};
use crate::explain::ch12_phong::parts;
use crate::explain::way::Way;
use glam::DVec3;
use raybook::material::phong::Phong;
use raybook::scene::description::{Description, Form, Matter};
use raybook_workbook::exercises::ch25_capstone::Trace;

/// A part of the way: from one point to the next, or to a lamp.
pub struct Part {
    pub ends: [DVec3; 2],
    pub is_to_lamp: bool,
}

/// A tracer that writes down what it does.
struct Tracer<'a> {
    scene: &'a Description,
    parts: Vec<Part>,
}

impl Tracer<'_> {
    fn nearest(&self, line: Line) -> Option<(usize, f64)> {
        let objects = self.scene.objects.iter().enumerate();
        let hits = objects.filter_map(|(i, object)| Some((i, meets(&object.form, line)?)));
        hits.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// The radiance along a line, with this number of surfaces still to be met.
    fn radiance(&mut self, way: &mut Way, line: Line, depth: u32) -> DVec3 {
        if depth == 0 {
            way.remark("The maximum number of surfaces in a row is reached: black.");
            return DVec3::ZERO;
        }
        let Some((object, t)) = self.nearest(line) else {
            let d = way.part("d", line.direction);
            let from_below = way.part("d.y + 1", d.y + 1.0);
            let height = way.number(
                "nothing is met: (d.y + 1)/2, from below to above",
                "",
                0.5 * from_below,
            );
            let backdrop = &self.scene.backdrop;
            let below = way.colour_part("the radiance from below", parts(backdrop.below));
            let above = way.colour_part("the radiance from above", parts(backdrop.above));
            let seen = below.lerp(above, height);
            return way.colour("the backdrop", "W·m⁻²·sr⁻¹", seen);
        };
        let thing = &self.scene.objects[object];
        let kind = match thing.form {
            Form::Sphere(_) => "sphere",
            Form::Plane(_) => "plane",
            Form::Triangle(_) => "triangle",
        };
        let t = way.number(
            format!("object {object}, a {kind}, is the nearest, at t ="),
            "m",
            t,
        );
        let p = way.vector("the point", "m", line.at(t));
        self.parts.push(Part {
            ends: [line.origin, p],
            is_to_lamp: false,
        });
        let outside = way.vector(
            "the normal, which points outside",
            "",
            normal(&thing.form, p),
        );
        let is_inside = outside.dot(line.direction) > 0.0;
        let is_turned = way.decides("the normal points away from the viewer", is_inside);
        let n = if is_turned { -outside } else { outside };
        match &thing.matter {
            Matter::Phong(phong) => self.lit(way, phong, [p, n, -line.direction]),
            Matter::Mirror(mirror) => {
                let share = way.colour_part("the mirror's share", parts(mirror.share));
                let seen = self.mirrored(way, line, [p, n], depth);
                way.colour("the mirror's share of that", "W·m⁻²·sr⁻¹", share * seen)
            }
            Matter::Glass(clear) => {
                let index = f64::from(clear.index);
                let is_leaving = way.decides("the ray comes from inside of the glass", is_inside);
                let indices = if is_leaving {
                    [index, 1.0]
                } else {
                    [1.0, index]
                };
                self.through(way, line, [p, n], indices, depth)
            }
        }
    }

    /// What a Phong surface sends to the viewer.
    fn lit(&mut self, way: &mut Way, phong: &Phong, [p, n, view]: [DVec3; 3]) -> DVec3 {
        let own = way.colour_part("k_a", parts(phong.ambient));
        let ambient = own * way.colour_part("i_a", parts(self.scene.ambient));
        let mut sum = way.colour("k_a i_a", "W·m⁻²·sr⁻¹", ambient);
        let matte = way.colour_part("k_d", parts(phong.diffuse));
        let shiny = way.colour_part("k_s", parts(phong.specular));
        let exponent = way.part("α", f64::from(phong.exponent));
        for i in way.rounds("the lamps", self.scene.lamps.len()) {
            let lamp = &self.scene.lamps[i];
            let to = lamp.position.as_dvec3() - p;
            let (distance, toward) = (to.length(), to.normalize_or(n));
            let lambert = way.number(format!("lamp {i}: L·N"), "", toward.dot(n));
            if way.is_at_most("the lamp is behind the surface", lambert, 0.0) {
                way.remark("The lamp is behind the surface.");
                continue;
            }
            let line = Line {
                origin: p,
                direction: toward,
            };
            let hides = |t: f64| t < distance * (1.0 - 1e-4);
            let objects = self.scene.objects.iter();
            let between = objects.map(|o| meets(&o.form, line).is_some_and(hides));
            let between: Vec<_> = between.collect();
            let hidden = between.iter().position(|hidden| *hidden);
            self.parts.push(Part {
                ends: [p, lamp.position.as_dvec3()],
                is_to_lamp: true,
            });
            if way.any("a thing is in the way to the lamp", &between) {
                let object = hidden.unwrap_or_default();
                way.remark(format!(
                    "Object {object} is in the way: the lamp throws no light here."
                ));
                continue;
            }
            let intensity = way.colour_part("I", parts(lamp.intensity));
            let distance = way.part("r, the distance to the lamp", distance);
            let square = way.part("r²", distance * distance);
            let arriving = way.colour("I/r²", "W/m²", intensity / square);
            let mirrored = way.part("R = 2 (L·N) N − L", 2.0 * lambert * n - toward);
            let cosine = way.number("R·V", "", mirrored.dot(view));
            let is_behind = way.is_at_most("the highlight is on the other side", cosine, 0.0);
            let cosine = if is_behind { 0.0 } else { cosine };
            let power = way.part("(R·V)^α", cosine.powf(exponent));
            let height = way.part("L·N in the diffuse part", lambert);
            let light = (matte * height + shiny * power) * arriving;
            sum += way.colour("(k_d (L·N) + k_s (R·V)^α) I/r²", "W·m⁻²·sr⁻¹", light);
        }
        way.colour("the surface's radiance, the sum", "W·m⁻²·sr⁻¹", sum)
    }

    fn mirrored(&mut self, way: &mut Way, line: Line, [p, n]: [DVec3; 2], depth: u32) -> DVec3 {
        let d = line.direction;
        let across = way.part("2 (d·n) n", 2.0 * d.dot(n) * n);
        let direction = way.vector("the mirror direction d − 2 (d·n) n", "", d - across);
        let left = way.part("the depth that is left for what is mirrored", left(depth));
        self.radiance(
            way,
            Line {
                origin: p,
                direction,
            },
            lower(depth, left),
        )
    }

    /// What is seen in a surface of glass and through it, with the indices of refraction before it and behind it.
    fn through(
        &mut self,
        way: &mut Way,
        line: Line,
        [p, n]: [DVec3; 2],
        [before, behind]: [f64; 2],
        depth: u32,
    ) -> DVec3 {
        let d = line.direction;
        let before = way.part("n₁", before);
        let behind = way.part("n₂", behind);
        let cos1 = way.number("cos θ₁", "", -d.dot(n));
        let eta = way.number("η = n₁/n₂", "", before / behind);
        let factor = way.part("η²", eta * eta);
        let sine = way.part("1 − cos²θ₁", 1.0 - cos1 * cos1);
        let squared = way.number("cos²θ₂ = 1 − η² (1 − cos²θ₁)", "", 1.0 - factor * sine);
        let is_total = way.is_at_most("the ray is totally reflected", squared, 0.0);
        let cos2 = way.part("cos θ₂", squared.max(0.0).sqrt());
        let share = if is_total {
            1.0
        } else {
            let amplitude = |a: f64, b: f64| (a - b) / (a + b);
            let s = way.part(
                "the amplitude for Rs",
                amplitude(before * cos1, behind * cos2),
            );
            let p = way.part(
                "the amplitude for Rp",
                amplitude(before * cos2, behind * cos1),
            );
            let (s, p) = (way.part("Rs", s * s), way.part("Rp", p * p));
            0.5 * way.part("Rs + Rp", s + p)
        };
        let share = way.number("R, what Fresnel's equations say is reflected", "", share);
        let mut sum = DVec3::ZERO;
        if share > 0.0 {
            way.remark("What is seen in the surface:");
            sum += share * self.mirrored(way, line, [p, n], depth);
        }
        if !is_total {
            way.remark("What is seen through the surface:");
            let across = way.part("η cos θ₁ − cos θ₂", eta * cos1 - cos2);
            let along = eta * d;
            let direction = (along + across * n).normalize_or(d);
            let direction = way.vector("the refracted direction", "", direction);
            let rest = way.part("1 − R", 1.0 - share);
            let left = way.part("the depth that is left behind the surface", left(depth));
            sum += rest
                * self.radiance(
                    way,
                    Line {
                        origin: p,
                        direction,
                    },
                    lower(depth, left),
                );
        }
        way.colour("R · the one + (1 − R) · the other", "W·m⁻²·sr⁻¹", sum)
    }
}

/// The number of surfaces that may still be met behind one.
fn left(depth: u32) -> f64 {
    f64::from(depth - 1)
}

/// The same as a depth: with a slip as well it is lower than the one before, so that the way has an end.
fn lower(depth: u32, left: f64) -> u32 {
    left.clamp(0.0, f64::from(depth - 1)) as u32
}

/// The parts of the way, and the radiance.
pub fn traced(q: &Trace, way: &mut Way) -> (Vec<Part>, DVec3) {
    let mut tracer = Tracer {
        scene: &q.scene,
        parts: Vec::new(),
    };
    let line = Line {
        origin: q.ray.origin.as_dvec3(),
        // Of length 1 in double precision too.
        direction: q.ray.direction.as_dvec3().normalize(),
    };
    let radiance = tracer.radiance(way, line, q.depth);
    (tracer.parts, radiance)
}
