//! Chapter 17: the BRDF of the modified Phong model.

use super::Explained;
use super::ch12_phong::{colour, parts};
use super::way::Way;
use raybook::image::rgb::Rgb;
use raybook_workbook::exercises::ch17_rendering_equation::BrdfPhong;
use std::f64::consts::{FRAC_1_PI, TAU};

impl Explained for BrdfPhong {
    fn work(&self, way: &mut Way) -> Rgb {
        let [n, v, l] = [self.normal, self.view, self.toward].map(|d| d.as_dvec3());
        let cosine = way.number("N·L, the light's height above the surface", "", n.dot(l));
        let seen = way.number("N·V, the viewer's", "", n.dot(v));
        if cosine <= 0.0 || seen <= 0.0 {
            way.remark("One of them is not above the surface: the BRDF is 0.");
            return Rgb::BLACK;
        }
        let matte = way.vector("diffuse/π", "1/sr", parts(self.diffuse) * FRAC_1_PI);
        let mirrored = way.vector("R = 2 (N·L) N − L", "", 2.0 * cosine * n - l);
        let cos_alpha = way.number("cos α = R·V", "", mirrored.dot(v));
        if cos_alpha <= 0.0 {
            way.remark("α is above 90°: there is no highlight.");
            return colour(matte);
        }
        let exponent = f64::from(self.exponent);
        let scale = way.number("(n + 2)/2π", "1/sr", (exponent + 2.0) / TAU);
        let lobe = way.number("cosⁿ α", "", cos_alpha.powf(exponent));
        let glossy = parts(self.specular) * scale * lobe;
        let glossy = way.vector("specular · (n + 2)/2π · cosⁿ α", "1/sr", glossy);
        colour(way.vector("f = matte + highlight", "1/sr", matte + glossy))
    }
}
