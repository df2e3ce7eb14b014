//! Chapter 25: whole ray tracers, in f64.

mod forms;
mod scene;
mod tracer;

use crate::alternatives::student::{Alternative, Question, STYLES, line};
use raybook_grader::cases;
use raybook_grader::picture::ask::{pixel_questions, triples};
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
            let what = format!("{}, {}: {:?}", other.method, picture.name, picture.score);
            println!("{what}");
            // A start 1 mm off moves shadows' rims: of 13 824 pixels a few change sides and are not found out.
            let wrong = picture.score.wrong();
            assert!(wrong <= 2, "{what}: {:?}", picture.first_bad);
            assert!(picture.score.undecided < 60, "{what}");
            assert!(picture.score.passed(), "{what}");
        }
    }
}
