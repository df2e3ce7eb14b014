//! How steps grow with a scene.

use raybook::math::pcg;
use raybook_grader::cases;
use raybook_grader::inside::cost::{Over, SEARCHES, SIZES, exponent, ray, scene};
use raybook_grader::report::cost::Cost;

/// Rays through each scene.
const RAYS: usize = 12;

#[test]
fn the_references_steps_grow_more_slowly_than_the_scene() {
    for search in &SEARCHES {
        let asked = cases::find(search.exercise).expect("an exercise").asked();
        let mut rng = pcg::stream(17, 0);
        let mean = |size| {
            let Over { question, steps } = (search.over)(&scene(size, &mut rng));
            let rays = (0..RAYS).map(|_| ray(&mut rng));
            let steps = rays.map(|ray| steps(ray, &(asked.call)(&question(ray))));
            steps.sum::<f64>() / RAYS as f64
        };
        let steps = SIZES.map(mean);
        let power = exponent(&steps);
        assert!(
            (0.0..0.8).contains(&power) && steps[0] >= 1.0,
            "{}: {steps:?} grow like N^{power}",
            search.exercise
        );
    }
}

#[test]
fn the_exponent_is_that_of_a_power() {
    for a in [0.0, 0.5, 1.0] {
        let steps: Vec<_> = SIZES
            .iter()
            .map(|size| 7.0 * f64::from(*size).powf(a))
            .collect();
        assert!((exponent(&steps) - a).abs() < 1e-9, "N^{a}");
    }
    let [linear, half] = [1.0, 0.5].map(|a| SIZES.iter().map(|n| f64::from(*n).powf(a)).collect());
    let cost = Cost {
        exercise: "bvh_closest",
        step: "a box",
        yours: linear,
        reference: half,
    };
    assert!(
        cost.words()
            .contains("grow like N^1.00, the reference's like N^0.50")
    );
    assert!(cost.plot().svg().contains("linear search"));
}
