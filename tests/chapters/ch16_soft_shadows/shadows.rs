//! Umbra and penumbra, where geometry says; and errors as large as statistics say.

use glam::vec2;
use raybook::light::extent::LightSampling;
use raybook::math::pcg;
use raybook_chapters::ch16_soft_shadows::light_error::Setting;
use raybook_chapters::ch16_soft_shadows::penumbra::Shadow;

/// Lights and boards: with and without an umbra, near and far.
const SHADOWS: [Shadow; 4] = [
    Shadow {
        light: vec2(1.6, 3.0),
        board: vec2(2.0, 1.2),
    },
    Shadow {
        light: vec2(0.2, 5.0),
        board: vec2(1.0, 0.5),
    },
    Shadow {
        light: vec2(3.0, 4.0),
        board: vec2(1.0, 2.5),
    },
    Shadow {
        light: vec2(1.0, 2.0),
        board: vec2(0.5, 1.0),
    },
];

/// The fraction of the light that a board leaves in view, by the part of the light that lies past its ends.
fn exact(shadow: &Shadow, x: f32) -> f32 {
    let Shadow { light, board } = *shadow;
    // The board as it is projected onto the light from x.
    let grown = light.y / board.y;
    let [left, right] = [-0.5, 0.5].map(|end| x + grown * (end * board.x - x));
    let half = 0.5 * light.x;
    let hidden = (right.min(half) - left.max(-half)).max(0.0);
    1.0 - hidden / light.x
}

#[test]
fn umbra_and_penumbra_end_where_similar_triangles_say() {
    const SAMPLES: u32 = 2000;
    for shadow in SHADOWS {
        let [umbra, penumbra] = shadow.ends();
        let width = shadow.light.x * shadow.board.y / (shadow.light.y - shadow.board.y);
        assert!(
            (penumbra - umbra - width).abs() < 1e-5,
            "the penumbra of {shadow:?} is w·h/(H − h) = {width} m wide"
        );
        let just = 0.02 * width;
        for side in [-1.0, 1.0] {
            let seen = |x: f32| shadow.seen_from(side * x, SAMPLES);
            assert_eq!(seen(penumbra + just), 1.0, "{shadow:?}: full light");
            let edge = seen(penumbra - just);
            assert!(edge < 1.0, "{shadow:?}: the penumbra begins at once");
            if umbra > just {
                assert_eq!(seen(umbra - just), 0.0, "{shadow:?}: the umbra is dark");
                assert!(seen(umbra + just) > 0.0, "{shadow:?}: and no farther");
            } else if umbra < -just {
                assert!(seen(0.0) > 0.0, "{shadow:?} has no umbra");
            }
        }
    }
}

#[test]
fn the_fraction_that_is_seen_is_that_of_the_light_past_the_board() {
    const SAMPLES: u32 = 4000;
    let mut partly = 0;
    for shadow in SHADOWS {
        for step in -60..=60 {
            let x = step as f32 * 0.05;
            let (got, exact) = (shadow.seen_from(x, SAMPLES), exact(&shadow, x));
            // Six standard deviations: 1 in 10⁹.
            let bound = 6.0 * (exact * (1.0 - exact) / SAMPLES as f32).sqrt() + 2e-3;
            assert!(
                (got - exact).abs() <= bound,
                "{shadow:?}: from x = {x}, {got} of the light is seen, not {exact}"
            );
            partly += u32::from((0.01..0.99).contains(&exact));
        }
    }
    assert!(partly > 50, "only {partly} of the places are in a penumbra");
}

#[test]
fn four_times_as_many_samples_halve_the_error() {
    for setting in [Setting::open(), Setting::shaded()] {
        let exact = setting.exact();
        for choose in [LightSampling::ByArea, LightSampling::BySolidAngle] {
            let mut rng = pcg::stream(16, 2);
            let errors = [16, 64, 256].map(|n| setting.error(choose, n, exact, &mut rng));
            for pair in errors.windows(2) {
                // Of 300 repetitions, the root of the mean square is within 4 % of its expectation; four times that.
                let ratio = pair[0] / pair[1];
                assert!((1.6..2.5).contains(&ratio), "{choose:?}: {ratio} times");
            }
        }
    }
}

#[test]
fn choosing_by_solid_angle_pays_near_a_light_and_not_in_its_penumbra() {
    let ratio = |setting: &Setting| {
        let exact = setting.exact();
        let error = |choose| setting.error(choose, 64, exact, &mut pcg::stream(16, 3));
        error(LightSampling::ByArea) / error(LightSampling::BySolidAngle)
    };
    let (open, shaded) = (ratio(&Setting::open()), ratio(&Setting::shaded()));
    assert!(
        open > 1.5,
        "near a light, the error by area is {open} times as large"
    );
    assert!(
        (0.85..1.2).contains(&shaded),
        "in the penumbra, {shaded} times"
    );
}

#[test]
fn no_light_is_seen_from_behind_it() {
    let shadow = Shadow {
        light: vec2(1.0, -1.0),
        board: vec2(0.1, 5.0),
    };
    assert_eq!(shadow.seen_from(0.0, 100), 0.0, "the light faces down");
}
