//! Published deflections of light by a black hole and by the sun, and the angles of a hole's shadow.

use raybook::render::curved::CRITICAL;
use raybook::render::curved::deflection::deflection_angle;
use raybook::render::curved::observer::shadow_half_angle;
use std::f64::consts::PI;

#[track_caller]
fn deflection(b: f64) -> f64 {
    deflection_angle(b).expect("it gets away")
}

/// Impact parameters in radii of the hole, and deflections in radians: the elliptic integral of Darwin, "The gravity field of a
/// particle" (1959), by quadrature with 30 digits.
const DARWIN: [(f64, f64); 9] = [
    (2.6, 6.810_371_957),
    (2.7, 2.919_396_340),
    (3.0, 1.719_388_310),
    (4.0, 0.858_730_018),
    (5.0, 0.590_395_788),
    (10.0, 0.236_135_995),
    (20.0, 0.108_104_077),
    (100.0, 0.020_299_966),
    (1000.0, 0.002_002_951),
];

#[test]
fn deflections_are_those_of_darwins_integral() {
    for (b, published) in DARWIN {
        let got = deflection(b);
        assert!(
            (got - published).abs() < 1e-8,
            "b = {b}: {got}, not {published}"
        );
    }
}

/// The coefficients of the powers of M/b, with M half of the hole's radius: Keeton and Petters, "Formalism for testing theories of
/// gravity using lensing by compact objects" (2005), for Schwarzschild's metric. The first is Einstein's.
const WEAK: [f64; 6] = [
    4.0,
    15.0 * PI / 4.0,
    128.0 / 3.0,
    3465.0 * PI / 64.0,
    3584.0 / 5.0,
    255_255.0 * PI / 256.0,
];

#[test]
fn far_from_the_hole_deflections_are_those_of_the_published_series() {
    for b in [20.0, 50.0, 100.0, 1000.0] {
        let x = 0.5 / b;
        let series = WEAK.iter().rev().fold(0.0, |sum, c| x * (sum + c));
        // Each coefficient is about 4 times the one before: the rest of the series is below twice the next term.
        let rest = 8.0 * WEAK[5] * f64::powi(x, 7);
        let got = deflection(b);
        assert!(
            (got - series).abs() < rest + 1e-12,
            "b = {b}: {got}, not {series}"
        );
    }
}

/// Near the critical b_c the deflection is −ln(b/b_c − 1) + ln(216 (7 − 4√3)) − π (Bozza, Capozziello, Iovane and Scarpetta,
/// "Strong field limit of black hole gravitational lensing", 2001), of which the last two terms are −0.4002 (Bozza 2002).
#[test]
fn near_the_critical_ray_deflections_are_those_of_the_strong_limit() {
    let last = (216.0 * (7.0 - 4.0 * 3.0_f64.sqrt())).ln() - PI;
    assert!((last + 0.4002).abs() < 1e-4, "{last}");
    for b in [2.5981, 2.5982, 2.599, 2.6] {
        let beyond = b / CRITICAL - 1.0;
        let published = last - beyond.ln();
        let got = deflection(b);
        // What is left out is of this order.
        let rest = -beyond * beyond.ln();
        assert!(
            (got - published).abs() < rest,
            "b = {b}: {got}, not {published}"
        );
    }
}

/// 1.75″ at the limb of the sun (Dyson, Eddington and Davidson, "A determination of the deflection of light by the sun's gravitational
/// field", 1920), with the mass GM and the radius of the sun of the International Astronomical Union (2015, resolution B3).
#[test]
fn the_sun_deflects_light_as_much_as_eddington_expected() {
    const GM: f64 = 1.327_124_4e20; // m³/s²
    const RADIUS: f64 = 6.957e8; // m
    const SPEED_OF_LIGHT: f64 = 299_792_458.0; // m/s
    let hole = 2.0 * GM / SPEED_OF_LIGHT.powi(2);
    let seconds = 3600.0 * deflection(RADIUS / hole).to_degrees();
    assert!((seconds - 1.75).abs() < 0.005, "{seconds}″");
}

/// The radius at which an observer rests, in radii of the hole, and the angle α from the middle to the edge of the shadow, in degrees:
/// sin²α = 27/4 (r − 1)/r³ (Synge, "The escape of photons from gravitationally intense stars", 1966).
const SHADOWS: [(f64, f64); 5] = [
    (1.5, 90.0),
    (2.0, 66.7163),
    (3.0, 45.0),
    (5.0, 27.6946),
    (10.0, 14.2690),
];

#[test]
fn shadows_of_a_hole_have_the_published_angles() {
    for (r, degrees) in SHADOWS {
        let got = shadow_half_angle(r).to_degrees();
        // At 90° the sine says little of the angle: 1e-16 of the sine are 1e-6 degrees.
        assert!(
            (got - degrees).abs() < 1e-4,
            "r = {r}: {got}°, not {degrees}°"
        );
    }
}
