//! Chapter 23: when a pixel needs more samples, and how a budget is spent.

use glam::Vec2;
use proptest::prelude::*;
use rand::Rng;
use raybook::image::rgb::Rgb;
use raybook::render::adaptive::{Limits, adaptive, by_budget};
use raybook::render::budget::spend_budget;
use raybook::render::film::Film;
use raybook::render::needs_more::StoppingRule;
use raybook::render::supersample::supersample;
use raybook::sample::pattern::find;
use raybook_chapters::ch23_adaptive::adaptive_gain::{outcome, rms};
use raybook_chapters::lab::error_plot::{Curve, ErrorPlot};
use raybook_chapters::lab::errors::Error;
use raybook_chapters::lab::pens::pen;

const LIMITS: Limits = Limits { first: 4, most: 64 };

fn film(samples: usize, threads: usize) -> Film<'static> {
    Film {
        seed: 5,
        threads,
        ..Film::new(48, 32, samples)
    }
}

/// White to the left of a slanted edge, dark grey to the right.
fn edge(place: Vec2, _: &mut dyn Rng) -> Rgb {
    Rgb::gray(if place.x + 0.3 * place.y < 0.6 {
        1.0
    } else {
        0.1
    })
}

#[test]
fn like_samples_are_enough_and_unlike_ones_are_not() {
    let rule = StoppingRule::BY_CONTRAST;
    assert!(!rule.needs_more(&[Rgb::BLACK; 4]), "0/0 is no contrast");
    assert!(!rule.needs_more(&[Rgb::gray(0.5); 2]), "all the same");
    assert!(rule.needs_more(&[Rgb::gray(0.5)]), "one knows nothing");
    assert!(rule.needs_more(&[]), "none knows less");
    assert!(
        rule.needs_more(&[Rgb::gray(0.01), Rgb::gray(0.02)]),
        "a third of contrast"
    );
    let blue = [Rgb::new(0.1, 0.1, 0.1), Rgb::new(0.1, 0.1, 0.38)];
    assert!(!rule.needs_more(&blue), "0.58 of blue is allowed");
    let variance = StoppingRule::by_variance(0.1);
    let noisy = [0.0, 1.0].map(Rgb::gray);
    assert!(variance.needs_more(&noisy.repeat(2)), "0.29 of 4 samples");
    assert!(
        !variance.needs_more(&noisy.repeat(20)),
        "0.08 of 40 samples"
    );
}

#[test]
fn edges_get_the_samples_and_walls_get_the_least() {
    let done = adaptive(&film(1, 2), LIMITS, &StoppingRule::BY_CONTRAST, edge);
    for y in 0..32 {
        for x in 0..48 {
            let corners = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| {
                let p = Vec2::new((x + i) as f32 / 48.0, (y + j) as f32 / 32.0);
                p.x + 0.3 * p.y < 0.6
            });
            let crossed = corners.iter().any(|c| *c != corners[0]);
            let spent = done.spent.at(x, y).g as usize;
            assert!(
                spent == 4 || (spent == 64 && crossed),
                "({x}, {y}): {spent} samples, crossed: {crossed}"
            );
        }
    }
    assert!(
        done.mean() > 4.5 && done.mean() < 12.0,
        "{} in the mean",
        done.mean()
    );
}

#[test]
fn the_same_error_costs_fewer_rays() {
    let sobol = find("sobol-owen").expect("it is there");
    let exact = supersample(&film(1024, 2), sobol, edge);
    let budget = by_budget(&film(1, 2), 4, 8, edge);
    assert!(
        (budget.mean() - 8.0).abs() < 1e-6,
        "{} are spent of 8",
        budget.mean()
    );
    let [eight, sixteen] = [8, 16].map(|n| rms(&supersample(&film(n, 2), sobol, edge), &exact));
    let adaptive = rms(&budget.picture, &exact);
    assert!(
        adaptive < 0.7 * sixteen && sixteen < eight,
        "{adaptive} for 8 rays by a budget, {sixteen} for 16 everywhere, {eight} for 8"
    );
}

#[test]
fn one_thread_and_three_make_the_same_picture() {
    let noisy = |place: Vec2, rng: &mut dyn Rng| {
        use rand::RngExt;
        edge(place, rng) * (0.9 + 0.2 * rng.random::<f32>())
    };
    let of = |threads| {
        let rule = StoppingRule::by_variance(0.01);
        let one = adaptive(&film(1, threads), LIMITS, &rule, noisy);
        let other = by_budget(&film(1, threads), 4, 9, noisy);
        [one.picture, one.spent, other.picture, other.spent]
    };
    for (one, three) in of(1).iter().zip(of(3)) {
        assert!(one.same_bits(&three), "bit for bit");
    }
}

#[test]
fn a_budget_follows_the_deviation() {
    assert_eq!(
        spend_budget(&[1.0, 2.0], 1, 30),
        [10, 20],
        "twice the deviation, twice the samples"
    );
    assert_eq!(
        spend_budget(&[0.0, 1.0], 4, 30),
        [4, 26],
        "a quiet pixel has the least"
    );
    assert_eq!(
        spend_budget(&[1.0, 1.0, 1.0], 5, 3),
        [5, 5, 5],
        "the least it is"
    );
    assert!(spend_budget(&[], 3, 10).is_empty(), "no pixel");
    let total: u32 = spend_budget(&[f32::NAN, 1.0, f32::INFINITY], 1, 30)
        .iter()
        .sum();
    assert_eq!(total, 30, "what is no number panics nobody");
}

/// Σ σ²/n.
fn variance(deviations: &[f32], counts: &[u32]) -> f64 {
    let each = deviations.iter().zip(counts);
    each.map(|(d, n)| f64::from(*d).powi(2) / f64::from(*n))
        .sum()
}

proptest! {
    #[test]
    fn no_sample_would_do_better_elsewhere(
        deviations in prop::collection::vec(0.0_f32..1.0, 2..8),
        least in 1_u32..5,
        more in 0_u32..60,
    ) {
        let budget = least * deviations.len() as u32 + more;
        let counts = spend_budget(&deviations, least, budget);
        prop_assert_eq!(counts.iter().sum::<u32>(), budget, "all of it is spent");
        prop_assert!(counts.iter().all(|n| *n >= least), "each has the least");
        let best = variance(&deviations, &counts);
        for from in 0..counts.len() {
            for to in 0..counts.len() {
                let mut moved = counts.clone();
                if from == to || moved[from] == least {
                    continue;
                }
                moved[from] -= 1;
                moved[to] += 1;
                let other = variance(&deviations, &moved);
                prop_assert!(other >= best * (1.0 - 1e-6), "moving one from {from} to {to}: {other} for {best}");
            }
        }
    }
}

#[test]
fn the_outcome_is_read_off_the_curves() {
    let curve = |points: [(usize, f64); 2]| Curve {
        key: String::new(),
        title: String::new(),
        pen: pen(0),
        errors: points.map(|(n, error)| Error::exactly(n, error)).to_vec(),
    };
    let plot = ErrorPlot {
        title: String::new(),
        // The errors are 1/n, 0.5/n, and the same 1/8 for any n.
        curves: vec![
            curve([(4, 0.25), (32, 0.03125)]),
            curve([(4, 0.125), (32, 0.015_625)]),
            curve([(4, 0.125), (32, 0.125)]),
        ],
    };
    assert_eq!(
        outcome(&plot),
        "With a budget, 50 % of the rays give the error of 16 rays everywhere. From 8 rays on, the rule by contrast has a \
         larger error than the same number of rays everywhere."
    );
}
