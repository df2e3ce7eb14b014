//! raybook gives Embree's recorded answers (`golden/embree`); this needs no Embree.
//!
//! `tests/embree` records them, and compares millions more. The bounds are the same: `tests/common/oracle/meeting.rs`.

mod common;
#[path = "common/oracle/mod.rs"]
mod oracle;

use common::project;
use glam::vec2;
use oracle::judge::{Answer, Verdict, judge};
use oracle::recording::{Recorded, parse};

/// The files, and what a wrong answer of each kind of shape can be told by.
const FILES: [&str; 5] = ["triangle", "sphere", "plane", "cuboid", "mesh"];

#[test]
fn raybook_gives_the_recorded_answers() {
    for file in FILES {
        let recorded = read(file);
        let hits = recorded.iter().filter(|r| r.answer.is_some()).count();
        assert!(
            recorded.len() >= 60 && 3 * hits >= recorded.len() && hits + 10 <= recorded.len(),
            "{file}: the sample must hold hits and misses, not {hits} of {}",
            recorded.len()
        );
        for question in recorded {
            let ours = question.target.ask(&question.ray, question.within);
            let verdict = ask(&question, ours);
            assert!(
                agrees(&verdict),
                "golden/embree/{file}.txt, {}: {verdict:?}",
                question.name
            );
        }
    }
}

#[test]
fn a_wrong_answer_is_told_from_a_right_one() {
    type Change = fn(Answer) -> Option<Answer>;
    let mistakes: [(&str, bool, Change); 7] = [
        ("t is 0.1 % too large", false, |a| {
            Some(Answer {
                t: 1.001 * a.t,
                ..a
            })
        }),
        ("the normal points inward", false, |a| {
            Some(Answer {
                normal: -a.normal,
                ..a
            })
        }),
        ("the normal is 0.3° off", false, |a| {
            Some(Answer {
                normal: (a.normal + 0.005 * a.normal.any_orthonormal_vector()).normalize(),
                ..a
            })
        }),
        ("the hit is overlooked", false, |_| None),
        ("b1 and b2 are swapped", true, |a| {
            Some(Answer {
                uv: vec2(a.uv.y, a.uv.x),
                ..a
            })
        }),
        ("b1 belongs to the first corner", true, |a| {
            Some(Answer {
                uv: vec2(1.0 - a.uv.x - a.uv.y, a.uv.x),
                ..a
            })
        }),
        ("it is the next triangle", true, |a| {
            Some(Answer { id: a.id + 1, ..a })
        }),
    ];
    for file in FILES {
        for (mistake, of_triangles, change) in mistakes {
            let mut asked = 0;
            let mut noticed = 0;
            for question in read(file) {
                let Some(ours) = question.target.ask(&question.ray, question.within) else {
                    continue;
                };
                // From the surface and back, or grazing it, bounds are wider than these mistakes.
                let wide = ours.t < 0.1 || question.name.starts_with("grazing");
                if wide || of_triangles && !question.target.numbered {
                    continue;
                }
                asked += 1;
                noticed += usize::from(!agrees(&ask(&question, change(ours))));
            }
            let none = of_triangles && !["triangle", "mesh"].contains(&file);
            assert!(
                none || asked >= 20,
                "{file}: {asked} answers are too few to try `{mistake}` on"
            );
            // Not all: a triangle may be thin, b1 may be close to b2.
            assert!(
                100 * noticed >= 95 * asked,
                "{file}: where {mistake}, only {noticed} of {asked} answers are called wrong"
            );
            println!("{file}: {mistake}: {noticed} of {asked}");
        }
    }
}

#[test]
fn a_hit_that_is_not_there_is_noticed() {
    let there = Answer {
        t: 1.0,
        id: 0,
        uv: vec2(0.25, 0.25),
        normal: glam::Vec3::Y,
    };
    for file in FILES {
        for question in read(file).into_iter().filter(|q| q.answer.is_none()) {
            let verdict = ask(&question, Some(there));
            assert!(
                matches!(verdict, Verdict::Wrong(_)),
                "golden/embree/{file}.txt, {}: a miss, but a hit at 1 m is {verdict:?}",
                question.name
            );
        }
    }
}

#[test]
fn a_bad_line_is_named_and_says_what_was_expected() {
    let good = "front  0 0 3  0 0 1  0 inf  sphere 0 0 0 1  = 2 0 0 0 0 0 1";
    assert!(
        parse("f", good).is_ok_and(|lines| lines.len() == 1),
        "the good line is read"
    );
    for (from, to, expected) in [
        (
            " = 2",
            " 2",
            "f:2: ` = ` is missing between question and answer",
        ),
        (
            "0 0 3 ",
            "0 x 3 ",
            "f:2: expected the ray's origin, found `x`",
        ),
        (
            "  0 0 1  0 inf",
            "  0 0 2  0 inf",
            "f:2: expected the ray's direction of length 1, found 0 0 2",
        ),
        (
            "sphere",
            "torus",
            "f:2: expected sphere, triangle, plane, cuboid or mesh, found `torus`",
        ),
        (
            "sphere 0 0 0 1",
            "sphere 0 0 0",
            "f:2: expected the radius, found the end",
        ),
        (
            "sphere 0 0 0 1",
            "sphere 0 0 0 1 1",
            "f:2: expected the end, found `1`",
        ),
        (
            "sphere 0 0 0 1",
            "mesh cow 5",
            "f:2: there is no mesh `cow`",
        ),
        (
            "sphere 0 0 0 1",
            "triangle 0 0 0 1 0 0 inf 1 0",
            "f:2: vertex 2 has a coordinate that is not a finite number",
        ),
        (
            "= 2 0",
            "= two 0",
            "f:2: expected t, or `none`, found `two`",
        ),
        (
            "0 0 0 0 0 1",
            "0 0 0 0 0",
            "f:2: expected the normal, found the end",
        ),
    ] {
        let bad = good.replacen(from, to, 1);
        let error = parse("f", &format!("# comment\n{bad}\n")).err();
        assert_eq!(error.as_deref(), Some(expected), "reading `{bad}`");
    }
}

fn read(file: &str) -> Vec<Recorded> {
    let name = format!("golden/embree/{file}.txt");
    let text = std::fs::read_to_string(project(&name)).unwrap_or_else(|e| panic!("{name}: {e}"));
    parse(&name, &text).unwrap_or_else(|error| panic!("{error}"))
}

fn ask(question: &Recorded, ours: Option<Answer>) -> Verdict {
    let Recorded {
        target,
        ray,
        within,
        answer,
        ..
    } = question;
    judge(target, ray, *within, [ours, *answer])
}

/// No excuses: the sample holds only rays whose answer is beyond doubt.
fn agrees(verdict: &Verdict) -> bool {
    matches!(verdict, Verdict::BothMiss | Verdict::Same { .. })
}
