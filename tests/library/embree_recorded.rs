//! raybook gives Embree's recorded answers (`golden/embree`); this needs no Embree.
//!
//! `tests/embree` records them, and compares millions more. The bounds are the same: `tests/common/oracle/meeting.rs`.

use raybook_common::oracle;

use glam::vec2;
use oracle::judge::{Answer, Verdict, judge};
use oracle::recording::{Recorded, parse};
use raybook_common::project;

/// The files of `golden/embree`, without their ending.
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
