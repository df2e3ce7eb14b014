//! Every accelerator answers as the list does, whatever it is given; and none lets the counting change an answer.

mod compare;
mod rays;
mod scenes;
mod structures;

use compare::{Seen, compare};
use glam::Vec3;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestRunner};
use rand::RngExt;
use raybook::accel::{Accel, wide_bvh::WideBvh};
use raybook::inside::wide_bvh::in_turns;
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::scene::soup;
use rays::RayRecipe;
use std::cell::Cell;
use structures::{facets, things};

/// Scenes; each is built into every structure, and looked at by [`RAYS`] rays.
const SCENES: u32 = 400;
const RAYS: usize = 48;

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

#[test]
fn batches_are_answered_as_their_rays_are() {
    let hits = Cell::new(0);
    let questions = prop::collection::vec(rays::recipe(), 0..RAYS);
    let tried = runner(SCENES).run(&(scenes::facets(), questions), |(scene, questions)| {
        let wide = WideBvh::new(scene.shapes.clone());
        let ahead = |recipe: &RayRecipe| recipe.in_scene(&scene).0;
        let rays: Vec<_> = questions.iter().map(ahead).collect();
        let batch = in_turns(&wide, &rays, Interval::AHEAD);
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
