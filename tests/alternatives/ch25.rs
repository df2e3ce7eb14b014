//! Chapter 25: whole ray tracers, in f64.

#[path = "ch25/forms.rs"]
mod forms;
#[path = "ch25/scene.rs"]
mod scene;
#[path = "ch25/tracer.rs"]
mod tracer;

use crate::student::{Alternative, Question, STYLES, line};
use raybook::grade::cases;
use raybook::grade::picture::{pixel_questions, triples};
use scene::Scene;
use tracer::Tracer;

pub const ALTERNATIVES: &[Alternative] = &[
    Alternative {
        exercise: "trace",
        method: "recursive, new rays start 1e-4 off the surface",
        answer: |q| answer(q, |scene| recursive(scene, 1e-4)),
    },
    Alternative {
        exercise: "trace",
        method: "recursive, new rays start 1e-3 off the surface",
        answer: |q| answer(q, |scene| recursive(scene, 1e-3)),
    },
    Alternative {
        exercise: "trace",
        method: "recursive, the ray normalised again, new rays start 1e-9 off the surface",
        answer: |q| {
            let depth = q.whole();
            let (o, d) = (q.vector(), q.vector().normalize());
            let tracer = recursive(Scene::read(q), 1e-9);
            Some(tracer.radiance(o, d, depth).to_array().into())
        },
    },
    Alternative {
        exercise: "trace",
        method: "with a stack of rays in the place of recursion",
        answer: |q| {
            answer(q, |scene| Tracer {
                stack: true,
                ..recursive(scene, 1e-5)
            })
        },
    },
    Alternative {
        exercise: "trace",
        method: "leaves out rays that count for less than 1/512",
        answer: |q| {
            answer(q, |scene| Tracer {
                least: 1.0 / 512.0,
                ..recursive(scene, 1e-5)
            })
        },
    },
    Alternative {
        exercise: "trace",
        method: "other formulas: geometric spheres, triangles by their edges, reflection and Fresnel by angles",
        answer: |q| {
            answer(q, |scene| Tracer {
                other: true,
                ..recursive(scene, 1e-5)
            })
        },
    },
];

fn recursive(scene: Scene, off: f64) -> Tracer {
    Tracer {
        scene,
        off,
        least: 0.0,
        stack: false,
        other: false,
    }
}

fn answer(q: &mut Question, tracer: fn(Scene) -> Tracer) -> Option<Vec<f64>> {
    let depth = q.whole();
    let (o, d) = (q.vector(), q.vector());
    let tracer = tracer(Scene::read(q));
    Some(tracer.radiance(o, d, depth).to_array().into())
}

#[test]
fn all_four_pictures_are_right_by_every_method() {
    let trace = cases::find("trace").expect("it is an exercise");
    let questions = pixel_questions(trace);
    for other in ALTERNATIVES {
        let answers: Vec<_> = questions
            .iter()
            .map(|question| Some(line(&other.answer_to(question), STYLES[0].1)))
            .collect();
        let pictures = triples(trace, &answers);
        assert_eq!(pictures.len(), 4, "there are four scenes");
        for picture in pictures {
            println!("{:20} {:?}", picture.name, picture.score);
            assert_eq!(
                picture.score.wrong(),
                0,
                "{}, {}: {:?}",
                other.method,
                picture.name,
                picture.first_bad
            );
            assert!(
                picture.score.undecided < 60,
                "{}, {}: {:?}",
                other.method,
                picture.name,
                picture.score
            );
            assert!(
                picture.score.passed(),
                "{}, {}: {:?}",
                other.method,
                picture.name,
                picture.score
            );
        }
    }
}

#[test]
fn zz_measure() {
    use raybook::grade::examine::visible_rng;
    use raybook::math::pcg;
    let trace = cases::find("trace").expect("it is an exercise");
    let set = trace.cases(&mut visible_rng("trace"));
    println!("thrown away {}", set.thrown_away_fraction());
    for (i, (name, _)) in trace.mistakes().into_iter().enumerate() {
        let wrong: Vec<_> = set
            .cases
            .iter()
            .map(|c| {
                trace
                    .judge(
                        &c.question,
                        &c.answers,
                        &trace.mistaken(i, &c.question).unwrap(),
                    )
                    .is_err()
            })
            .collect();
        let edges = wrong.len() - 34;
        println!(
            "{name:60} edges {:2} random {:2}",
            wrong[..edges].iter().filter(|w| **w).count(),
            wrong[edges..].iter().filter(|w| **w).count()
        );
    }
    let mut worst = vec![Vec::new(); ALTERNATIVES.len()];
    for seed in 0..60 {
        let set = trace.cases(&mut pcg::stream(seed, 99));
        for case in set.cases {
            if seed > 0 && !case.name.starts_with("random") {
                continue;
            }
            for (j, other) in ALTERNATIVES.iter().enumerate() {
                let got = other.answer_to(&case.question).unwrap();
                let gold: Vec<f64> = case.answers[0]
                    .split(' ')
                    .map(|w| w.parse().unwrap())
                    .collect();
                let e = gold
                    .iter()
                    .zip(&got)
                    .map(|(g, v)| (g - v).abs() / (0.5 + g.abs()))
                    .fold(0.0, f64::max);
                worst[j].push((e, case.name.clone(), case.question.clone()));
            }
        }
    }
    for (j, w) in worst.iter_mut().enumerate() {
        w.sort_by(|a, b| b.0.total_cmp(&a.0));
        println!(
            "{}: n {} worst {:?} 99.9% {:.5} median {:e}",
            ALTERNATIVES[j].method,
            w.len(),
            w[..5].iter().map(|x| (x.0, &x.1)).collect::<Vec<_>>(),
            w[w.len() / 1000].0,
            w[w.len() / 2].0
        );
        println!("   {}", w[0].2);
    }
}
