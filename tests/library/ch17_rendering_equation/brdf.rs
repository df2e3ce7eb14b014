//! What every BRDF of nature does: it is reciprocal, it sends out no more than it gets; and its samples fit its density.

use crate::ch17_rendering_equation::{direction, integral, square, surface};
use raybook::image::rgb::Rgb;
use raybook::material::{
    Material, conductor::Metal, ggx::Ggx, lambert::Lambert, modified_phong::ModifiedPhong,
};
use raybook::math::{dir3::Dir3, pcg};
use raybook::render::reflection::reflected_radiance;
use raybook::sample::hemisphere::uniform_hemisphere;
use raybook_common::statistics::Mean;

fn phong(diffuse: f32, specular: f32, exponent: f32) -> ModifiedPhong {
    ModifiedPhong {
        diffuse: Rgb::gray(diffuse),
        specular: Rgb::gray(specular),
        exponent,
    }
}

/// Each material with its name and the most that leaves of what arrives. Of light from straight above just this leaves, except from
/// rough metal, whose facets lose some of it.
fn brdfs() -> Vec<(String, f64, Box<dyn Material>)> {
    let albedo = Rgb::gray(0.8);
    let mut all: Vec<(String, f64, Box<dyn Material>)> =
        vec![("Lambert".into(), 0.8, Box::new(Lambert { albedo }))];
    for exponent in [0.0, 1.0, 7.0, 50.0] {
        for (diffuse, specular) in [(0.0, 1.0), (0.3, 0.6)] {
            let name = format!("Phong {diffuse} + {specular}, exponent {exponent}");
            let brdf = Box::new(phong(diffuse, specular, exponent));
            all.push((name, f64::from(diffuse + specular), brdf));
        }
    }
    for alpha in [0.3, 0.6, 1.0] {
        let metal = Metal::GOLD;
        let most = f64::from(metal.reflectance(0.0).g);
        all.push((format!("GGX {alpha}"), most, Box::new(Ggx { metal, alpha })));
    }
    all
}

fn views() -> [Dir3; 4] {
    [
        Dir3::Z,
        direction(0.4, 0.3, 0.8),
        direction(-0.9, 0.1, 0.4),
        direction(0.0, 1.0, 0.02),
    ]
}

#[test]
fn light_and_viewer_can_change_places() {
    let at = surface(Dir3::Z);
    let mut rng = pcg::stream(1, 1);
    for (name, _, brdf) in brdfs() {
        for _ in 0..1000 {
            let [a, b] = [(); 2].map(|()| uniform_hemisphere(Dir3::Z, square(&mut rng)));
            let (one, other) = (brdf.eval(&at, a, b).g, brdf.eval(&at, b, a).g);
            assert!(
                (one - other).abs() <= 1e-4 * one.max(0.01),
                "{name}: {one} and {other} for {a:?} and {b:?}"
            );
            assert!(one >= 0.0, "{name}: {one} is negative");
        }
    }
}

#[test]
fn no_more_leaves_than_arrives_and_all_of_it_straight_up() {
    let at = surface(Dir3::Z);
    for (name, albedo, brdf) in brdfs() {
        for view in views() {
            let sent = integral(|d| brdf.eval(&at, view, d).g * d.z);
            assert!(
                sent <= albedo + 1e-3,
                "{name}, {view:?}: {sent} of 1 leaves, {albedo} at most"
            );
            if view == Dir3::Z && !name.starts_with("GGX") {
                assert!((sent - albedo).abs() < 1e-3, "{name}: {sent}, not {albedo}");
            }
        }
    }
}

#[test]
fn samples_are_as_likely_as_their_density_says() {
    let at = surface(Dir3::Z);
    for (name, _, brdf) in brdfs() {
        for view in views() {
            // Any function will do that tells directions apart.
            let tell = |d: Dir3| 1.0 + 0.5 * d.x + 0.3 * d.y * d.z + d.z;
            let exact = integral(|d| brdf.pdf(&at, view, d) * tell(d));
            let mean = Mean::sampled(5, 4000, |rng| {
                brdf.sample(&at, view, square(rng)).map_or(0.0, tell)
            });
            // The integral has errors of its own where a sharp lobe is cut off by the horizon.
            assert!(
                (mean.mean - exact).abs() < 5.0 * mean.error + 2e-3,
                "{name}, {view:?}: {mean:?}, not {exact}"
            );
        }
    }
}

#[test]
fn a_density_of_another_lobe_would_be_noticed() {
    let (at, view) = (surface(Dir3::Z), direction(0.4, 0.3, 0.8));
    let (sampled, claimed) = (phong(0.3, 0.6, 7.0), phong(0.3, 0.6, 8.0));
    let exact = integral(|d| claimed.pdf(&at, view, d) * d.z);
    let mean = Mean::sampled(5, 4000, |rng| {
        sampled.sample(&at, view, square(rng)).map_or(0.0, |d| d.z)
    });
    assert!(
        (mean.mean - exact).abs() > 5.0 * mean.error + 2e-3,
        "exponent 8 for 7: {mean:?}, {exact}"
    );
}

#[test]
fn nothing_is_reflected_from_or_to_behind() {
    let at = surface(Dir3::Z);
    let (up, down) = (direction(0.3, 0.0, 1.0), direction(0.3, 0.0, -1.0));
    for (name, _, brdf) in brdfs() {
        for (view, toward) in [(up, down), (down, up), (up, Dir3::X)] {
            assert_eq!(
                brdf.eval(&at, view, toward),
                Rgb::BLACK,
                "{name}: {view:?} {toward:?}"
            );
        }
        assert_eq!(
            brdf.eval(&at, down, down),
            brdf.eval(&surface(-Dir3::Z), down, down),
            "{name}: seen from behind, the back is the front"
        );
    }
}

#[test]
fn the_reflected_radiance_is_the_integral() {
    let at = surface(Dir3::Z);
    let sky = |d: Dir3| Rgb::gray(1.0 + d.x);
    for (name, _, brdf) in brdfs() {
        for view in views() {
            let exact = integral(|d| brdf.eval(&at, view, d).g * d.z * (1.0 + d.x));
            let mean = Mean::sampled(6, 20, |rng| {
                reflected_radiance(&*brdf, &at, view, &sky, 200, rng).g
            });
            assert!(
                (mean.mean - exact).abs() < 5.0 * mean.error + 2e-3,
                "{name}, {view:?}: {mean:?}, not {exact}"
            );
        }
    }
}
