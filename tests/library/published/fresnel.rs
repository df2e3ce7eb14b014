//! Published reflectances of glass and metals.

use glam::vec3;
use raybook::image::rgb::Rgb;
use raybook::material::conductor::Metal;
use raybook::material::fresnel::fresnel;
use raybook::material::refract::refract;
use raybook::math::dir3::Dir3;

fn cosine(degrees: f64) -> f32 {
    degrees.to_radians().cos() as f32
}

/// The angle of incidence in degrees, the indices on its side and on the other side, and the amplitudes of the reflected light, across
/// the plane of incidence and parallel to it: Mitsuba 3 (Jakob et al. 2022), `src/render/tests/test_fresnel.py`. Those at 45° are from
/// Nave's page "Fresnel's equations" (HyperPhysics). The last three rows follow from the critical angle and from the horizon.
const GLASS: [(f64, f32, f32, [f64; 2]); 8] = [
    (0.0, 1.0, 1.5, [0.2, 0.2]),
    (0.0, 1.5, 1.0, [0.2, 0.2]),
    (45.0, 1.0, 1.5, [0.303_337_045, 0.092_013_363]),
    (10.0, 1.5, 1.0, [0.209_494_320, 0.190_467_972]),
    (56.3099, 1.0, 1.5, [0.384_615_094, 0.0]), // Brewster's angle
    (45.0, 1.5, 1.0, [1.0, 1.0]),
    (90.0, 1.0, 1.5, [1.0, 1.0]),
    (90.0, 1.5, 1.0, [1.0, 1.0]),
];

#[test]
fn glass_reflects_what_is_published() {
    for (degrees, n1, n2, amplitudes) in GLASS {
        let got = fresnel(cosine(degrees), n1, n2);
        let [s, p] = amplitudes.map(|r| r * r);
        for (name, got, exact) in [
            ("Rs", got.s, s),
            ("Rp", got.p, p),
            ("R", got.unpolarised, 0.5 * (s + p)),
        ] {
            assert!(
                (f64::from(got) - exact).abs() < 2e-7,
                "from {n1} into {n2} at {degrees}°: {name} is {got}, not {exact}"
            );
        }
    }
}

/// The angles of incidence and of refraction, in degrees, and the indices, from the same file.
const BENT: [(f64, f64, f32, f32); 2] = [
    (45.0, 28.125_505_702, 1.0, 1.5),
    (10.0, 15.098_086_605, 1.5, 1.0),
];

#[test]
fn glass_refracts_as_is_published() {
    for (degrees, refracted, n1, n2) in BENT {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let down = Dir3::new(vec3(sin as f32, -cos as f32, 0.0)).expect("a direction");
        let through = refract(down, Dir3::Y, n1, n2).expect("it goes through");
        let got = f64::from(through.x)
            .atan2(f64::from(-through.y))
            .to_degrees();
        assert!(
            (got - refracted).abs() < 1e-5,
            "from {n1} into {n2} at {degrees}°: {got}°, not {refracted}°"
        );
    }
}

/// The colours of light that metals reflect straight back: Akenine-Möller et al., *Real-Time Rendering*, fourth edition, 2018, table 9.2.
const METALS: [(&str, Metal, Rgb); 4] = [
    ("gold", Metal::GOLD, Rgb::new(1.000, 0.782, 0.344)),
    ("silver", Metal::SILVER, Rgb::new(0.972, 0.960, 0.915)),
    ("copper", Metal::COPPER, Rgb::new(0.955, 0.638, 0.538)),
    ("aluminium", Metal::ALUMINIUM, Rgb::new(0.913, 0.922, 0.924)),
];

#[test]
fn metals_have_the_published_colours() {
    for (name, metal, published) in METALS {
        let got = metal.reflectance(1.0);
        for (got, published) in got.channels().into_iter().zip(published.channels()) {
            // The table has the colour of the reflected spectrum, and the library reflects by the mean index of each channel.
            assert!(
                (got - published).abs() < 0.04,
                "{name}: {got}, not {published}"
            );
        }
    }
}
