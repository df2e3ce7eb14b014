//! Every accelerator answers as the list does, whatever it is given; and none lets the counting change an answer.

#[path = "agreement/rays.rs"]
mod rays;
#[path = "agreement/scenes.rs"]
mod scenes;
#[path = "agreement/structures.rs"]
mod structures;

use glam::Vec3;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestCaseError, TestRunner};
use rand::RngExt;
use raybook::accel::{Accel, list::List, wide_bvh::WideBvh};
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::scene::soup;
use raybook::shape::{Hit, Shape};
use rays::RayRecipe;
use scenes::Scene;
use std::cell::Cell;
use std::fmt::Debug;
use structures::{Checked, facets, things};

/// Scenes; each is built into every structure, and looked at by [`RAYS`] rays.
const SCENES: u32 = 400;
const RAYS: usize = 48;

/// How far two hits may be apart that count as equal, in parts of the largest number that went into them: the bound of
/// every shape's own rounding (`raybook::shape::ROUNDING`).
const EQUAL: f32 = raybook::shape::ROUNDING;

/// What was seen, lest a test passes in which nothing is hit.
#[derive(Default)]
struct Seen {
    rays: Cell<u32>,
    hits: Cell<u32>,
}

/// The seed is fixed, for what fails must fail again; `PROPTEST_RNG_SEED=7 cargo test --test agreement` tries others.
fn runner(scenes: u32) -> TestRunner {
    let seed = std::env::var("PROPTEST_RNG_SEED").ok();
    TestRunner::new(Config {
        cases: scenes,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(seed.and_then(|seed| seed.parse().ok()).unwrap_or(11)),
        ..Config::default()
    })
}

#[test]
fn every_structure_agrees_with_the_list_on_facets() {
    let seen = Seen::default();
    let questions = prop::collection::vec(rays::recipe(), RAYS);
    let tried = runner(SCENES).run(&(scenes::facets(), questions), |(scene, questions)| {
        compare(&scene, &questions, &facets(&scene.shapes), &seen)
    });
    finish(tried.map_err(|error| error.to_string()), &seen);
}

#[test]
fn every_structure_of_any_shapes_agrees_with_the_list() {
    let seen = Seen::default();
    let questions = prop::collection::vec(rays::recipe(), RAYS);
    let tried = runner(SCENES).run(&(scenes::things(), questions), |(scene, questions)| {
        compare(&scene, &questions, &things(&scene.shapes), &seen)
    });
    finish(tried.map_err(|error| error.to_string()), &seen);
}

#[track_caller]
fn finish(tried: Result<(), String>, seen: &Seen) {
    let (rays, hits) = (seen.rays.get(), seen.hits.get());
    println!("{hits} hits of {rays} rays");
    if let Err(error) = tried {
        panic!("{error}");
    }
    assert!(
        3 * hits >= rays,
        "a third of the rays must hit, or agreement says little: {hits} of {rays}"
    );
}

fn compare<S: Shape + Copy + PartialEq + Debug>(
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

#[test]
fn batches_are_answered_as_their_rays_are() {
    let hits = Cell::new(0);
    let questions = prop::collection::vec(rays::recipe(), 0..RAYS);
    let tried = runner(SCENES).run(&(scenes::facets(), questions), |(scene, questions)| {
        let wide = WideBvh::new(scene.shapes.clone());
        let ahead = |recipe: &RayRecipe| recipe.in_scene(&scene).0;
        let rays: Vec<_> = questions.iter().map(ahead).collect();
        let batch = wide.closest_many(&rays, Interval::AHEAD);
        prop_assert_eq!(batch.len(), rays.len(), "one answer for each ray");
        for (ray, found) in rays.iter().zip(batch) {
            prop_assert_eq!(found, wide.closest(ray, Interval::AHEAD), "{:?}", ray);
            hits.set(hits.get() + u32::from(found.is_some()));
        }
        Ok(())
    });
    assert!(tried.is_ok(), "{}", tried.unwrap_err());
    assert!(hits.get() > 1000, "only {} hits", hits.get());
}

/// The test above would notice: a structure that forgets one shape, and one that returns the last hit and not the nearest.
#[test]
fn wrong_structures_are_found_out() {
    for (wrong, why) in [
        (
            structures::Wrong::ForgetsOne,
            &["a hit is lost", "the distances differ"][..],
        ),
        (structures::Wrong::Last, &["the distances differ"]),
        (
            structures::Wrong::IgnoresTheEnd,
            &["a hit where the list has none", "any and closest differ"],
        ),
    ] {
        let seen = Seen::default();
        let questions = prop::collection::vec(rays::recipe(), RAYS);
        let tried = runner(SCENES).run(&(scenes::facets(), questions), |(scene, questions)| {
            let structure = structures::wrong(wrong, &scene.shapes);
            compare(&scene, &questions, &[("wrong", structure)], &seen)
        });
        let said = tried
            .expect_err("a wrong structure must be found out")
            .to_string();
        assert!(said.contains("wrong: "), "{wrong:?}: {said}");
        assert!(
            why.iter().any(|why| said.contains(why)),
            "{wrong:?} should be told by one of {why:?}: {said}"
        );
    }
}

/// Zeros in the direction make infinite distances; a structure that takes one of them for a hit still answers right, but visits
/// everything.
#[test]
fn rays_along_an_axis_cost_no_more_than_others() {
    let soup = soup::soup(10_000, 2).facets();
    let mut rng = pcg::stream(2, 2);
    let mut place = || Vec3::from_array(std::array::from_fn(|_| rng.random::<f32>()));
    let rays: Vec<_> = (0..300)
        .map(|i| {
            let (from, to) = (place(), place());
            let axis = [Vec3::X, -Vec3::X, Vec3::Y, -Vec3::Y, Vec3::Z, -Vec3::Z][i % 6];
            // −1·Y is (−0, −1, −0): zeros of both signs are among them.
            [axis, to - from].map(|toward| Ray::new(from, Dir3::new_or(toward, Dir3::X)))
        })
        .collect();
    for (name, structure) in facets(&soup) {
        let work = |which: usize| -> u64 {
            let count =
                |rays: &[Ray; 2]| structure.closest_counted(&rays[which], Interval::AHEAD).1;
            rays.iter()
                .map(count)
                .map(|tests| tests.boxes + tests.shapes)
                .sum()
        };
        let [axis, other] = [work(0), work(1)];
        println!("{name:12} {axis:8} along axes, {other:8} otherwise");
        assert!(
            2 * axis < 3 * other,
            "{name}: {axis} boxes and shapes tested for rays along axes, {other} for others"
        );
    }
}
