//! The lights: what is sampled, how densely, and what arrives.

use glam::{Vec2, Vec3, vec2, vec3};
use rand::RngExt;
use raybook::image::rgb::Rgb;
use raybook::light::Light;
use raybook::light::extent::Choose;
use raybook::light::rect_light::RectLight;
use raybook::light::sphere_light::SphereLight;
use raybook::math::{dir3::Dir3, pcg, ray::Ray};
use raybook::shape::sphere::Sphere;
use std::f32::consts::{PI, TAU};

const BOTH: [Choose; 2] = [Choose::ByArea, Choose::BySolidAngle];

/// The middle of each cell of an n × n lattice of the unit square.
fn lattice(n: u32) -> impl Iterator<Item = Vec2> {
    (0..n * n).map(move |i| (vec2((i % n) as f32, (i / n) as f32) + 0.5) / n as f32)
}

/// A direction, uniform over the sphere.
fn on_sphere(u: Vec2) -> Dir3 {
    let z = 1.0 - 2.0 * u.x;
    let (sine, phi) = ((1.0 - z * z).max(0.0).sqrt(), TAU * u.y);
    Dir3::new(vec3(sine * phi.cos(), sine * phi.sin(), z)).expect("it has length 1")
}

fn rect(corner: Vec3, a: Vec3, b: Vec3, choose: Choose) -> RectLight {
    RectLight::new(corner, a, b, Rgb::WHITE).choosing(choose)
}

fn sphere(center: Vec3, radius: f32, choose: Choose) -> SphereLight {
    SphereLight {
        sphere: Sphere::new(center, radius),
        radiance: Rgb::WHITE,
        choose,
    }
}

/// n² directions and the solid angle that each stands for.
type Directions = Box<dyn Fn(u32) -> Vec<(Dir3, f64)>>;

/// All directions, evenly.
fn everywhere(n: u32) -> Vec<(Dir3, f64)> {
    let each = f64::from(2.0 * TAU) / f64::from(n * n);
    lattice(n).map(|u| (on_sphere(u), each)).collect()
}

/// Those in which a sphere is seen, ever closer towards its rim, where the density by area grows without a limit.
///
/// Not too close: in the last thousandth, the last digit of a direction decides on its density.
fn dense_at_the_rim(light: SphereLight) -> Directions {
    let cone = SphereLight {
        choose: Choose::BySolidAngle,
        ..light
    };
    Box::new(move |n| {
        let n = n / 4;
        let direction = |v: Vec2| {
            let u = vec2(1.0 - (1.0 - v.x).powi(2), v.y);
            let sample = cone.sample(Vec3::ZERO, u).expect("it is seen");
            let each = 2.0 * f64::from(1.0 - v.x) / f64::from(sample.pdf) / f64::from(n * n);
            (sample.toward, each)
        };
        lattice(n).map(direction).collect()
    })
}

/// Lights of both kinds around the origin, from which they are seen, each chosen both ways; and directions to ask about.
fn lights() -> Vec<(String, Box<dyn Light>, Directions)> {
    let mut lights: Vec<(String, Box<dyn Light>, Directions)> = Vec::new();
    for choose in BOTH {
        let mut add = |name: &str, light: Box<dyn Light>| {
            lights.push((format!("{name}, {choose:?}"), light, Box::new(everywhere)));
        };
        let square = rect(vec3(-0.5, 1.0, -0.5), Vec3::X, Vec3::Z, choose);
        add("a unit square one metre above", Box::new(square));
        let aside = rect(vec3(2.0, 1.5, -3.0), 1.5 * Vec3::X, 0.7 * Vec3::Z, choose);
        add("a rectangle to the side", Box::new(aside));
        let a = vec3(1.0, 0.5, -0.3);
        let across = a.cross(vec3(0.2, -1.0, 0.4));
        let askew = rect(vec3(-0.4, 1.0, 0.8), 2.0 * across, a, choose);
        add("a rectangle askew", Box::new(askew));
        let around = sphere(vec3(0.3, 0.4, 0.0), 1.0, choose);
        add("a sphere around", Box::new(around));
        let centred = sphere(Vec3::ZERO, 2.0, choose);
        add("a sphere around its centre", Box::new(centred));
        for (name, center, radius) in [
            ("a sphere", vec3(1.0, 2.0, -1.0), 0.8),
            ("a sphere close by", vec3(0.0, 1.1, 0.0), 1.0),
        ] {
            let light = sphere(center, radius, choose);
            let directions = match choose {
                Choose::ByArea => dense_at_the_rim(light),
                Choose::BySolidAngle => Box::new(everywhere),
            };
            lights.push((format!("{name}, {choose:?}"), Box::new(light), directions));
        }
    }
    lights
}

#[test]
fn the_density_of_directions_integrates_to_1() {
    for (name, light, directions) in lights() {
        let integral: f64 = directions(1500)
            .iter()
            .map(|(d, solid_angle)| f64::from(light.pdf(Vec3::ZERO, *d)) * solid_angle)
            .sum();
        assert!(
            (integral - 1.0).abs() < 0.015,
            "{name}: the density integrates to {integral} over all directions"
        );
    }
}

#[test]
fn a_sample_knows_its_density_its_distance_and_what_arrives() {
    for (name, light, _) in lights() {
        let mut told = 0;
        for u in lattice(40) {
            let sample = light.sample(Vec3::ZERO, u).expect("all are seen from here");
            let (pdf, ray) = (
                light.pdf(Vec3::ZERO, sample.toward),
                Ray::new(Vec3::ZERO, sample.toward),
            );
            // At the rim of the sphere the last digit of the direction decides on which point is met.
            let Some((t, radiance)) = light.seen(&ray) else {
                continue;
            };
            told += u32::from(
                (t - sample.distance).abs() < 2e-3 * t && (pdf - sample.pdf).abs() < 0.05 * pdf,
            );
            assert_eq!(radiance, Rgb::WHITE, "{name}: it shines equally everywhere");
            let product = sample.arriving.g * sample.pdf;
            assert!(
                (product - 1.0).abs() < 1e-5,
                "{name}: what arrives is the radiance over the density, not {product} times"
            );
        }
        assert!(
            told >= 1590,
            "{name}: of 1600 samples, {told} have the density and the distance of their direction"
        );
    }
}

/// Samples fall into the cells of a lattice on the sphere as often as the density says.
#[test]
fn samples_follow_their_density() {
    const CELLS: usize = 16;
    const SAMPLES: usize = 200_000;
    for (name, light, directions) in lights() {
        let cell = |d: Dir3| {
            let u = vec2(0.5 - 0.5 * d.z, d.y.atan2(d.x) / TAU + 0.5);
            let place = (u * CELLS as f32).as_uvec2().min(glam::UVec2::splat(15));
            place.y as usize * CELLS + place.x as usize
        };
        let mut expected = vec![0.0_f64; CELLS * CELLS];
        for (d, solid_angle) in directions(2000) {
            let share = f64::from(light.pdf(Vec3::ZERO, d)) * solid_angle;
            expected[cell(d)] += share * SAMPLES as f64;
        }
        let mut found = vec![0.0_f64; CELLS * CELLS];
        let mut rng = pcg::stream(16, 0);
        for _ in 0..SAMPLES {
            let sample = light.sample(Vec3::ZERO, vec2(rng.random(), rng.random()));
            found[cell(sample.expect("all are seen from here").toward)] += 1.0;
        }
        let (mut chi, mut cells) = (0.0, 0.0);
        for (expected, found) in expected.iter().zip(&found) {
            if *expected > 50.0 {
                chi += (found - expected).powi(2) / expected;
                cells += 1.0;
            }
        }
        // χ² has mean `cells` and variance 2·cells; the expected numbers are themselves off by up to 1 in a thousand.
        let z = (chi - cells) / f64::sqrt(2.0 * cells);
        assert!(z < 6.0, "{name}: χ² over {cells} cells is {chi:.0}");
    }
}

/// What arrives on a patch at the origin that faces up, as the mean over a lattice.
fn irradiance(light: &dyn Light, normal: Vec3) -> f64 {
    let n = 400;
    let sum: f64 = lattice(n)
        .filter_map(|u| light.sample(Vec3::ZERO, u))
        .map(|s| f64::from(s.arriving.g * s.toward.dot(normal).max(0.0)))
        .sum();
    sum / f64::from(n * n)
}

/// π times the view factor from a patch to a parallel rectangle whose corner is above it (Howell, *A catalog of
/// radiation heat transfer configuration factors*, B-3): x = a/h, y = b/h.
fn parallel(x: f64, y: f64) -> f64 {
    let part = |x: f64, y: f64| x / (1.0 + x * x).sqrt() * (y / (1.0 + x * x).sqrt()).atan();
    0.5 * (part(x, y) + part(y, x))
}

#[test]
fn a_rectangle_sheds_as_much_light_as_its_view_factor_says() {
    for choose in BOTH {
        let light = rect(vec3(0.0, 2.0, 0.0), 1.5 * Vec3::X, 3.0 * Vec3::Z, choose);
        // a × b points down: X × Z = −Y.
        let (got, exact) = (irradiance(&light, Vec3::Y), parallel(0.75, 1.5));
        assert!(
            (got / exact - 1.0).abs() < 1e-4,
            "{choose:?}: {got} W/m² arrive, and {exact} should"
        );
    }
}

#[test]
fn a_sphere_sheds_as_much_light_as_its_solid_angle_says() {
    for choose in BOTH {
        // π L sin²α from straight above, π L from everywhere.
        let above = irradiance(&sphere(3.0 * Vec3::Y, 1.0, choose), Vec3::Y);
        let around = irradiance(&sphere(vec3(0.2, 0.0, 0.3), 1.0, choose), Vec3::Y);
        let [above, around] = [above * 9.0, around].map(|e| e / f64::from(PI));
        assert!((above - 1.0).abs() < 1e-3, "{choose:?}: {above} of π sin²α");
        assert!(
            (around - 1.0).abs() < 2e-3,
            "{choose:?}, inside: {around} of π"
        );
    }
}

#[test]
fn nothing_comes_from_the_back_of_a_rectangle_or_from_none() {
    for choose in BOTH {
        let back = rect(vec3(-0.5, 1.0, -0.5), Vec3::Z, Vec3::X, choose);
        let level = rect(vec3(1.0, 0.0, 0.0), Vec3::X, Vec3::Z, choose);
        let needle = rect(Vec3::Y, Vec3::X, Vec3::X, choose);
        for light in [back, level, needle] {
            for u in lattice(8) {
                assert_eq!(light.sample(Vec3::ZERO, u), None, "{choose:?}: {light:?}");
            }
            assert_eq!(light.pdf(Vec3::ZERO, Dir3::Y), 0.0, "{choose:?}: {light:?}");
        }
    }
}

#[test]
fn tiny_huge_and_distant_lights_keep_their_solid_angle() {
    for scale in [1e-6_f32, 1e-3, 1.0, 1e3, 1e6] {
        for choose in BOTH {
            for (size, away) in [(1.0, 1.0), (1e-3, 1.0), (1.0, 1e4), (1e3, 1.0)] {
                if choose == Choose::ByArea && size > away {
                    continue; // few of a huge light's points are near
                }
                let (size, away) = (size * scale, away * scale);
                let corner = vec3(-0.5 * size, away, -0.5 * size);
                let square = rect(corner, size * Vec3::X, size * Vec3::Z, choose);
                let n = 200;
                let sum: f64 = lattice(n)
                    .filter_map(|u| square.sample(Vec3::ZERO, u))
                    .map(|s| f64::from(s.arriving.g))
                    .sum();
                let solid_angle = sum / f64::from(n * n);
                let half = 0.5 * f64::from(size / away);
                let exact = 4.0 * (half * half / (1.0 + half * half)).asin();
                assert!(
                    (solid_angle / exact - 1.0).abs() < 1e-3,
                    "{choose:?}: a square of {size} m, {away} m away, has {solid_angle} sr, not {exact}"
                );
                let ball = sphere((away + size) * Vec3::Y, size, choose);
                let sum: f64 = lattice(n)
                    .filter_map(|u| ball.sample(Vec3::ZERO, u))
                    .map(|s| f64::from(s.arriving.g))
                    .sum();
                let solid_angle = sum / f64::from(n * n);
                let sin2 = (f64::from(size) / f64::from(away + size)).powi(2);
                let exact = f64::from(TAU) * sin2 / (1.0 + (1.0 - sin2).sqrt());
                assert!(
                    (solid_angle / exact - 1.0).abs() < 5e-3,
                    "{choose:?}: a sphere of {size} m, {away} m away, has {solid_angle} sr, not {exact}"
                );
            }
        }
    }
}
