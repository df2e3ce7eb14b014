//! Chapter 17: directions by the cosine, the BRDF of the modified Phong model, and the light that it reflects.

use super::Explained;
use super::ch12_phong::{colour, parts};
use super::diagram::{Diagram, Ink};
use super::section::Section;
use super::way::Way;
use glam::{DVec2, DVec3, Vec3, dvec2};
use raybook::image::rgb::Rgb;
use raybook::math::{basis::Basis, dir3::Dir3};
use raybook_workbook::exercises::ch17_rendering_equation::{
    BrdfPhong, CosineHemisphere, ReflectedRadiance, lattice,
};
use std::f64::consts::{FRAC_1_PI, TAU};

/// The cosine of the angle α between the viewer and the mirror direction of the light, from N, V and L, N·L and N·V.
type CosAlpha = fn(&mut Way, [DVec3; 3], f64, f64) -> f64;

/// cos α by the mirror direction.
fn by_the_mirror_direction(way: &mut Way, [n, v, l]: [DVec3; 3], cosine: f64, _: f64) -> f64 {
    let times = way.part("N·L, in 2 (N·L) N", cosine);
    let n = way.part("N, in 2 (N·L) N", n);
    let along = way.part("2 (N·L) N", 2.0 * times * n);
    let l = way.part("L, in 2 (N·L) N − L", l);
    let mirrored = way.vector("R = 2 (N·L) N − L", "", along - l);
    let v = way.part("V, in R·V", v);
    let products = way.part("the products that R·V adds up", mirrored * v);
    way.number("cos α = R·V", "", products.element_sum())
}

/// The same without that direction: R·V = 2 (N·L) (N·V) − L·V.
fn by_products(way: &mut Way, [_, v, l]: [DVec3; 3], cosine: f64, seen: f64) -> f64 {
    let light = way.part("N·L, in 2 (N·L) (N·V)", cosine);
    let seen = way.part("N·V, in 2 (N·L) (N·V)", seen);
    let along = way.part("2 (N·L) (N·V)", 2.0 * light * seen);
    let between = way.part("L·V", l.dot(v));
    way.part("cos α = 2 (N·L) (N·V) − L·V", along - between)
}

/// The BRDF with cos α by one way or the other.
fn brdf(asked: &BrdfPhong, way: &mut Way, cos_alpha: CosAlpha) -> Rgb {
    let [n, v, l] = [asked.normal, asked.view, asked.toward].map(|d| d.as_dvec3());
    let n = way.part("N", n);
    let v = way.part("V", v);
    let l = way.part("L", l);
    let products = way.part("the products that N·L adds up", n * l);
    let cosine = products.element_sum();
    let cosine = way.number("N·L, the light's height above the surface", "", cosine);
    let products = way.part("the products that N·V adds up", n * v);
    let seen = way.number("N·V, the viewer's", "", products.element_sum());
    let unlit = way.is_at_most("the light is not above the surface", cosine, 0.0);
    let unseen = way.is_at_most("the viewer is not above the surface", seen, 0.0);
    if unlit || unseen {
        way.remark("One of them is not above the surface: the BRDF is 0.");
        return Rgb::BLACK;
    }
    let diffuse = way.colour_part("diffuse", parts(asked.diffuse));
    let matte = way.colour("diffuse/π", "1/sr", diffuse * FRAC_1_PI);
    let cos_alpha = cos_alpha(way, [n, v, l], cosine, seen);
    if way.is_at_most("α is above 90°", cos_alpha, 0.0) {
        way.remark("α is above 90°: there is no highlight.");
        return colour(matte);
    }
    let exponent = way.part("n", f64::from(asked.exponent));
    let two = way.part("the 2 of n + 2", 2.0_f64);
    let more = way.part("n + 2", exponent + two);
    let scale = way.number("(n + 2)/2π", "1/sr", more / TAU);
    let power = way.part("n, the power of cos α", exponent);
    let lobe = way.power("cosⁿ α", cos_alpha, power);
    let lobe = way.number("cosⁿ α", "", lobe);
    let specular = way.colour_part("specular", parts(asked.specular));
    let glossy = specular * scale * lobe;
    let glossy = way.colour("specular · (n + 2)/2π · cosⁿ α", "1/sr", glossy);
    colour(way.colour("f = matte + highlight", "1/sr", matte + glossy))
}

impl Explained for BrdfPhong {
    const WAYS: &'static [fn(&Self, &mut Way) -> Rgb] =
        &[Self::work, |asked, way| brdf(asked, way, by_products)];

    fn work(&self, way: &mut Way) -> Rgb {
        brdf(self, way, by_the_mirror_direction)
    }
}

/// The axes around a normal, which is the last of them.
fn axes(normal: Dir3) -> [DVec3; 3] {
    let basis = Basis::around(normal);
    [basis.x, basis.y, basis.z].map(|v| v.as_dvec3())
}

/// A direction around a normal, by its coordinates with the normal as z.
fn around(normal: Dir3, x: f64, y: f64, z: f64) -> DVec3 {
    let [bx, by, bz] = axes(normal);
    x * bx + y * by + z * bz
}

impl Explained for CosineHemisphere {
    fn work(&self, way: &mut Way) -> Vec<Vec3> {
        way.remark("A point of the unit disc, all equally likely, and straight above it the direction (Malley 1988). The first; the others go the same way:");
        way.of_first(lattice(self.n), |way, u| {
            let u = way.pair("u", "", u.as_dvec2());
            let r = way.number("r = √u.x", "", u.x.sqrt());
            let phi = way.number("φ = 2π u.y", "rad", TAU * u.y);
            let cos = way.part("cos φ", phi.cos());
            let sin = way.part("sin φ", phi.sin());
            let p = way.pair("r (cos φ, sin φ), on the disc", "", r * dvec2(cos, sin));
            let squared = way.part("1 − u.x", (1.0 - u.x).max(0.0));
            let height = way.number("√(1 − u.x), the height above it: cos θ", "", squared.sqrt());
            let [x, y, z] = axes(self.normal);
            let x = way.part("the axis beside the normal along which cos φ goes", x);
            let y = way.part("the axis beside the normal along which sin φ goes", y);
            let z = way.part("the normal", z);
            let toward = p.x * x + p.y * y + height * z;
            way.vector("the direction, around the normal", "", toward)
                .as_vec3()
        })
    }

    fn draw(&self, right: &Vec<Vec3>, yours: Option<&Vec<Vec3>>) -> Option<Diagram> {
        /// More points than these nobody can tell apart.
        const MOST: usize = 600;
        let mut drawing = Diagram::new(
            "The directions, seen from above along the normal: with the density cos θ/π they fill the disc evenly",
        );
        drawing.circle(DVec2::ZERO, 1.0, Ink::Shape);
        let basis = Basis::around(self.normal);
        let [x, y] = [basis.x, basis.y].map(|v| v.as_dvec3());
        let yours = yours.map_or(&[][..], Vec::as_slice);
        for (directions, ink) in [(right.as_slice(), Ink::Right), (yours, Ink::Yours)] {
            for d in directions.iter().take(MOST).map(|d| d.as_dvec3()) {
                let at = dvec2(d.dot(x), d.dot(y));
                if at.length() < 2.0 {
                    drawing.point(at, ink);
                }
            }
        }
        Some(drawing)
    }
}

impl Explained for ReflectedRadiance {
    fn work(&self, way: &mut Way) -> Rgb {
        /// Directions for each part: an even lattice is nearer to the truth than as many random ones.
        const DIRECTIONS: u32 = 4096;
        let [n, v, zenith] = [self.normal, self.view, self.zenith].map(|d| d.as_dvec3());
        let exponent = f64::from(self.exponent);
        let sky = |toward: DVec3| 0.5 + 0.5 * toward.dot(zenith);
        way.remark(format!("In place of random directions, an even lattice of {DIRECTIONS}, half and half for the two parts of the BRDF; the sky and cos θ of each direction are averaged:"));
        let mut mean = |name, value: &dyn Fn(DVec2) -> f64| {
            let sum: f64 = lattice(DIRECTIONS).map(|u| value(u.as_dvec2())).sum();
            way.number(name, "", sum / f64::from(DIRECTIONS))
        };
        // p = cos θ/π: f cos θ/p is the albedo.
        let matte = mean(
            "matte: the mean of (1 + cos γ)/2, with p = cos θ/π",
            &|u| {
                let (r, phi) = (u.x.sqrt(), TAU * u.y);
                sky(around(
                    self.normal,
                    r * phi.cos(),
                    r * phi.sin(),
                    (1.0 - u.x).sqrt(),
                ))
            },
        );
        // p = (n + 1)/2π cosⁿ α: f cos θ/p is the albedo · (n + 2)/(n + 1) · cos θ, 0 below the surface.
        let mirrored = Dir3::new_or((2.0 * n.dot(v) * n - v).as_vec3(), self.normal);
        let glossy = mean(
            "highlight: the mean of (1 + cos γ)/2 · cos θ · (n + 2)/(n + 1), with p = (n + 1)/2π · cosⁿ α",
            &|u| {
                let cosine = (1.0 - u.x).powf(1.0 / (exponent + 1.0));
                let (r, phi) = ((1.0 - cosine * cosine).max(0.0).sqrt(), TAU * u.y);
                let toward = around(mirrored, r * phi.cos(), r * phi.sin(), cosine);
                sky(toward) * n.dot(toward).max(0.0) * (exponent + 2.0) / (exponent + 1.0)
            },
        );
        let share = parts(self.diffuse) * matte + parts(self.specular) * glossy;
        let share = way.vector("diffuse · matte + specular · highlight", "", share);
        colour(way.vector(
            "that times the radiance of the zenith",
            "W·m⁻²·sr⁻¹",
            share * parts(self.radiance),
        ))
    }

    fn draw(&self, _: &Rgb, _: Option<&Rgb>) -> Option<Diagram> {
        let [n, v, zenith] = [self.normal, self.view, self.zenith].map(|d| d.as_dvec3());
        let mirrored = 2.0 * n.dot(v) * n - v;
        let mut section = Section::spanned(DVec3::ZERO, v - v.dot(n) * n, n);
        section.v = n;
        let mut drawing = Diagram::new(
            "The surface from its side, in the plane of N and V: R, around which the highlight lies, and the sky's zenith Z, seen against it",
        );
        drawing.keyed = false;
        drawing.line(&[dvec2(-1.1, 0.0), dvec2(1.1, 0.0)], Ink::Shape);
        let arrows = [
            ("N", n, Ink::Shape),
            ("V", v, Ink::Ray),
            ("R", mirrored, Ink::Right),
            ("Z", zenith, Ink::Guide),
        ];
        for (name, d, ink) in arrows {
            let tip = section.along(d);
            drawing.arrow(DVec2::ZERO, tip, ink);
            drawing.label(tip, tip.normalize_or_zero(), name, ink);
        }
        Some(drawing)
    }
}
