//! `raybook explain`: the steps end in the golden answers, drawings can be looked at, and a wrong case is told in full.

pub mod command;

use raybook_grader::cases;
use raybook_grader::examine::{Case, Examiner, visible_rng};
use raybook_grader::explain::slip::{Change, Slip};
use raybook_grader::explain::way::{Step, Way};
use raybook_grader::explain::{EXPLAINERS, Explainer, Shown};
use raybook_grader::layout::layout;
use raybook_workbook::curriculum::{CHAPTERS, Chapter};
use std::sync::LazyLock;

/// An exercise with steps, and its visible cases.
type Explained = (&'static Explainer, &'static dyn Examiner, Vec<Case>);

/// All of them: the cases take a while to make.
static EXPLAINED: LazyLock<Vec<Explained>> = LazyLock::new(|| {
    let with_cases = |explainer: &'static Explainer| {
        let examiner = cases::find(explainer.exercise).expect("it is an exercise");
        let cases = examiner.cases(&mut visible_rng(examiner.name())).cases;
        (explainer, examiner, cases)
    };
    EXPLAINERS.iter().map(with_cases).collect()
});

/// The steps and the answer on the way of this number.
fn worked(explainer: &Explainer, number: usize, question: &[f64]) -> (Vec<Step>, Vec<f64>) {
    let mut way = Way::default();
    let answer = (explainer.work)(number, question, &mut way);
    (way.end().steps, answer)
}

/// An exercise that is added may have none yet.
#[test]
fn the_exercises_of_the_course_have_steps() {
    let exercises = CHAPTERS.iter().flat_map(Chapter::exercises);
    let explained: Vec<_> = EXPLAINERS.iter().map(|e| e.exercise).collect();
    assert!(explained.len() >= 64, "those that the course began with");
    let exercises: Vec<_> = exercises
        .map(|exercise| exercise.name)
        .filter(|name| explained.contains(name))
        .collect();
    assert_eq!(explained, exercises, "in the order of the course");
}

#[test]
fn steps_end_in_the_golden_answers() {
    let mut asked = 0;
    for (explainer, examiner, cases) in &*EXPLAINED {
        for case in cases {
            let question = examiner.asked().read_question(&case.question);
            let question = question.expect("it is a question");
            for number in 0..explainer.ways {
                let (steps, answer) = worked(explainer, number, &question);
                assert!(
                    number > 0 || !steps.is_empty(),
                    "{}: there are steps",
                    explainer.exercise
                );
                let golden =
                    |line: &String| examiner.asked().read_answer(line).expect("it is an answer");
                let verdicts = case.answers.iter();
                let verdicts: Vec<_> = verdicts
                    .map(|line| examiner.compare(&question, &golden(line), &answer))
                    .collect();
                assert!(
                    verdicts.contains(&Ok(())),
                    "{}, {}, by way {number}: {verdicts:?}, by {steps:#?}",
                    explainer.exercise,
                    case.name
                );
            }
            asked += 1;
        }
    }
    assert!(asked > 2000, "the test must see the cases; it saw {asked}");
}

/// What is told is what is calculated with: each number of an answer stands among its steps, or was given.
#[test]
fn the_answer_stands_among_the_steps() {
    for (explainer, examiner, cases) in &*EXPLAINED {
        for case in cases {
            let question = examiner.asked().read_question(&case.question);
            let question = question.expect("it is a question");
            let (steps, answer) = worked(explainer, 0, &question);
            let layout = layout(examiner.asked().answer.kind, &answer);
            if !layout.lists.is_empty() {
                continue; // of a list the first element is told
            }
            let told: Vec<f64> = steps.iter().flat_map(|step| step.value.clone()).collect();
            for leaf in &layout.leaves {
                for v in &answer[leaf.range()] {
                    let same =
                        |told: &f64| told == v || (told - v).abs() <= 1e-6 * v.abs().max(1e-6);
                    assert!(
                        told.iter().any(same) || question.iter().any(same) || is_certain(*v),
                        "{}, {}: {v} is told",
                        explainer.exercise,
                        case.name
                    );
                }
            }
        }
    }
}

/// What is told is what is calculated with: another value at a step, or another decision, leads to another answer in some case.
#[test]
fn every_step_matters() {
    let mut idle = Vec::new();
    let mut tried = 0;
    // Of yes and no, and of how much of a light is seen, a step moves few answers.
    let coarse = ["lit", "visible_fraction"];
    let fine = EXPLAINED.iter();
    let fine = fine.filter(|(explainer, ..)| !coarse.contains(&explainer.exercise));
    for (explainer, examiner, cases) in fine {
        let questions = cases.iter().take(28);
        let questions: Vec<_> = questions
            .map(|case| examiner.asked().read_question(&case.question))
            .map(|question| question.expect("it is a question"))
            .collect();
        for number in 0..explainer.ways {
            let mut slips: Vec<(String, Slip)> = Vec::new();
            let mut seen = Vec::new();
            // Later questions show whether these steps matter, and have steps of their own.
            for question in questions.iter().take(24) {
                let mut way = Way::default();
                (explainer.work)(number, question, &mut way);
                let walked = way.end();
                for step in walked.steps.into_iter().chain(walked.untold) {
                    if !step.value.is_empty() && !seen.contains(&step.place) {
                        seen.push(step.place);
                        let other = Change::Each(|v| 0.3 - 0.7 * v);
                        slips.push((step.name.into_owned(), Slip::Value(step.place, other)));
                    }
                }
                for decision in walked.met.decisions {
                    if !seen.contains(&decision.place) {
                        seen.push(decision.place);
                        let other = Slip::Decision(decision.place, |holds| !holds);
                        slips.push((decision.name.to_owned(), other));
                    }
                }
            }
            for (name, slip) in slips {
                let changes = |question: &Vec<f64>| {
                    let right = (explainer.work)(number, question, &mut Way::default());
                    let other = || (explainer.work)(number, question, &mut Way::with(slip));
                    std::panic::catch_unwind(other).is_ok_and(|other| other != right)
                };
                tried += 1;
                let step = format!("{}: {name}", explainer.exercise);
                // Several ways may have the same step.
                if !questions.iter().any(changes) && !idle.contains(&step) {
                    idle.push(step);
                }
            }
        }
    }
    assert!(tried > 800, "{tried} steps and decisions");
    assert_eq!(idle, ONLY_TOLD);
}

#[test]
fn a_way_with_a_slip_is_given_up_where_it_gets_too_long() {
    let (explainer, examiner, cases) = &EXPLAINED[0];
    let question = examiner.asked().read_question(&cases[0].question);
    let question = question.expect("it is a question");
    let mut right = Way::default();
    (explainer.work)(0, &question, &mut right);
    let right = right.end();
    let slip = Slip::Value(right.steps[0].place, Change::Each(|v| 2.0 * v));
    let ends = |most: usize| {
        let mut way = Way::with(slip).no_longer_than(most);
        std::panic::catch_unwind(move || (explainer.work)(0, &question.clone(), &mut way)).is_ok()
    };
    assert!(ends.clone()(right.length));
    assert!(!ends(right.length - 1));
}

/// Steps that tell more than what is calculated with, or that only a mistake calculates with; and of a triangle's hit what a search has no use for.
const ONLY_TOLD: &[&str] = &[
    "sphere_hit: s = (c − o)·d/(d·d), where the ray is nearest to the centre",
    "vertex_normals: the length of e₁",
    "vertex_normals: the length of e₂",
    "vertex_normals: the length of the third edge",
    "mesh_hit: b₁, returned",
    "mesh_hit: b₂, returned",
    "voxels_of_triangle: the first cell that it can be in",
    "voxels_of_triangle: cells that the triangle meets",
    "voxels_of_triangle: the margin around the triangle's box",
    "grid_walk: apart: the distance between two planes, along each axis",
    "refine_cell: pairs of a fine cell and a shape that reaches it",
    "two_level_walk: apart: the distance between two planes, along each axis",
    "two_level_walk: the coarse cells along z",
    "two_level_walk: nz",
    "octree_walk: node 0, opened: the ray enters and leaves its cell at t =",
    "octree_walk: half of a cell's extents",
    "octree_walk: the number of shapes of an empty leaf",
    "sah_cost: x · y · z, the volume",
    "bvh_build: node 0: its number of boxes",
    "bvh_closest: b₁, returned",
    "bvh_closest: b₂, returned",
    "geodesic_step: h = |x × v|, which does not change",
    "geodesic_step: |x|",
    "geodesic_step: x + step·v, straight on",
    "regular_grid: columns · rows: the number of points",
    "rotated_grid: (offset.x, offset.y), of i = j = 0",
    "rotated_grid: that, rotated",
    "rotated_grid: (½, ½) + spacing times that",
    "rotated_grid: of all of them in the square",
    "random_pattern: n: the number of points",
    "jittered: columns · rows: a point in each cell",
    "poisson_disk: the least distance that is allowed",
    "poisson_disk: points",
    "poisson_disk: the area of the discs around them whose radius is half the distance",
    "poisson_disk: the least distance of two of them",
    "spend_budget: Σ σ",
    "spend_budget: pixel 0: its share of the budget, and its number of samples",
    "collapse: its children",
    "collapse: node 2 is its largest branch, and gives way to its children: its area",
    "collapse: x · y · z, the volume",
    "wide_closest: b₁, returned",
    "wide_closest: b₂, returned",
];

/// What a remark says in words: nothing or all, a number of a list, or no end.
fn is_certain(v: f64) -> bool {
    v.is_infinite() || v.fract() == 0.0
}

/// The exercises with a drawing.
const DRAWN: [&str; 41] = [
    "ray_at",
    "camera_ray",
    "sphere_hit",
    "sphere_normal",
    "plane_hit",
    "box_clip",
    "triangle_hit",
    "grid_walk",
    "refine_cell",
    "two_level_walk",
    "octree_child",
    "octree_build",
    "octree_walk",
    "sah_cost",
    "sah_split",
    "bvh_build",
    "bvh_closest",
    "phong",
    "blinn_phong",
    "reflect",
    "refract",
    "shadow_ray",
    "cosine_hemisphere",
    "reflected_radiance",
    "direction_to_cube",
    "direction_to_latlong",
    "sample_environment",
    "environment_pdf",
    "thin_lens_ray",
    "geodesic_step",
    "deflection_angle",
    "regular_grid",
    "rotated_grid",
    "random_pattern",
    "jittered",
    "poisson_disk",
    "pixel_average",
    "spend_budget",
    "collapse",
    "wide_closest",
    "trace",
];

/// Of an exercise's first cases with the right answer, with none, and with the answers of every fourth mistake, in each case of others: a file
/// that a browser reads, with a title, and nothing outside of the picture.
#[test]
fn drawings_can_be_looked_at() {
    /// The named cases, and a few random ones.
    const CASES: usize = 16;
    let mut drawn = Vec::new();
    for (explainer, examiner, cases) in &*EXPLAINED {
        let asked = examiner.asked();
        for (number, case) in cases.iter().take(CASES).enumerate() {
            let question = asked.read_question(&case.question).expect("a question");
            let right = asked.read_answer(&case.answers[0]).expect("an answer");
            let some = (number % 4..examiner.mistakes().len()).step_by(4);
            let mistakes = some.filter_map(|i| examiner.mistake_answers(i, &question));
            let yours = mistakes.map(Some).chain([Some(right.clone()), None]);
            for yours in yours {
                let (question, right, yours) = (&question[..], &right[..], yours.as_deref());
                let shown = Shown {
                    question,
                    right,
                    yours,
                };
                let Some(diagram) = (explainer.draw)(shown) else {
                    continue;
                };
                let svg = diagram.svg();
                let what = || format!("{}, {}: {svg}", explainer.exercise, case.name);
                let page = roxmltree::Document::parse(&svg).expect("it is XML");
                let root = page.root_element();
                assert_eq!(root.attribute("role"), Some("img"), "{}", what());
                assert!(
                    !svg.contains("NaN") && !svg.contains("=\"inf"),
                    "{}",
                    what()
                );
                let width: f64 = root
                    .attribute("width")
                    .and_then(|w| w.parse().ok())
                    .expect("a width");
                for text in page.descendants().filter(|node| node.has_tag_name("text")) {
                    let x: f64 = text
                        .attribute("x")
                        .and_then(|x| x.parse().ok())
                        .expect("a place");
                    assert!((0.0..=width).contains(&x), "{}", what());
                }
                drawn.push(explainer.exercise);
            }
        }
    }
    drawn.dedup();
    assert_eq!(drawn, DRAWN);
}
