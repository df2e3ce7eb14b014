//! The gas and its light.

use glam::vec3;
use raybook::light::black_body::black_body;
use raybook::math::dir3::Dir3;
use raybook::render::curved::doppler::shift;
use raybook::scene::accretion_disc::AccretionDisc;
use raybook_chapters::ch21_black_hole::starry_sky::starry_sky;

#[test]
fn hotter_is_brighter_and_bluer() {
    let mut before = black_body(1000.0);
    for hundreds in 11..200 {
        let now = black_body(100.0 * hundreds as f32);
        assert!(now.luminance() > before.luminance(), "{hundreds}00 K");
        assert!(now.b / now.r >= before.b / before.r, "{hundreds}00 K");
        before = now;
    }
}

#[test]
fn daylight_is_white_and_a_candle_orange() {
    let daylight = black_body(6500.0);
    assert!((daylight.luminance() - 1.0).abs() < 1e-3, "the scale");
    for channel in daylight.channels() {
        assert!((channel - 1.0).abs() < 0.06, "6500 K is {daylight:?}");
    }
    let candle = black_body(1900.0);
    assert!(
        candle.r > 3.0 * candle.g && candle.g > 3.0 * candle.b,
        "{candle:?}"
    );
}

#[test]
fn gas_that_comes_is_bluer_than_gas_that_goes() {
    let far = 1e6;
    let at = 6.0;
    // Seen from the side, the light that reaches us from the approaching limb has about b = r.
    let (comes, goes, still) = (
        shift(at, 6.5, far),
        shift(at, -6.5, far),
        shift(at, 0.0, far),
    );
    assert!(
        comes > 1.0 && goes < still && still < 1.0,
        "{comes} {still} {goes}"
    );
    // Seen from above there is gravity and the slow clock only: √(1 − 3/(2r)).
    assert!((still - 0.75_f64.sqrt()).abs() < 1e-6, "{still}");
}

#[test]
fn a_slow_far_orbit_has_the_doppler_shift_of_the_school() {
    let (r, far) = (1e6_f64, 1e12);
    let speed = (0.5 / r).sqrt();
    let got = shift(r, r, far);
    assert!(
        (got - 1.0 - speed).abs() < 2.0 * speed * speed,
        "{got} against 1 + v = {}",
        1.0 + speed
    );
}

#[test]
fn the_disc_is_hottest_near_its_inner_edge_and_ends_at_both() {
    let disc = AccretionDisc::new(11.0, 5500.0);
    assert!(!disc.holds(2.99) && disc.holds(3.0) && disc.holds(10.9) && !disc.holds(11.0));
    assert!(
        (disc.temperature(3.0 * 49.0 / 36.0) - 5500.0).abs() < 1.0,
        "hottest at 49/36"
    );
    assert!(disc.temperature(3.0) < 1.0, "the inner edge is cold");
    assert!(disc.temperature(10.0) < 4000.0, "and so is the outer part");
    for r in [3.0, 3.5, 5.0, 9.0, 10.99] {
        for shift in [0.1, 1.0, 2.0, 100.0] {
            let (glow, opacity) = disc.glow(vec3(r, 0.0, 0.0), shift);
            let channels = glow.channels();
            assert!(
                channels.iter().all(|c| c.is_finite() && *c >= 0.0),
                "{r} {shift}: {glow:?}"
            );
            assert!((0.0..=1.0).contains(&opacity), "{r}: {opacity}");
        }
    }
}

#[test]
fn the_sky_is_dark_with_bright_stars() {
    let mut bright = 0;
    let count = 200_000;
    for i in 0..count {
        // Fibonacci's lattice on the sphere.
        let y = 1.0 - 2.0 * (i as f32 + 0.5) / count as f32;
        let turn = 2.399_963 * (i % 65_536) as f32 + 0.7 * (i / 65_536) as f32;
        let across = (1.0 - y * y).sqrt();
        let d = Dir3::new_or(vec3(across * turn.cos(), y, across * turn.sin()), Dir3::Y);
        let light = starry_sky(d);
        assert!(
            light.channels().iter().all(|c| c.is_finite() && *c >= 0.0),
            "{d:?}: {light:?}"
        );
        bright += usize::from(light.luminance() > 0.3);
    }
    let share = f64::from(bright as u32) / f64::from(count);
    assert!(
        (1e-5..1e-2).contains(&share),
        "{share} of the sky is bright"
    );
}
