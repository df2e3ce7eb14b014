//! Chapter 3: the quadratic equation, and the sphere in the plane of the ray and its centre.

use super::Explained;
use super::diagram::{Diagram, Ink};
use super::rays;
use super::section::Section;
use super::way::Way;
use glam::{DVec3, Vec2, Vec3, dvec2};
use raybook::math::{interval::Interval, ray::Ray};
use raybook_workbook::exercises::ch03_sphere::{SolveQuadratic, SphereHit, SphereNormal};

/// B² − 4AC by its parts.
fn discriminant(way: &mut Way, [a, b, c]: [f64; 3]) -> f64 {
    let square = way.part("B²", b * b);
    let a = way.part("A in 4AC", a);
    let c = way.part("C in 4AC", c);
    square - way.part("4AC", 4.0 * a * c)
}

/// The real roots of a·t² + b·t + c = 0 without cancellation, the smaller one first.
pub fn roots(way: &mut Way, [a, b, c]: [f64; 3]) -> Option<[f64; 2]> {
    let discriminant = discriminant(way, [a, b, c]);
    let discriminant = way.number("B² − 4AC", "", discriminant);
    if way.is_less("the discriminant is negative", discriminant, 0.0) {
        way.remark("The discriminant is negative: no root is real.");
        return None;
    }
    let root = way.part("√(B² − 4AC)", discriminant.sqrt());
    let q = way.number(
        "q = −½(B + sign(B)·√(B² − 4AC))",
        "",
        -0.5 * (b + root.copysign(b)),
    );
    let [t0, t1] = if way.is_zero("q is 0", q) {
        [0.0; 2]
    } else {
        let under = way.part("A under q", a);
        let above = way.part("C above q", c);
        [q / under, above / q]
    };
    let t0 = way.number("q/A", "", t0);
    let t1 = way.number("C/q", "", t1);
    Some(sorted(way, t0, t1))
}

/// Two roots, the smaller one first.
fn sorted(way: &mut Way, t0: f64, t1: f64) -> [f64; 2] {
    let is_sorted = way.is_at_most("the roots are in order", t0, t1);
    let [small, large] = if is_sorted { [t0, t1] } else { [t1, t0] };
    [
        way.part("the smaller root", small),
        way.part("the larger root", large),
    ]
}

/// The roots by the formula of most books.
fn book_roots(way: &mut Way, [a, b, c]: [f64; 3]) -> Option<[f64; 2]> {
    let discriminant = discriminant(way, [a, b, c]);
    let discriminant = way.part("B² − 4AC", discriminant);
    if way.is_less("the discriminant is negative", discriminant, 0.0) {
        return None;
    }
    let root = way.part("√(B² − 4AC)", discriminant.sqrt());
    let minus = way.part("−B", -b);
    let twice = way.part("2A", 2.0 * a);
    let t0 = way.part("(−B − √(B² − 4AC))/2A", (minus - root) / twice);
    let t1 = way.part("(−B + √(B² − 4AC))/2A", (minus + root) / twice);
    Some(sorted(way, t0, t1))
}

/// The roots by the normalised equation t² + p t + q = 0.
fn normalised_roots(way: &mut Way, [a, b, c]: [f64; 3]) -> Option<[f64; 2]> {
    let p = way.part("p = B/A", b / a);
    let q = way.part("q = C/A", c / a);
    let last = way.part("q above the other root", q);
    let half = way.part("p/2", 0.5 * p);
    let square = way.part("(p/2)²", half * half);
    let discriminant = way.part("(p/2)² − q", square - q);
    if way.is_less("the discriminant is negative", discriminant, 0.0) {
        return None;
    }
    let root = way.part("√((p/2)² − q)", discriminant.sqrt());
    let middle = way.part("−p/2", -half);
    let large = way.part("the root of the larger size", middle - root.copysign(half));
    if way.is_zero("both roots are 0", large) {
        return Some([0.0; 2]);
    }
    let small = way.part("q/the other root", last / large);
    Some(sorted(way, large, small))
}

/// A way to the real roots of a quadratic equation.
type Roots = fn(&mut Way, [f64; 3]) -> Option<[f64; 2]>;

fn solved(asked: &SolveQuadratic, way: &mut Way, roots: Roots) -> Option<Vec2> {
    let a = way.part("A", f64::from(asked.a));
    let b = way.part("B", f64::from(asked.b));
    let c = way.part("C", f64::from(asked.c));
    if way.is_zero("A is 0", a) {
        way.remark("A is 0: the equation is not quadratic.");
        return None;
    }
    let [t0, t1] = roots(way, [a, b, c])?;
    let both = way.pair("both, the smaller one first", "", dvec2(t0, t1));
    Some(both.as_vec2())
}

impl Explained for SolveQuadratic {
    const WAYS: &'static [fn(&Self, &mut Way) -> Option<Vec2>] = &[
        Self::work,
        |asked, way| solved(asked, way, book_roots),
        |asked, way| solved(asked, way, normalised_roots),
    ];

    fn work(&self, way: &mut Way) -> Option<Vec2> {
        solved(self, way, roots)
    }
}

/// The smallest distance that counts at which a ray meets a sphere.
pub fn meets(
    way: &mut Way,
    ray: &Ray,
    within: Interval,
    center: DVec3,
    radius: f64,
) -> Option<f64> {
    let (o, d) = rays::parts(ray);
    // The point of the ray that is nearest to the centre: from there lengths are as short as they can be.
    let closest = way.number(
        "s = (c − o)·d/(d·d), where the ray is nearest to the centre",
        "m",
        (center - o).dot(d) / d.dot(d),
    );
    let m = way.vector("m = o + s·d − c", "m", o + closest * d - center);
    let a = way.number("A = d·d", "", d.dot(d));
    let b = way.number("B = 2 d·m", "m", 2.0 * d.dot(m));
    let square = way.part("m·m", m.length_squared());
    let radius = way.part("r²", radius * radius);
    let c = way.number("C = m·m − r²", "m²", square - radius);
    let found = roots(way, [a, b, c])?;
    let near = way.number("t₀ = s + the smaller root", "m", closest + found[0]);
    let far = way.number("t₁ = s + the larger root", "m", closest + found[1]);
    let t = first(way, within, [near, far]);
    match t {
        Some(t) if t == near => way.remark("t₀ is in the interval: it is the nearest."),
        Some(_) => way.remark("t₀ is outside of the interval, t₁ is in it."),
        None => way.remark("Neither t₀ nor t₁ is in the interval."),
    }
    t
}

/// The first of two distances that counts.
fn first(way: &mut Way, within: Interval, [near, far]: [f64; 2]) -> Option<f64> {
    let min = way.part("min", f64::from(within.min));
    let max = way.part("max", f64::from(within.max));
    let near_counts = way.is_less("the smaller root is larger than min", min, near)
        && way.is_less("the smaller root is smaller than max", near, max);
    if way.decides("the smaller root counts", near_counts) {
        return Some(near);
    }
    let far_counts = way.is_less("the larger root is larger than min", min, far)
        && way.is_less("the larger root is smaller than max", far, max);
    way.decides("the larger root counts", far_counts)
        .then_some(far)
}

/// The same by the equation of o − c, as the lecture has it.
fn by_equation(asked: &SphereHit, way: &mut Way, roots: Roots) -> Option<f32> {
    let (o, d) = rays::parts(&asked.ray);
    let o = way.part("o", o);
    let d = way.part("d", d);
    let center = way.part("c", asked.center.as_dvec3());
    let radius = way.part("r", f64::from(asked.radius));
    let m = way.part("m = o − c", o - center);
    let a = way.part("A = d·d", d.dot(d));
    let b = way.part("B = 2 d·m", 2.0 * d.dot(m));
    let square = way.part("m·m", m.length_squared());
    let radius = way.part("r²", radius * radius);
    let c = way.part("C = m·m − r²", square - radius);
    let roots = roots(way, [a, b, c])?;
    first(way, asked.within, roots).map(|t| t as f32)
}

/// The same by the foot of the perpendicular from the centre, and half of the chord.
fn by_chord(asked: &SphereHit, way: &mut Way) -> Option<f32> {
    let (o, d) = rays::parts(&asked.ray);
    let to_center = way.part("c − o", asked.center.as_dvec3() - o);
    let radius = way.part("r", f64::from(asked.radius));
    let foot = way.part("s = (c − o)·d", to_center.dot(d));
    let beside = way.part("from the foot to the centre", to_center - foot * d);
    let away = way.part("the square of that distance", beside.length_squared());
    let radius = way.part("r²", radius * radius);
    let square = way.part("the square of half of the chord", radius - away);
    if way.is_less("the ray passes by the sphere", square, 0.0) {
        return None;
    }
    let half = way.part("half of the chord", square.sqrt());
    let back = way.part("minus half of the chord", -half);
    let near = way.part("s − half of the chord", foot + back);
    let far = way.part("s + half of the chord", foot + half);
    first(way, asked.within, [near, far]).map(|t| t as f32)
}

/// The same with the square of the distance by Pythagoras.
fn by_pythagoras(asked: &SphereHit, way: &mut Way) -> Option<f32> {
    let (o, d) = rays::parts(&asked.ray);
    let to_center = asked.center.as_dvec3() - o;
    let radius = way.part("r", f64::from(asked.radius));
    let foot = way.part("s = (c − o)·d", to_center.dot(d));
    let whole = way.part("|c − o|²", to_center.length_squared());
    let leg = way.part("s²", foot * foot);
    let away = way.part("|c − o|² − s²", whole - leg);
    let most = way.part("r² that is compared", radius * radius);
    if way.is_less("the ray passes by the sphere", most, away) {
        return None;
    }
    let square = way.part("r² − (|c − o|² − s²)", radius * radius - away);
    let half = way.part("half of the chord", square.sqrt());
    first(way, asked.within, [foot - half, foot + half]).map(|t| t as f32)
}

impl Explained for SphereHit {
    const WAYS: &'static [fn(&Self, &mut Way) -> Option<f32>] = &[
        Self::work,
        |asked, way| by_equation(asked, way, roots),
        |asked, way| by_equation(asked, way, book_roots),
        |asked, way| by_equation(asked, way, normalised_roots),
        by_chord,
        by_pythagoras,
    ];

    fn work(&self, way: &mut Way) -> Option<f32> {
        meets(
            way,
            &self.ray,
            self.within,
            self.center.as_dvec3(),
            self.radius.into(),
        )
        .map(|t| t as f32)
    }

    fn draw(&self, right: &Option<f32>, yours: Option<&Option<f32>>) -> Option<Diagram> {
        let (o, d) = rays::parts(&self.ray);
        let (center, radius) = (self.center.as_dvec3(), f64::from(self.radius));
        let section = Section::spanned(o, d, center - o);
        let mut drawing = Diagram::new(
            "The ray and the sphere, in the plane through the ray and the sphere's centre",
        );
        drawing.circle(section.at(center), radius, Ink::Shape);
        drawing.point(section.at(center), Ink::Shape);
        drawing.label(section.at(center), dvec2(0.4, 1.3), "c", Ink::Shape);
        let far = (section.at(center).x + 1.5 * radius).max(2.0 * radius);
        rays::hits(
            &mut drawing,
            &section,
            &self.ray,
            self.within,
            far,
            [*right, yours.copied().flatten()],
        );
        Some(drawing)
    }
}

impl Explained for SphereNormal {
    fn work(&self, way: &mut Way) -> Vec3 {
        let p = way.part("p", self.p.as_dvec3());
        let center = way.part("c", self.center.as_dvec3());
        let out = way.vector("p − c", "m", p - center);
        let length = way.number("|p − c|", "m", out.length());
        let normal = if length > 0.0 { out / length } else { DVec3::Y };
        way.vector("(p − c)/|p − c|", "", normal).as_vec3()
    }

    fn draw(&self, right: &Vec3, yours: Option<&Vec3>) -> Option<Diagram> {
        let (center, p, radius) = (
            self.center.as_dvec3(),
            self.p.as_dvec3(),
            f64::from(self.radius),
        );
        let toward = yours.map_or(DVec3::Y, |n| n.as_dvec3());
        let section = Section::spanned(center, p - center, toward);
        let mut drawing = Diagram::new(
            "The normal, in the plane of the sphere's centre, the point and your normal",
        );
        drawing.circle(dvec2(0.0, 0.0), radius, Ink::Shape);
        drawing.point(dvec2(0.0, 0.0), Ink::Shape);
        drawing.label(dvec2(0.0, 0.0), dvec2(-0.8, 0.0), "c", Ink::Shape);
        let at = section.at(p);
        drawing.point(at, Ink::Ray);
        drawing.label(at, dvec2(-0.8, 0.0), "p", Ink::Ray);
        for (n, ink, beside, name) in rays::answers(Some(right), yours) {
            // Of length 1 it is drawn as long as the radius.
            let tip = at + radius * section.along(n.as_dvec3()).clamp_length_max(4.0);
            drawing.arrow(at, tip, ink);
            drawing.label(
                tip,
                beside,
                format!("{name}, of length {:.3}", n.length()),
                ink,
            );
        }
        Some(drawing)
    }
}
