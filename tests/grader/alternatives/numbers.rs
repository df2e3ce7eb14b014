//! Numbers as programs of all languages print them: read alike, or refused with a word about what is wrong.

use rand::RngExt;
use rand::seq::IndexedMutRandom;
use raybook::math::pcg;
use raybook_grader::cases;
use raybook_grader::examine::visible_rng;

/// Words that some language or some mistake prints.
const WORDS: &[&str] = &[
    "-0",
    "-0.0",
    "+1",
    "3.",
    ".5",
    "1e-3",
    "1E+02",
    "1e400",
    "-1e400",
    "1e-400",
    "INF",
    "-inf",
    "Infinity",
    "NaN",
    "-nan",
    "1e99999999999",
    "0.1000000000000000055511151231257827",
    "none",
    "None",
    "null",
    "-1",
    "4294967295",
    "4294967296",
    "18446744073709551616",
    "-nan(ind)",
    "1.#INF",
    "1,5",
    "1.5f",
    "0x1p3",
    "1_000",
    "--1",
    "e",
    ".",
    "-",
    "∞",
    "٣",
    "½",
    "1\u{a0}2",
];

#[test]
fn a_number_counts_and_not_how_it_is_printed() {
    for (exercise, case, right) in [
        (
            "sphere_hit",
            "head on",
            &[
                "2",
                "2.0",
                "+2",
                "2e0",
                "20E-1",
                "2.",
                "2.0000000000000001",
                "1.99999999999999999",
                "02",
            ][..],
        ),
        ("sphere_hit", "past it", &["none", "  none "]),
        (
            "ray_at",
            "behind the origin",
            &["1 1 -1", "1.0 1e0 -1E+00", "\t1  1\u{2003}-1\r"],
        ),
        (
            "interpolate_texture",
            "at the first corner",
            &[
                "0.25 0.5",
                "2.5e-1 .5",
                "0.25000000000000000 0.50000000000000000",
            ],
        ),
        (
            "encode_srgb",
            "black",
            &[
                "0",
                "-0",
                "-0.0",
                "0e0",
                "1e-400",
                "4.9406564584124654e-324",
            ],
        ),
        (
            "box_clip",
            "from inside",
            &["0 1.4142135623730951", "-0 1.41421356237309515e+00"],
        ),
        (
            "bounds_of",
            "no points: the empty box, from +infinity to -infinity",
            &[
                "INF inf +Infinity -INF -inf -infinity",
                "1e400 1e39 inf -1e400 -1e999999999 -inf",
            ],
        ),
        (
            "mesh_hit",
            "far before near",
            &["2 1", "2.0 1", "1.9999999999999998 +1"],
        ),
        (
            "triangle_hit",
            "in the middle",
            &["3 0.25 0.25", "3.0000000000000000e+00 2.5e-1 2.5E-01"],
        ),
    ] {
        for got in right {
            assert_eq!(
                judged(exercise, case, got),
                Ok(()),
                "{exercise}, {case}: {got}"
            );
        }
    }
}

#[test]
fn what_is_not_a_number_is_wrong() {
    for (exercise, case, got) in [
        ("sphere_hit", "head on", "-nan"),
        ("sphere_hit", "head on", "INF"),
        ("sphere_hit", "head on", "2 2"),
        ("sphere_hit", "head on", ""),
        ("sphere_hit", "past it", "nan"),
        ("box_clip", "from inside", "0 inf"),
        (
            "bounds_of",
            "no points: the empty box, from +infinity to -infinity",
            "0 0 0 0 0 0",
        ),
        (
            "bounds_of",
            "no points: the empty box, from +infinity to -infinity",
            "nan nan nan nan nan nan",
        ),
        ("mesh_hit", "far before near", "2 1.0"),
        ("ray_at", "behind the origin", "nan nan nan"),
        ("tone_map", "gray 1 becomes 1/2", "nan nan nan"),
        ("triangle_normal", "a single point", "nan nan nan"),
    ] {
        assert!(
            judged(exercise, case, got).is_err(),
            "{exercise}, {case}: `{got}` must be wrong"
        );
    }
}

#[test]
fn no_word_makes_the_judge_panic_and_every_refusal_has_a_reason() {
    let mut refused = 0;
    for examiner in cases::all() {
        for case in examiner.cases(&mut visible_rng(examiner.name())).cases {
            let golden: Vec<_> = case.answers[0].split_whitespace().collect();
            for place in 0..golden.len().min(4) {
                for word in WORDS {
                    let mut got = golden.clone();
                    got[place] = word;
                    if let Err(why) = examiner.judge(&case.question, &case.answers, &got.join(" "))
                    {
                        assert!(why.len() > 10, "{}, `{word}`: {why}", examiner.name());
                        refused += 1;
                    }
                }
            }
        }
    }
    assert!(
        refused > 10_000,
        "only {refused} answers with an odd word are refused"
    );
}

/// A diagnosis compares answers with what a mistake would answer, and that with them: neither need be right, or fit the question.
#[test]
fn whatever_is_compared_no_judge_panics() {
    for examiner in cases::all() {
        let cases = examiner.cases(&mut visible_rng(examiner.name())).cases;
        let others = || cases.iter().rev().map(|case| case.answers[0].clone());
        for (case, mut rng) in cases.iter().zip((0..).map(|i| pcg::stream(9, i))).take(12) {
            let golden = &case.answers[0];
            let own: Vec<_> = golden.split_whitespace().collect();
            let altered = (0..6).map(|_| {
                let mut words = own.clone();
                if let Some(word) = words.choose_mut(&mut rng) {
                    *word = WORDS[rng.random_range(0..WORDS.len())];
                }
                words.join(" ")
            });
            let strange: Vec<_> = altered.chain(others().take(4)).collect();
            for strange in strange {
                let _ = examiner.judge(&case.question, std::slice::from_ref(&strange), golden);
                let _ = examiner.judge(&case.question, std::slice::from_ref(golden), &strange);
            }
        }
    }
}

/// The verdict on an answer to a named case.
fn judged(exercise: &str, case: &str, got: &str) -> Result<(), String> {
    let examiner = cases::find(exercise).expect("an exercise");
    let cases = examiner.cases(&mut visible_rng(exercise)).cases;
    let case = cases
        .iter()
        .find(|c| c.name == case)
        .unwrap_or_else(|| panic!("{exercise} has no case `{case}`"));
    examiner.judge(&case.question, &case.answers, got)
}
