//! The workbook's golden answers are Embree's: it takes the exercises of hits like a student, and is judged by the same judge.

use raybook_embree::embree::Embree;
use raybook_embree::student::STUDENTS;
use raybook_grader::cases::find;
use raybook_grader::examine::{Case, Examiner, visible_rng};
use raybook_grader::hidden::Key;

/// Number of students whose hidden cases are asked beside the visible ones.
const KEYS: usize = 5;

/// Named cases to which Embree may answer otherwise, and why nobody is wrong. At the very end of an interval its answer depends on the
/// processor: it calculates in another way on each.
const OTHERWISE: &[(&str, &str, &str)] = &[
    (
        "mesh_hit",
        "an empty list",
        "Embree takes no buffer without triangles, so it is not asked",
    ),
    ("sphere_hit", "just where the interval ends", CLOSED),
    ("sphere_hit", "just where the interval begins", CLOSED),
    (
        "sphere_hit",
        "the far side just where the interval ends",
        CLOSED,
    ),
    ("plane_hit", "just where the interval ends", CLOSED),
    ("plane_hit", "just where the interval begins", CLOSED),
    ("mesh_hit", "just where the interval ends", CLOSED),
    ("mesh_hit", "just where the interval begins", CLOSED),
    ("triangle_hit", "just where the interval ends", CLOSED),
    ("triangle_hit", "just where the interval begins", CLOSED),
    ("bvh_closest", "just where the interval ends", CLOSED),
    ("bvh_closest", "just where the interval begins", CLOSED),
    ("wide_closest", "just where the interval ends", CLOSED),
    ("wide_closest", "just where the interval begins", CLOSED),
];

/// The course's interval is open.
const CLOSED: &str = "Embree may count a hit at the very end of the interval";

/// Mistakes that find the right hits, with too much work or a wrong count of it: Embree cannot contradict them.
const TOO_MUCH_WORK: &[(&str, &str)] = &[
    ("bvh_closest", "tests every triangle"),
    ("bvh_closest", "opens every box"),
    (
        "bvh_closest",
        "does not shorten the interval for the second child, nor for any box behind a hit",
    ),
    ("bvh_closest", "opens the farther child first"),
    (
        "bvh_closest",
        "opens the first child first, whichever is nearer",
    ),
    (
        "bvh_closest",
        "opens the second child first, whichever is nearer",
    ),
    ("bvh_closest", "begins to count the tests at 1"),
    (
        "bvh_closest",
        "opens a waiting node without asking again whether it is behind the hit",
    ),
    ("bvh_closest", "counts one box for each branch"),
    (
        "bvh_closest",
        "counts the nodes that are visited, not the boxes that are tested",
    ),
    ("bvh_closest", "counts only the triangles that are hit"),
    ("bvh_closest", "counts only the boxes that are met"),
    ("bvh_closest", "counts the triangles of a leaf as one test"),
    ("wide_closest", "opens every child"),
    (
        "wide_closest",
        "opens first the child whose box the ray leaves first",
    ),
    (
        "wide_closest",
        "opens first the child in whose box the middle of the ray's stay is nearest",
    ),
    (
        "wide_closest",
        "sorts the boxes by the distances of their least corners from the ray's origin",
    ),
    (
        "wide_closest",
        "tests all leaves of a node before it opens the nodes among its children",
    ),
    (
        "wide_closest",
        "takes the nearest child first, and the others in the order of the node",
    ),
    (
        "wide_closest",
        "opens the children in the reverse order of the node, as they come from a stack",
    ),
    ("wide_closest", "counts the triangles of a leaf as one test"),
    (
        "wide_closest",
        "opens the children in the order of the node",
    ),
    ("wide_closest", "opens the farthest child first"),
    (
        "wide_closest",
        "asks every box as if nothing had been hit yet, and opens what is behind the hit",
    ),
    ("wide_closest", "opens children that wait behind the hit"),
    ("wide_closest", "counts each leaf as a node too"),
    (
        "wide_closest",
        "begins to count the nodes at 1, or counts the root twice",
    ),
    ("wide_closest", "begins to count the tests at 1"),
    (
        "wide_closest",
        "counts a node for each child whose box is tested",
    ),
];

#[test]
fn embree_confirms_the_golden_answers() {
    let embree = Embree::new().expect("Embree works");
    println!("exercise       cases   hits  confirmed  otherwise");
    for (exercise, answer) in STUDENTS {
        let examiner = find(exercise).expect("an exercise");
        let cases = cases(examiner);
        let (mut confirmed, mut hits, mut otherwise) = (0, 0, vec![]);
        for case in &cases {
            hits += usize::from(case.answers[0] != "none");
            let verdict = answer(&embree, &case.question).and_then(|said| {
                let verdict = examiner.judge(&case.question, &case.answers, &said);
                verdict.map_err(|why| format!("{why}: Embree says {said}"))
            });
            match verdict {
                Ok(()) => confirmed += 1,
                Err(_) if is_listed(exercise, case) => otherwise.push(case.name.as_str()),
                Err(why) => panic!(
                    "{exercise}, {}: {} is answered {:?}, but {why}",
                    case.name, case.question, case.answers
                ),
            }
        }
        println!(
            "{exercise:13} {:6} {hits:6} {confirmed:10} {:10}",
            cases.len(),
            otherwise.len()
        );
        assert!(
            10 * confirmed >= 9 * cases.len() && 4 * hits >= cases.len(),
            "{exercise}: too few cases say something"
        );
        for (_, name, _) in OTHERWISE.iter().filter(|(listed, ..)| *listed == exercise) {
            assert!(
                cases.iter().any(|case| case.name == *name),
                "{exercise}, {name}: there is no such case any more; take it off the list"
            );
        }
    }
}

#[test]
fn embree_contradicts_the_golden_answers_of_every_mistake() {
    let embree = Embree::new().expect("Embree works");
    for (exercise, answer) in STUDENTS {
        let examiner = find(exercise).expect("an exercise");
        let cases = examiner.cases(&mut visible_rng(exercise)).cases;
        let cases = cases.iter().filter(|case| !is_listed(exercise, case));
        let said: Vec<_> = cases
            .map(|case| {
                (
                    &case.question,
                    answer(&embree, &case.question).expect("an answer"),
                )
            })
            .collect();
        for (i, (mistake, _)) in examiner.mistakes().into_iter().enumerate() {
            if TOO_MUCH_WORK.contains(&(exercise, mistake)) {
                continue;
            }
            let mut contradicted = said.iter().filter(|(question, said)| {
                let golden = examiner.mistaken(i, question).expect("a question");
                examiner.judge(question, &[golden], said).is_err()
            });
            assert!(
                contradicted.next().is_some(),
                "{exercise}: if the reference {mistake}, Embree must contradict it"
            );
        }
    }
}

fn is_listed(exercise: &str, case: &Case) -> bool {
    OTHERWISE
        .iter()
        .any(|(listed, name, _)| *listed == exercise && *name == case.name)
}

/// The visible cases, and the hidden ones of some students.
fn cases(examiner: &dyn Examiner) -> Vec<Case> {
    let mut cases = examiner.cases(&mut visible_rng(examiner.name())).cases;
    for student in 0..KEYS {
        let key = Key {
            course: "Embree's course".into(),
            term: "summer".into(),
            student: student.to_string(),
        };
        cases.extend(examiner.cases(&mut key.rng(examiner.name())).cases);
    }
    cases
}
