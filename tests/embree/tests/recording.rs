//! The recorded sample in `golden/embree`, with which plain `cargo test` does without Embree, is what Embree says.
//!
//! `RAYBOOK_BLESS=1 cargo test --release -p raybook-embree` writes it anew.

use raybook_common::oracle::judge::{Verdict, judge};
use raybook_common::oracle::recording::parse;
use raybook_embree::sample::{FILES, recording};
use std::path::PathBuf;

#[test]
fn the_recordings_are_what_embree_says() {
    for file in FILES {
        let now = recording(file).expect("Embree works");
        let path = path(file);
        if std::env::var_os("RAYBOOK_BLESS").is_some_and(|value| value == "1") {
            std::fs::write(&path, &now).expect("golden/embree can be written");
        }
        let recorded = std::fs::read_to_string(&path)
            .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        if let Err(why) = compare(&recorded, &now) {
            panic!(
                "golden/embree/{file}.txt is stale: {why}\n\
                 If this is meant: RAYBOOK_BLESS=1 cargo test --release -p raybook-embree"
            );
        }
    }
}

#[test]
fn a_stale_recording_is_noticed() {
    let now = recording("sphere").expect("Embree works");
    assert_eq!(
        compare(&now, &now),
        Ok(()),
        "a fresh recording is not stale"
    );
    let line = now.lines().find(|line| line.starts_with("front"));
    let line = line.expect("a line named front");
    let (question, _) = line.split_once(" = ").expect("an answer");
    let nearer = format!("{question} = 1.998 0 0 0 0 0 1");
    for (what, stale) in [
        (
            "a hit 0.1 % nearer than 2 m",
            now.replacen(line, &nearer, 1),
        ),
        (
            "a miss for a hit",
            now.replacen(line, &format!("{question} = none"), 1),
        ),
        (
            "another question",
            now.replacen("front  0 0 3", "front  0 0 4", 1),
        ),
        ("a line less", now.replacen(&format!("{line}\n"), "", 1)),
        ("a line more", format!("{now}{line}\n")),
    ] {
        assert!(stale != now, "{what}: the text was changed");
        assert!(compare(&stale, &now).is_err(), "{what} must be noticed");
    }
}

/// The same text; or, since Embree's last digits depend on its version and on the processor's maker, the same questions with the same
/// answers within the bounds of the comparison.
fn compare(recorded: &str, now: &str) -> Result<(), String> {
    if recorded == now {
        return Ok(());
    }
    let question = |line: &str| line.split(" = ").next().map(str::to_owned);
    // The first line says which version has answered.
    let mut lines = [recorded, now].map(|text| text.lines().skip(1).map(question));
    for number in 1.. {
        match [lines[0].next(), lines[1].next()] {
            [None, None] => break,
            [old, new] if old == new => {}
            [old, new] => {
                return Err(format!(
                    "line {number} asks\n  {old:?}, and should ask\n  {new:?}"
                ));
            }
        }
    }
    let (old, new) = (
        parse("the recording", recorded)?,
        parse("the new recording", now)?,
    );
    for (old, new) in old.into_iter().zip(new) {
        let answers = [old.answer, new.answer];
        match judge(&new.target, &new.ray, new.within, answers) {
            Verdict::BothMiss | Verdict::Same { .. } => {}
            Verdict::Excused(_) | Verdict::Wrong(_) => {
                return Err(format!(
                    "to {} it says\n  {old:?}, Embree\n  {new:?}",
                    new.name,
                    old = answers[0],
                    new = answers[1]
                ));
            }
        }
    }
    Ok(())
}

fn path(file: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("../../golden/embree/{file}.txt"))
}
