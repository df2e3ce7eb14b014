//! Whoever moves the shape and the ray together moves the answer.

use crate::laws::forms::{Form, Motion, aimed, config, direction, vector};
use glam::{Mat3, Vec3};
use proptest::prelude::*;
use raybook::math::{interval::Interval, ray::Ray};
use raybook::shape::{ROUNDING, Surface};

/// The ray moved along: its direction too is `Dir3::new` of the moved one.
fn moved(ray: &Ray, motion: &Motion) -> Ray {
    Ray::new(motion.point(ray.origin), motion.direction(ray.direction))
}

/// What the ray hits ahead of it, which it does.
fn look(form: &Form, ray: &Ray) -> Result<(f32, Surface), TestCaseError> {
    let shape = form.build();
    let hit = shape.hit(ray, Interval::AHEAD).ok_or_else(|| {
        TestCaseError::fail(format!("{ray:?} is aimed at the inside of {form:?}"))
    })?;
    Ok((hit.t, shape.surface(ray, &hit)))
}

/// The answer to the moved question is the moved answer, but for the rounding of both.
fn agrees(form: &Form, ray: &Ray, motion: &Motion) -> Result<(), TestCaseError> {
    let (t, at) = look(form, ray)?;
    let (form2, ray2) = (form.moved(motion), moved(ray, motion));
    let (t2, at2) = look(&form2, &ray2)?;
    // The rounding of each: what the shape states, and the ray's. A grazing ray stretches it by 1/cos.
    let rounding = |ray: &Ray, t: f32, at: &Surface| {
        (at.error + ROUNDING * (ray.origin.abs().max_element() + t))
            / at.normal.dot(*ray.direction).abs()
    };
    let allowed = motion.scale * rounding(ray, t, &at) + rounding(&ray2, t2, &at2);
    prop_assert!(
        (t2 - motion.scale * t).abs() <= allowed,
        "t was {t}, is {t2} at scale {}; {allowed} is allowed",
        motion.scale
    );
    let off = (at2.position - motion.point(at.position)).length();
    prop_assert!(
        off <= 2.0 * allowed,
        "the position is {off} off, {} is allowed",
        2.0 * allowed
    );
    Ok(())
}

/// As [`agrees`], to the last bit: for motions that commute with rounding.
fn agrees_exactly(form: &Form, ray: &Ray, scale: f32, turn: Mat3) -> Result<(), TestCaseError> {
    let shift = Vec3::ZERO;
    let motion = Motion { scale, turn, shift };
    // Unmoved, but with every direction normalised once more, as those of the moved ones are.
    let still = Motion {
        scale: 1.0,
        turn: Mat3::IDENTITY,
        shift,
    };
    let (t, at) = look(&form.moved(&still), &moved(ray, &still))?;
    let (t2, at2) = look(&form.moved(&motion), &moved(ray, &motion))?;
    prop_assert_eq!(
        t2,
        scale * t,
        "the distance is not exactly {} times as long",
        scale
    );
    prop_assert_eq!(
        at2.position,
        motion.point(at.position),
        "the position moved otherwise"
    );
    prop_assert_eq!(at2.error, scale * at.error, "the error scaled otherwise");
    prop_assert_eq!(
        *at2.normal,
        turn * *at.normal,
        "the normal turned otherwise"
    );
    Ok(())
}

/// The permutations of the axes that are rotations, with signs: quarter turns about the axes and all that follow from them.
fn quarter_turns(i: usize) -> Mat3 {
    let quarter = std::f32::consts::FRAC_PI_2;
    let turn = |axis: Vec3, n: usize| Mat3::from_axis_angle(axis, quarter * n as f32);
    let all = turn(Vec3::X, i % 4) * turn(Vec3::Y, i / 4 % 4) * turn(Vec3::Z, i / 16 % 4);
    Mat3::from_cols_array(&all.to_cols_array().map(f32::round))
}

proptest! {
    #![proptest_config(config(10_000))]

    #[test]
    fn powers_of_two_scale_exactly((form, ray) in aimed(1.0), exponent in -20..=20) {
        agrees_exactly(&form, &ray, 2.0_f32.powi(exponent), Mat3::IDENTITY)?;
    }

    // x·x′ + y·y′ + z·z′ is summed from the left: exchanging x and y changes no bit, but z has to stay where it is.
    #[test]
    fn quarter_turns_about_z_are_exact((form, ray) in aimed(1.0), turns in 0..4_usize) {
        if matches!(form, Form::Instance(..)) {
            return Ok(()); // it is turned by other angles too
        }
        agrees_exactly(&form, &ray, 1.0, quarter_turns(16 * turns))?;
    }

    #[test]
    fn quarter_turns_agree_for_every_shape((form, ray) in aimed(1.0), i in 0..64_usize, shift in vector()) {
        agrees(&form, &ray, &Motion { scale: 1.0, turn: quarter_turns(i), shift: 10.0 * shift })?;
    }

    #[test]
    fn rotations_shifts_and_scales_agree_for_every_shape_but_the_box((form, ray) in aimed(1.0), axis in direction(), angle in -3.2_f32..3.2, shift in vector(), scale in 0.01_f32..100.0) {
        if matches!(form, Form::Cuboid(..)) {
            return Ok(());
        }
        let turn = Mat3::from_axis_angle(*axis, angle);
        agrees(&form, &ray, &Motion { scale, turn, shift: 10.0 * scale * shift })?;
    }
}
