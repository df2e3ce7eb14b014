//! A mistake in doubt is put on trial: further answers tell it for certain, or leave it in doubt.

use glam::DVec3;
use rand::RngExt;
use raybook::math::pcg;
use raybook_grader::cases;
use raybook_grader::diagnose::ties::beside;
use raybook_grader::diagnose::trial::Trial;
use raybook_grader::diagnose::{Beside, Diagnosis, diagnose};
use raybook_grader::examine::{Case, Examiner, visible_rng};
use raybook_workbook::row;
use std::f64::consts::TAU;

/// What is told of one who answers these cases so, after a trial if it is in doubt. An answer comes with whether it is right.
pub fn tried(
    examiner: &dyn Examiner,
    cases: &[Case],
    answer: impl Fn(&Case) -> (Option<String>, bool),
) -> Option<Diagnosis> {
    let mut answers: Vec<_> = cases.iter().map(&answer).collect();
    let told = diagnose(examiner, cases, &answers)?;
    let verdict = Trial::new(examiner, cases, &answers, &told).and_then(|trial| {
        answers.extend(trial.cases.iter().map(&answer));
        trial.verdict(&[cases, &trial.cases].concat(), &answers)
    });
    Some(verdict.unwrap_or(told))
}

/// The exercise, its visible cases, and the number of the mistake that is called so.
fn mistake(exercise: &str, name: &str) -> (&'static dyn Examiner, Vec<Case>, usize) {
    let examiner = cases::find(exercise).expect("the exercise exists");
    let cases = examiner.cases(&mut visible_rng(exercise)).cases;
    let number = examiner.mistakes().iter().position(|one| one.0 == name);
    (examiner, cases, number.expect("the mistake exists"))
}

/// An answer in words, and whether it is right.
fn judged(examiner: &dyn Examiner, case: &Case, answer: String) -> (Option<String>, bool) {
    let verdict = examiner.judge(&case.question, &case.answers, &answer);
    (Some(answer), verdict.is_ok())
}

#[test]
fn a_question_beside_another_differs_in_its_last_digits_whatever_its_seed() {
    let rng = &mut pcg::stream(1, 0);
    let examiner = cases::find("poisson_disk").expect("an exercise");
    let question = [0.125, 4e9]; // the distance, and the seed
    for _ in 0..100 {
        let moved = beside(examiner, &question, 1.0, rng);
        assert!((moved[0] - 0.125).abs() < 1e-6, "{moved:?}");
        assert_eq!(moved[1], 4e9);
    }
}

/// Yes or no in a few cases is explained by many mistakes.
const SHADOW: &str = "steps to the normal's side, wherever the light is";

#[test]
fn a_mistake_that_few_answers_show_is_certain_after_its_trial() {
    let (examiner, cases, number) = mistake("lit", SHADOW);
    let answer = |case: &Case| {
        let answer = examiner
            .mistaken(number, &case.question)
            .expect("an answer");
        judged(examiner, case, answer)
    };
    let answers: Vec<_> = cases.iter().map(answer).collect();
    let before = diagnose(examiner, &cases, &answers).expect("it has a name");
    let after = tried(examiner, &cases, answer).expect("it has a name");
    assert_eq!([&*before.name, &*after.name], [SHADOW; 2]);
    assert_eq!([before.certain, after.certain], [false, true]);
    assert_eq!(before.explained, after.explained);
    assert!(after.further >= 8, "{after:?}");
}

#[test]
fn who_errs_like_a_mistake_in_the_cases_only_is_not_convicted_of_it() {
    let (examiner, cases, number) = mistake("lit", SHADOW);
    let after = tried(examiner, &cases, |case| {
        let wrong = examiner
            .mistaken(number, &case.question)
            .expect("an answer");
        let is_known = cases.iter().any(|known| known.question == case.question);
        let answer = if is_known {
            wrong
        } else {
            case.answers[0].clone()
        };
        judged(examiner, case, answer)
    });
    let after = after.expect("it has a name");
    assert_eq!((&*after.name, after.certain), (SHADOW, false));
}

#[test]
fn two_mistakes_in_the_same_answers_are_both_certain() {
    let first = "forgets the diffuse term's cosine";
    let second = "has a highlight on the far side too";
    let (examiner, cases, number) = mistake("phong", first);
    let (.., other) = mistake("phong", second);
    let asked = examiner.asked();
    let after = tried(examiner, &cases, |case| {
        let question = asked.read_question(&case.question).expect("a question");
        let right = (asked.call)(&question);
        let alone = [number, other].map(|i| examiner.mistake_answers(i, &question));
        let [one, two] = alone.map(|answer| answer.expect("an answer"));
        // Each is in a summand of its own.
        let both = right.iter().zip(one.iter().zip(&two));
        let both: Vec<_> = both.map(|(right, (one, two))| one + two - right).collect();
        judged(examiner, case, row::format(asked.answer.kind, &both))
    });
    let after = after.expect("they have names");
    let [also] = &after.also[..] else {
        panic!("one beside the other: {after:?}");
    };
    let mut names = [&*after.name, &*also.name];
    names.sort_unstable();
    assert_eq!(names, [first, second]);
    assert_eq!(also.beside, Beside::Together);
    assert!(after.certain && also.certain, "{after:?}");
}

#[test]
fn two_in_a_structure_are_both_certain_where_one_nearly_explains_all() {
    let pairs = [
        (
            "bvh_closest",
            [
                "counts only the triangles that are hit",
                "opens the first child first, whichever is nearer",
            ],
        ),
        (
            "octree_build",
            [
                "stops one level before the depth allows",
                "expects a ray to meet each child with probability 1/8, not 1/4",
            ],
        ),
        (
            "sah_split",
            [
                "does not multiply by the number of shapes",
                "sorts by the least corners",
            ],
        ),
    ];
    for (exercise, mut both) in pairs {
        let (examiner, cases, first) = mistake(exercise, both[0]);
        let (.., second) = mistake(exercise, both[1]);
        let asked = examiner.asked();
        let after = tried(examiner, &cases, |case| {
            let question = asked.read_question(&case.question).expect("a question");
            let answer = examiner.mistakes_answer(first, second, &question);
            let (answer, _) = answer.expect("one is made upon the other");
            judged(examiner, case, row::format(asked.answer.kind, &answer))
        });
        let after = after.expect("they have names");
        let mut also = after.also.iter();
        let also = also.find(|also| also.beside == Beside::Together);
        let also = also.unwrap_or_else(|| panic!("one beside the other: {after:?}"));
        let mut names = [&*after.name, &*also.name];
        names.sort_unstable();
        both.sort_unstable();
        assert_eq!(names, both, "{exercise}");
        assert!(after.certain && also.certain, "{after:?}");
    }
}

#[test]
fn a_step_that_goes_wrong_beside_a_mistake_is_certain_with_it() {
    let own = "lets the highlight shine through from behind";
    let (examiner, cases, _) = mistake("phong", own);
    let asked = examiner.asked();
    let after = tried(examiner, &cases, |case| {
        let q = asked.read_question(&case.question).expect("a question");
        let [normal, view, light, arriving, diffuse, specular] =
            [0, 3, 6, 9, 12, 15].map(|from| DVec3::from_slice(&q[from..]));
        let [normal, view, light] = [normal, view, light].map(DVec3::normalize); // a program gets unit vectors
        let height = normal.dot(light);
        let mirrored = 2.0 * height * normal - light;
        let highlight = mirrored.dot(view).max(0.0).powf(q[18]);
        let sum = diffuse * height.max(0.0) / TAU + specular * highlight;
        let DVec3 { x, y, z } = sum * arriving;
        judged(examiner, case, format!("{x} {y} {z}"))
    });
    let after = after.expect("they have names");
    let step = "goes wrong at the step “diffuse: k_d (L·N)”: takes the value divided by 2π";
    let [also] = &after.also[..] else {
        panic!("one beside the other: {after:?}");
    };
    assert_eq!([&*after.name, &*also.name], [step, own]);
    assert!(after.certain && also.certain, "{after:?}");
}

#[test]
fn who_draws_other_random_numbers_is_told_by_what_chance_leaves() {
    let (examiner, cases, _) =
        mistake("random_pattern", "takes the root of its numbers for x only");
    let after = tried(examiner, &cases, |case| {
        let asked = examiner.asked();
        let q = asked.read_question(&case.question).expect("a question");
        let rng = &mut pcg::stream(2026, q[1] as u64);
        let mut answer = vec![q[0]];
        for _ in 0..q[0] as usize {
            let [x, y] = [(); 2].map(|()| rng.random::<f64>());
            answer.extend([x.sqrt(), y]);
        }
        judged(examiner, case, row::format(asked.answer.kind, &answer))
    });
    let after = after.expect("it has a name");
    assert_eq!(after.name, "takes the root of its numbers for x only");
    assert!(after.certain, "{after:?}");
}

/// Of a limit that is far too small, yes and no tell nothing but that, and so do they of many a mistake.
#[test]
fn a_guess_that_is_one_of_many_stays_one() {
    let (examiner, cases, _) = mistake("needs_more", "divides the difference by the mean");
    let asked = examiner.asked();
    let after = tried(examiner, &cases, |case| {
        let mut question = asked.read_question(&case.question).expect("a question");
        question[0] *= 1e-4;
        let answer = (asked.call)(&question);
        judged(examiner, case, row::format(asked.answer.kind, &answer))
    });
    assert!(after.is_none_or(|after| !after.certain));
}

#[test]
fn estimates_that_are_twice_too_large_on_average_only_are_not_convicted_of_it() {
    let examiner = cases::find("reflected_radiance").expect("the exercise exists");
    let cases = examiner.cases(&mut visible_rng("reflected_radiance")).cases;
    let asked = examiner.asked();
    let after = tried(examiner, &cases, |case| {
        let q = asked.read_question(&case.question).expect("a question");
        let is_more = q.iter().sum::<f64>().rem_euclid(1.0) < 0.5;
        let times = if is_more { 2.15 } else { 1.85 };
        let right = row::parse(asked.answer.kind, &case.answers[0], "right");
        let answer: Vec<_> = right
            .expect("a golden answer can be read")
            .iter()
            .map(|v| times * v)
            .collect();
        judged(examiner, case, row::format(asked.answer.kind, &answer))
    });
    assert!(after.is_none_or(|after| !after.certain), "nothing is so");
}
