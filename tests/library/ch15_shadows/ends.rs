//! Where light ends on a mesh that pretends to be round.

use glam::{Vec2, Vec3, vec3};
use raybook::math::dir3::Dir3;
use raybook::prelude::*;
use raybook::render::local::Local;
use raybook::render::{shadow, terminator::terminator};
use raybook::shape::teapot;

/// A facet that faces up, whose interpolated normal leans by so much towards +x.
fn facet(lean: f32) -> Surface {
    Surface {
        position: Vec3::ZERO,
        error: 0.0,
        normal: Dir3::Y,
        shading_normal: direction(lean, 1.0),
        texture: Vec2::ZERO,
    }
}

fn direction(x: f32, y: f32) -> Dir3 {
    Dir3::new(vec3(x, y, 0.0)).expect("not 0")
}

#[test]
fn a_facet_loses_its_light_smoothly_before_it_turns_away() {
    for lean in [0.05, 0.2, 0.5] {
        let at = facet(lean);
        let mut last = 0.0;
        for i in 0..=200 {
            // From the facet's horizon to straight up.
            let angle = i as f32 / 200.0 * std::f32::consts::FRAC_PI_2;
            let toward = direction(angle.cos(), angle.sin());
            let share = terminator(&at, Dir3::Y, toward);
            assert!((0.0..=1.0).contains(&share), "{share} at {angle}");
            assert!(share >= last - 1e-6, "it grows with the height");
            assert!(
                share - last < 0.12,
                "without a step: {last} and {share} at {angle}"
            );
            last = share;
        }
        let horizon = direction(1.0, 1e-3);
        let kept = terminator(&at, Dir3::Y, horizon) * at.shading_normal.dot(*horizon);
        assert!(
            at.shading_normal.dot(*horizon) > 0.04,
            "the interpolated normal sees light"
        );
        assert!(kept < 0.005, "{kept} of it is kept where the shadow begins");
        assert_eq!(last, 1.0, "all of the light from above is kept");
    }
}

#[test]
fn a_flat_facet_keeps_all_light_and_both_sides_are_alike() {
    let (flat, leaning) = (facet(0.0), facet(0.3));
    for toward in [direction(1.0, 0.01), direction(-2.0, 1.0), Dir3::Y] {
        assert_eq!(terminator(&flat, Dir3::Y, toward), 1.0);
        let above = terminator(&leaning, Dir3::Y, toward);
        let below = terminator(&leaning, -Dir3::Y, -toward);
        assert_eq!(above, below);
    }
    for wild in [f32::NAN, f32::MAX, 0.0] {
        let at = Surface {
            normal: Dir3::new_or(vec3(wild, 1.0, 0.0), Dir3::X),
            ..leaning
        };
        assert!(terminator(&at, Dir3::Y, Dir3::X).is_finite());
    }
}

/// Of the points of a coarse teapot at which the light ends, how bright the brightest is beside its shadow.
#[test]
fn the_stairs_on_a_coarse_teapot_are_gone() {
    let sun = DirectionalLight {
        toward: direction(-1.0, 0.45),
        irradiance: Rgb::WHITE,
    };
    let pot = Meshed::new(teapot::mesh(3), WideBvh::new);
    let white = Lambert { albedo: Rgb::WHITE };
    let scene = Scene::new(vec![Thing::new(pot, white)], vec![Box::new(sun)]);
    let local = Local {
        samples: 1,
        arrives: Some(shadow::lit),
    };
    let mut numbers = raybook::math::pcg::stream(1, 0);
    // Along the belly, from the side of the sun to the other one: the largest step from one point to the next.
    let (mut before, mut after) = (0.0_f32, 0.0_f32);
    let mut last: Option<[f32; 2]> = None;
    let mut points = 0;
    for i in 0..4000 {
        let turn = i as f32 / 4000.0 * std::f32::consts::PI;
        let out = Dir3::new_or(vec3(-turn.cos(), 0.0, turn.sin()), Dir3::Z);
        let ray = Ray::new(vec3(0.0, 0.9, 0.0) + 6.0 * *out, -out);
        let Some(seen) = scene.closest(&ray) else {
            continue;
        };
        let sample = sun
            .sample(seen.surface.position, Vec2::ZERO)
            .expect("always");
        let arrives = shadow::lit(&scene, &seen.surface, &sample);
        let hard = if arrives {
            seen.material.lit(&seen.surface, out, &sample).g
        } else {
            0.0
        };
        let soft = local.follow(&scene, &seen, out, &mut numbers).radiance.g;
        if let Some([h, s]) = last {
            before = before.max((hard - h).abs());
            after = after.max((soft - s).abs());
        }
        last = Some([hard, soft]);
        points += 1;
    }
    assert!(points > 3900, "{points} points are on the pot");
    // A facet spans a twelfth of the turn; what the sun sends is 1/π at most.
    assert!(before > 0.05, "there were stairs, of {before}");
    assert!(
        after < before / 4.0,
        "the largest step was {before} and is {after}"
    );
}
