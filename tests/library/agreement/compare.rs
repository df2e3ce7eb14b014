//! Comparing a structure's answers with the list's.

use crate::agreement::rays::RayRecipe;
use crate::agreement::scenes::Scene;
use crate::agreement::structures::Checked;
use proptest::prelude::*;
use proptest::test_runner::TestCaseError;
use raybook::accel::{Accel, list::List};
use raybook::math::{interval::Interval, ray::Ray};
use raybook::shape::{Hit, Shape};
use std::cell::Cell;
use std::fmt::Debug;

/// How far two hits may be apart that count as equal, in parts of the largest number that went into them: the bound of
/// every shape's own rounding (`raybook::shape::ROUNDING`).
const EQUAL: f32 = raybook::shape::ROUNDING;

/// What was seen, lest a test passes in which nothing is hit.
#[derive(Default)]
pub(super) struct Seen {
    pub rays: Cell<u32>,
    pub hits: Cell<u32>,
}

/// Asks all structures over a scene all questions, each in every way.
pub(super) fn compare<S: Shape + Copy + PartialEq + Debug>(
    scene: &Scene<S>,
    questions: &[RayRecipe],
    structures: &[(&str, Box<dyn Checked<S>>)],
    seen: &Seen,
) -> Result<(), TestCaseError> {
    let list = List::new(scene.shapes.clone());
    for (name, structure) in structures {
        let valid = structure.validate();
        prop_assert!(valid.is_ok(), "{name}: {}", valid.unwrap_err());
    }
    for recipe in questions {
        let (ray, within) = recipe.in_scene(scene);
        let expected = list.closest(&ray, within).map(|(shape, hit)| (*shape, hit));
        seen.rays.set(seen.rays.get() + 1);
        seen.hits
            .set(seen.hits.get() + u32::from(expected.is_some()));
        for (name, structure) in structures {
            let found = structure.closest(&ray, within);
            if let Err(why) = same(scene, &ray, found, expected) {
                return Err(TestCaseError::fail(format!(
                    "{name}: {why}\n{ray:?} {within:?}\nlist {expected:?}\n{name} {found:?}"
                )));
            }
            let (counted, tests) = structure.closest_counted(&ray, within);
            prop_assert_eq!(found, counted, "{}: counting changes the answer", name);
            prop_assert!(
                found.is_none() || tests.shapes > 0,
                "{name}: a hit without a test: {tests:?}"
            );
            let any = structure.any(&ray, within);
            prop_assert_eq!(
                any,
                found.is_some(),
                "{}: any and closest differ for {:?} {:?}",
                name,
                ray,
                within
            );
        }
    }
    Ok(())
}

/// The same shape at the same distance, or another at an equal one; and the hit is that of the shape that comes with it.
fn same<S: Shape + PartialEq>(
    scene: &Scene<S>,
    ray: &Ray,
    found: Option<(S, Hit)>,
    expected: Option<(S, Hit)>,
) -> Result<(), String> {
    let ((shape, found), (_, expected)) = match (found, expected) {
        (None, None) => return Ok(()),
        (Some(found), Some(expected)) => (found, expected),
        (Some(_), None) => return Err("a hit where the list has none".into()),
        (None, Some(_)) => return Err("a hit is lost".into()),
    };
    let numbers = [
        scene.largest(),
        ray.origin.abs().max_element(),
        expected.t.abs(),
    ];
    let scale = numbers.into_iter().fold(0.0, f32::max);
    let tolerance = EQUAL * scale;
    if (found.t - expected.t).abs() > tolerance {
        return Err(format!("the distances differ by more than {tolerance}"));
    }
    let again = shape.hit(ray, Interval::new(f32::NEG_INFINITY, f32::INFINITY));
    match again {
        Some(again) if (again.t - found.t).abs() <= tolerance && again.id == found.id => Ok(()),
        // A ball or a box is also hit where the ray leaves it.
        Some(again) if again.t < found.t && again.id == found.id => Ok(()),
        again => Err(format!("the shape itself says {again:?}")),
    }
}
