//! Chapter 12: highlights, in the plane of the normal and the light, and what a point light sends.

use super::Explained;
use super::diagram::{Diagram, Ink};
use super::section::Section;
use super::way::Way;
use glam::{DVec3, dvec2};
use raybook::image::rgb::Rgb;
use raybook_workbook::exercises::ch12_phong::{
    Arriving, BlinnPhongExercise, Highlight, PhongExercise, PointLightExercise,
};

/// A colour as a vector of its parts.
pub fn parts(colour: Rgb) -> DVec3 {
    DVec3::new(colour.r.into(), colour.g.into(), colour.b.into())
}

/// A vector of a colour's parts as a colour.
pub fn colour(v: DVec3) -> Rgb {
    let v = v.as_vec3();
    Rgb::new(v.x, v.y, v.z)
}

/// N, V and L.
fn directions(at: &Highlight) -> [DVec3; 3] {
    [at.normal, at.view, at.toward].map(|d| d.as_dvec3())
}

/// Diffuse and specular together, where `cosine` gives the highlight's, from N, V, L and L·N.
fn radiance(
    way: &mut Way,
    at: &Highlight,
    cosine: impl FnOnce(&mut Way, [DVec3; 3], f64) -> f64,
) -> Rgb {
    let [n, v, l] = directions(at);
    let n = way.part("N", n);
    let v = way.part("V", v);
    let l = way.part("L", l);
    let products = way.part("the products that L·N adds up", l * n);
    let lambert = way.number("L·N", "", products.element_sum());
    if way.is_at_most("the light is not above the surface", lambert, 0.0) {
        way.remark("The light is not above the surface.");
        return Rgb::BLACK;
    }
    let matte = way.colour_part("k_d", parts(at.diffuse));
    let shiny = way.colour_part("k_s", parts(at.specular));
    let cosine = cosine(way, [n, v, l], lambert);
    let exponent = way.part("α", f64::from(at.exponent));
    let is_behind = way.is_at_most("the highlight is on the other side", cosine, 0.0);
    let cosine = if is_behind { 0.0 } else { cosine };
    let highlight = cosine.powf(exponent);
    let highlight = way.number("that, 0 at least, to the power α", "", highlight);
    // Who goes on below the surface may have cut the cosine off there.
    let height = way.made("to take 0 for a negative L·N", lambert, lambert.max(0.0));
    let height = way.part("L·N in the diffuse part", height);
    let diffuse = way.colour("diffuse: k_d (L·N)", "1/sr", matte * height);
    let specular = way.colour("specular: k_s times that", "1/sr", shiny * highlight);
    let both = way.colour_part("diffuse + specular", diffuse + specular);
    let arriving = way.colour_part("i", parts(at.arriving));
    colour(way.colour("(diffuse + specular) · i", "W·m⁻²·sr⁻¹", both * arriving))
}

/// The same by the viewer's mirror direction.
fn by_the_view(asked: &PhongExercise, way: &mut Way) -> Rgb {
    radiance(way, &asked.at, |way, [n, v, l], _| {
        let cosine = way.part("N·V", n.dot(v));
        let behind = way.part("N, behind 2 (N·V)", n);
        let along = way.part("2 (N·V) N", 2.0 * cosine * behind);
        let subtracted = way.part("V, which is subtracted", v);
        let r = way.part("2 (N·V) N − V", along - subtracted);
        let l = way.part("L, in the product with that", l);
        let products = way.part("the products that the same · L adds up", r * l);
        way.part("the same · L", products.element_sum())
    })
}

/// The same without R: R·V = 2 (L·N) (N·V) − L·V.
fn by_products(asked: &PhongExercise, way: &mut Way) -> Rgb {
    radiance(way, &asked.at, |way, [n, v, l], lambert| {
        let light = way.part("L·N, in 2 (L·N) (N·V)", lambert);
        let seen = way.part("N·V, in 2 (L·N) (N·V)", n.dot(v));
        let along = way.part("2 (L·N) (N·V)", 2.0 * light * seen);
        let between = way.part("L·V", l.dot(v));
        way.part("2 (L·N) (N·V) − L·V", along - between)
    })
}

impl Explained for PhongExercise {
    fn work(&self, way: &mut Way) -> Rgb {
        radiance(way, &self.at, |way, [n, v, l], lambert| {
            let times = way.part("L·N, in 2 (L·N) N", lambert);
            let n = way.part("N, in 2 (L·N) N", n);
            let along = way.part("2 (L·N) N", 2.0 * times * n);
            let l = way.part("L, in 2 (L·N) N − L", l);
            let r = way.vector("R = 2 (L·N) N − L", "", along - l);
            let products = way.part("the products that R·V adds up", r * v);
            way.number("R·V", "", products.element_sum())
        })
    }

    const WAYS: &'static [fn(&Self, &mut Way) -> Rgb] = &[Self::work, by_the_view, by_products];

    fn draw(&self, _: &Rgb, _: Option<&Rgb>) -> Option<Diagram> {
        let [n, _, l] = directions(&self.at);
        Some(fan(
            &self.at,
            ("R", 2.0 * l.dot(n) * n - l),
            "R, the light's mirror image",
        ))
    }
}

impl Explained for BlinnPhongExercise {
    fn work(&self, way: &mut Way) -> Rgb {
        radiance(way, &self.at, |way, [n, v, l], _| {
            let l = way.part("L, in L + V", l);
            let sum = way.part("L + V", l + v);
            let half = way.made("to normalise L + V", sum, sum.normalize_or_zero());
            let half = way.vector("H = (L + V)/|L + V|", "", half);
            let n = way.part("N, in N·H", n);
            let products = way.part("the products that N·H adds up", n * half);
            way.number("N·H", "", products.element_sum())
        })
    }

    fn draw(&self, _: &Rgb, _: Option<&Rgb>) -> Option<Diagram> {
        let [_, v, l] = directions(&self.at);
        Some(fan(
            &self.at,
            ("H", (l + v).normalize_or_zero()),
            "H, half way between L and V",
        ))
    }
}

/// The directions at a point of the surface, seen along the plane of the normal and the light.
fn fan(at: &Highlight, (name, other): (&str, DVec3), what: &str) -> Diagram {
    let [n, v, l] = directions(at);
    let across = l - l.dot(n) * n;
    let mut section = Section::spanned(
        DVec3::ZERO,
        if across.length() > 1e-6 {
            across
        } else {
            v - v.dot(n) * n
        },
        n,
    );
    section.v = n;
    let mut drawing = Diagram::new(format!(
        "The directions at the surface, in the plane of N and L; V is seen against it; {what}"
    ));
    drawing.keyed = false;
    drawing.line(&[dvec2(-1.1, 0.0), dvec2(1.1, 0.0)], Ink::Shape);
    for (name, d, ink) in [
        ("N", n, Ink::Shape),
        ("L", l, Ink::Ray),
        ("V", v, Ink::Guide),
        (name, other, Ink::Right),
    ] {
        let tip = section.along(d);
        drawing.arrow(dvec2(0.0, 0.0), tip, ink);
        drawing.label(tip, tip.normalize_or_zero(), name, ink);
    }
    drawing
}

/// What arrives, where `square` makes d² of r and d.
fn arriving(
    asked: &PointLightExercise,
    way: &mut Way,
    square: fn(&mut Way, DVec3, f64) -> f64,
) -> Option<Arriving> {
    let position = way.part("position", asked.position.as_dvec3());
    let at = way.part("at", asked.at.as_dvec3());
    let r = way.vector("r = position − at", "m", position - at);
    let long = way.part("r, whose length is d", r);
    let distance = way.number("d = |r|", "m", long.length());
    if way.is_zero("the point is the light itself", distance) {
        way.remark("This is the light itself.");
        return None;
    }
    let toward = way.vector("r/d", "", r / distance);
    let square = square(way, r, distance);
    let intensity = way.colour_part("I", parts(asked.intensity));
    let arriving = way.colour("I/d²", "W/m²", intensity / square);
    let distance = way.part("d, returned", distance);
    Some(Arriving {
        toward: toward.as_vec3(),
        distance: distance as f32,
        arriving: colour(arriving),
    })
}

impl Explained for PointLightExercise {
    const WAYS: &'static [fn(&Self, &mut Way) -> Option<Arriving>] = &[Self::work, |asked, way| {
        arriving(asked, way, |way, r, _| {
            let squares = way.part("the squares that r·r adds up", r * r);
            way.part("r·r", squares.element_sum())
        })
    }];

    fn work(&self, way: &mut Way) -> Option<Arriving> {
        arriving(self, way, |way, _, d| way.part("d²", d * d))
    }
}
