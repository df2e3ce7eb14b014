//! Silly answers and silly questions: whatever a program says, it is judged in words.

use rand::RngExt;
use raybook::math::pcg::Pcg;
use raybook_grader::cases;
use raybook_grader::examine::visible_rng;

/// Words that stand for what nobody should answer or ask.
const SILLY: [&str; 9] = [
    "0",
    "1",
    "-1",
    "7",
    "4294967295",
    "nan",
    "inf",
    "-inf",
    "1e38",
];

/// A line with some of its words replaced, left out or said twice.
fn garbled(line: &str, rng: &mut Pcg) -> String {
    let mut words: Vec<_> = line.split_whitespace().collect();
    for _ in 0..rng.random_range(1..4) {
        let (i, silly) = (
            rng.random_range(0..words.len()),
            rng.random_range(0..SILLY.len()),
        );
        match rng.random_range(0..20) {
            0 if words.len() > 1 => drop(words.remove(i)),
            1 => words.insert(i, words[i]),
            _ => words[i] = SILLY[silly],
        }
    }
    words.join(" ")
}

#[test]
fn no_garbled_answer_makes_a_judge_panic() {
    let (mut judged, mut unreadable) = (0, 0);
    for examiner in cases::all() {
        let rng = &mut visible_rng(examiner.name());
        for case in examiner.cases(rng).cases {
            for _ in 0..40 {
                let got = garbled(&case.answers[0], rng);
                match examiner.judge(&case.question, &case.answers, &got) {
                    Err(why) if why.starts_with("the answer cannot be read") => unreadable += 1,
                    _ => judged += 1,
                }
            }
        }
    }
    assert!(
        judged > unreadable,
        "{judged} were judged, {unreadable} could not be read"
    );
}

#[test]
fn no_tree_of_a_question_makes_the_walk_panic() {
    let walk = cases::find("octree_walk").expect("an exercise");
    let question = |nodes: &[String]| {
        let ray = "-1 0.1 0.2  1 0.01 0.02  0 inf  0 0 0  8 8 8";
        format!("{ray}  {}  {}", nodes.len(), nodes.join("  "))
    };
    // Every cut is of child 0, or of all eight at once into the same eight.
    for (depth, cut) in [(16, 1), (17, 1), (40, 1), (40, 8)] {
        let mut nodes = vec!["1 1 0".to_owned()];
        for level in 1..=depth {
            let below = format!("1 {} 0", 1 + 8 * level);
            let children = (0..8).map(|i| {
                if i < cut && level < depth {
                    below.clone()
                } else {
                    "0 0 1".to_owned()
                }
            });
            nodes.extend(children);
        }
        let question = question(&nodes);
        let golden = walk.answer_line(&question).expect("a question");
        assert_eq!(
            walk.judge(&question, std::slice::from_ref(&golden), &golden),
            Ok(()),
            "{depth} deep: its own answer is right"
        );
    }
}
