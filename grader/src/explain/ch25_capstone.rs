//! Chapter 25: a ray through a whole scene, surface by surface, and its way in a drawing.

use super::Explained;
use super::ch12_phong::{colour, parts};
use super::diagram::{Diagram, Ink};
use super::view::View;
use super::way::Way;
use glam::{DVec3, Vec3, dvec2};
use raybook::image::rgb::Rgb;
use raybook::material::phong::Phong;
use raybook::scene::description::{Description, Form, Matter};
use raybook_workbook::exercises::ch25_capstone::Trace;

/// Nearer than this a ray does not meet anything: it has just left there.
const LEAVES: f64 = 1e-5;

/// A line that light takes to the eye, backwards.
#[derive(Clone, Copy)]
struct Line {
    origin: DVec3,
    direction: DVec3,
}

impl Line {
    fn at(&self, t: f64) -> DVec3 {
        self.origin + t * self.direction
    }
}

/// The distance at which a line meets a shape ahead, if it does.
fn meets(form: &Form, line: Line) -> Option<f64> {
    let Line {
        origin: o,
        direction: d,
    } = line;
    let ahead = |t: f64| (t > LEAVES && t.is_finite()).then_some(t);
    match form {
        Form::Sphere(sphere) => {
            let m = o - sphere.center.as_dvec3();
            let (half, radius) = (m.dot(d), f64::from(sphere.radius));
            let root = (half * half - m.length_squared() + radius * radius).sqrt();
            // Of a line that misses the root is NaN, which is never ahead.
            ahead(-half - root).or_else(|| ahead(-half + root))
        }
        Form::Plane(plane) => {
            let n = plane.normal.as_dvec3();
            ahead((f64::from(plane.offset) - n.dot(o)) / n.dot(d))
        }
        Form::Triangle(corners) => {
            let [p0, p1, p2] = [corners.p0, corners.p1, corners.p2].map(Vec3::as_dvec3);
            let n = (p1 - p0).cross(p2 - p0);
            let t = ahead((p0 - o).dot(n) / d.dot(n))?;
            let p = line.at(t);
            let inside = |a: DVec3, b: DVec3| (b - a).cross(p - a).dot(n) >= 0.0;
            (inside(p0, p1) && inside(p1, p2) && inside(p2, p0)).then_some(t)
        }
    }
}

/// The normal of a shape at a point, which points outside.
fn normal(form: &Form, p: DVec3) -> DVec3 {
    match form {
        Form::Sphere(sphere) => (p - sphere.center.as_dvec3()).normalize_or(DVec3::Y),
        Form::Plane(plane) => plane.normal.as_dvec3(),
        Form::Triangle(corners) => {
            let [p0, p1, p2] = [corners.p0, corners.p1, corners.p2].map(Vec3::as_dvec3);
            (p1 - p0).cross(p2 - p0).normalize_or(DVec3::Y)
        }
    }
}

/// A part of the way: from one point to the next, or to a lamp.
struct Part {
    ends: [DVec3; 2],
    is_to_lamp: bool,
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
            let seen = parts(backdrop.below).lerp(parts(backdrop.above), height);
            return way.vector("the backdrop", "W·m⁻²·sr⁻¹", seen);
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
                let share = parts(mirror.share);
                let seen = self.mirrored(way, line, [p, n], depth);
                way.vector("the mirror's share of that", "W·m⁻²·sr⁻¹", share * seen)
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
        let ambient = parts(phong.ambient) * parts(self.scene.ambient);
        let mut sum = way.vector("k_a i_a", "W·m⁻²·sr⁻¹", ambient);
        let matte = way.part("k_d", parts(phong.diffuse));
        let shiny = way.part("k_s", parts(phong.specular));
        let exponent = way.part("α", f64::from(phong.exponent));
        for (i, lamp) in self.scene.lamps.iter().enumerate() {
            let to = lamp.position.as_dvec3() - p;
            let (distance, toward) = (to.length(), to.normalize_or(n));
            let lambert = way.number(format!("lamp {i}: L·N"), "", toward.dot(n));
            if way.decides("the lamp is behind the surface", lambert <= 0.0) {
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
            let hidden = between.into_iter().position(|hidden| hidden);
            self.parts.push(Part {
                ends: [p, lamp.position.as_dvec3()],
                is_to_lamp: true,
            });
            if way.decides("a thing is in the way to the lamp", hidden.is_some()) {
                let object = hidden.unwrap_or_default();
                way.remark(format!(
                    "Object {object} is in the way: the lamp throws no light here."
                ));
                continue;
            }
            let intensity = parts(lamp.intensity);
            let distance = way.part("r, the distance to the lamp", distance);
            let square = way.part("r²", distance * distance);
            let arriving = way.vector("I/r²", "W/m²", intensity / square);
            let mirrored = way.part("R = 2 (L·N) N − L", 2.0 * lambert * n - toward);
            let cosine = way.number("R·V", "", mirrored.dot(view));
            let is_behind = way.decides("the highlight is on the other side", cosine <= 0.0);
            let cosine = if is_behind { 0.0 } else { cosine };
            let power = way.part("(R·V)^α", cosine.powf(exponent));
            let height = way.part("L·N in the diffuse part", lambert);
            let light = (matte * height + shiny * power) * arriving;
            sum += way.vector("(k_d (L·N) + k_s (R·V)^α) I/r²", "W·m⁻²·sr⁻¹", light);
        }
        way.vector("the surface's radiance, the sum", "W·m⁻²·sr⁻¹", sum)
    }

    fn mirrored(&mut self, way: &mut Way, line: Line, [p, n]: [DVec3; 2], depth: u32) -> DVec3 {
        let d = line.direction;
        let across = way.part("2 (d·n) n", 2.0 * d.dot(n) * n);
        let direction = way.vector("the mirror direction d − 2 (d·n) n", "", d - across);
        self.radiance(
            way,
            Line {
                origin: p,
                direction,
            },
            depth - 1,
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
        let is_total = way.decides("the ray is totally reflected", squared <= 0.0);
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
            sum += rest
                * self.radiance(
                    way,
                    Line {
                        origin: p,
                        direction,
                    },
                    depth - 1,
                );
        }
        way.vector("R · the one + (1 − R) · the other", "W·m⁻²·sr⁻¹", sum)
    }
}

/// The parts of the way, and the radiance.
fn traced(q: &Trace, way: &mut Way) -> (Vec<Part>, DVec3) {
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

impl Explained for Trace {
    fn work(&self, way: &mut Way) -> Rgb {
        colour(traced(self, way).1)
    }

    fn draw(&self, _: &Rgb, _: Option<&Rgb>) -> Option<Diagram> {
        let (traced, _) = traced(self, &mut Way::default());
        let (o, d) = (self.ray.origin.as_dvec3(), self.ray.direction.as_dvec3());
        let ends = || traced.iter().flat_map(|part| part.ends).chain([o]);
        let (min, max) = ends().fold((o, o + d), |(min, max), p| (min.min(p), max.max(p)));
        let view = View::least(max - min);
        let size = (max - min).length();
        let mut drawing = Diagram::new(format!(
            "The way of the ray through the scene, {}; dashed from a surface to the lamps",
            view.words()
        ));
        for (i, object) in self.scene.objects.iter().enumerate() {
            let near = |p: DVec3| p.clamp(min, max).distance(p) < size;
            let mut name =
                |at: DVec3| drawing.label(view.at(at), dvec2(0.0, 0.0), format!("{i}"), Ink::Shape);
            match &object.form {
                Form::Sphere(sphere) if near(sphere.center.as_dvec3()) => {
                    name(sphere.center.as_dvec3());
                    drawing.circle(
                        view.at(sphere.center.as_dvec3()),
                        sphere.radius.into(),
                        Ink::Shape,
                    );
                }
                Form::Triangle(corners) => {
                    let corners = [corners.p0, corners.p1, corners.p2].map(Vec3::as_dvec3);
                    if corners.into_iter().all(near) {
                        name((corners[0] + corners[1] + corners[2]) / 3.0);
                        drawing.area(&corners.map(|p| view.at(p)), Ink::Shape);
                    }
                }
                Form::Plane(plane) => {
                    let n = plane.normal.as_dvec3();
                    let middle = 0.5 * (min + max);
                    let foot = middle + (f64::from(plane.offset) - n.dot(middle)) * n;
                    let across = view.at(n).perp();
                    // A plane that is seen from above is everywhere; one from its side is a line.
                    if across.length() > 0.99 && near(foot) {
                        let half = 0.5 * size * across;
                        drawing.line(&[view.at(foot) - half, view.at(foot) + half], Ink::Shape);
                        drawing.label(
                            view.at(foot) + half,
                            dvec2(0.0, 0.9),
                            format!("{i}"),
                            Ink::Shape,
                        );
                    }
                }
                Form::Sphere(_) => {}
            }
        }
        for part in &traced {
            let [from, to] = part.ends.map(|p| view.at(p));
            if part.is_to_lamp {
                drawing.line(&[from, to], Ink::Guide);
                drawing.label(to, dvec2(0.0, 0.9), "lamp", Ink::Guide);
            } else {
                drawing.arrow(from, to, Ink::Ray);
            }
        }
        if traced.is_empty() {
            drawing.arrow(view.at(o), view.at(o + d), Ink::Ray);
        }
        Some(drawing)
    }
}
