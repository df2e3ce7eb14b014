//! Programs that do not answer, or wrongly, or late.

use super::scripts::{RIGHT, darts};
use super::{got, own, wanted};
use raybook_grader::converse::{Limits, Program};
use raybook_grader::patterns::ask::ask;
use raybook_grader::patterns::got::{Got, Wanted};
use std::time::{Duration, Instant};

/// Why there are no points at all.
#[track_caller]
fn refused(name: &str, awk: &str) -> String {
    let Got { points, wrong, .. } = got(name, awk, &wanted());
    assert!(points.is_empty(), "nothing can be shown of {awk}");
    wrong.expect("and it is said why")
}

#[test]
fn what_is_not_written_is_said_to_be_so() {
    let why = refused("poisson-disk", RIGHT);
    assert!(why.contains("poisson_disk is not written yet"), "{why}");
}

#[test]
fn points_outside_are_refused_and_rounded_ones_are_not() {
    let why = refused(
        "random",
        r#"{ row = ""; for (i = 0; i < $2; i++) row = row " 0.5 1.25"; print "= " $2 row }"#,
    );
    assert!(
        why.contains("(0.5, 1.25) is not in the unit square"),
        "{why}"
    );
    let why = refused(
        "random",
        r#"{ row = ""; for (i = 0; i < $2; i++) row = row " nan 0.5"; print "= " $2 row }"#,
    );
    assert!(why.contains("is not in the unit square"), "{why}");
    let edge = got(
        "random",
        r#"{ row = ""; for (i = 0; i < $2; i++) row = row " 1.000000 " $3 / 16; print "= " $2 row }"#,
        &wanted(),
    );
    assert_eq!(edge.wrong, None, "0.9999998 printed with six digits");
    let largest = edge.points[&16]
        .concat()
        .iter()
        .fold(0.0_f32, |most, p| most.max(p.x));
    assert!(largest < 1.0, "and it is below 1: {largest}");
}

#[test]
fn too_few_points_are_refused_and_gaps_are_not_filled() {
    let why = refused("random", r#"{ print "= 1 0.5 0.5" }"#);
    assert!(
        why.contains("returned 1 points") && why.contains("16 points were asked for"),
        "{why}"
    );
    let mut wanted = wanted();
    wanted.needed = vec![200];
    let Got { points, wrong, .. } = got("poisson-disk", &darts(400, 1.6), &wanted);
    assert!(
        points.is_empty(),
        "twice as far apart is no Poisson disk of 200"
    );
    assert!(
        wrong.is_some_and(|why| why.contains("200 points were asked for")),
        "and says so"
    );
}

#[test]
fn an_answer_that_is_no_list_of_points_is_refused() {
    let why = refused("random", r#"{ print "= 16 points" }"#);
    assert!(why.contains("word 2"), "{why}");
    let why = refused("random", r#"{ print "= 0"; print "= 0" }"#);
    assert!(why.contains("gave 2 answers to one question"), "{why}");
    let why = refused("random", "{ exit 3 }");
    assert!(why.contains("exit code 3"), "{why}");
}

#[test]
fn where_it_fails_with_many_points_the_curves_end_before() {
    let awk = format!("$2 > 100 {{ exit 1 }}\n{RIGHT}");
    let Got { points, wrong, .. } = got("random", &awk, &wanted());
    assert_eq!(points[&16].len(), 8, "what it can do is shown");
    assert!(!points.contains_key(&200), "and nothing else");
    assert!(
        wrong.is_some_and(|why| why.contains("200 points")),
        "and it is said"
    );
}

#[test]
fn who_ignores_the_seed_is_told() {
    let awk = RIGHT.replace("srand($4 + 7)", "srand(7)");
    let Got {
        points,
        wrong,
        remarks,
    } = got("jittered", &awk, &wanted());
    assert_eq!(wrong, None, "it is a jittered pattern");
    assert!(remarks[0].contains("whatever the seed"), "{remarks:?}");
    assert_eq!(points[&16].len(), 1, "and there is only one of it");
    let awk = darts(200, 1.0).replace("srand($3 + 1)", "srand(7)");
    let Got { remarks, .. } = got("poisson-disk", &awk, &wanted());
    assert!(
        remarks.iter().any(|r| r.contains("whatever the seed")),
        "{remarks:?}"
    );
}

#[test]
fn who_hangs_is_left_after_the_time_limit() {
    let program = Program {
        file: "/bin/sh".into(),
        arguments: vec!["-c".into(), "sleep 60".into()],
        folder: std::path::PathBuf::new(),
        sandbox: None,
    };
    let limits = Limits::of(Duration::from_millis(300));
    let start = Instant::now();
    let got = ask(&program, own("random"), &wanted(), limits).expect("a shell can be started");
    assert!(got.points.is_empty(), "nothing came");
    assert!(
        got.wrong
            .is_some_and(|why| why.contains("no answer within 0.3 s")),
        "it is said"
    );
    assert!(
        start.elapsed() < Duration::from_secs(20),
        "asked once, not for every set"
    );
}

#[test]
fn who_is_slow_has_fewer_realisations_of_many_points() {
    // 20 ms for each answer, of which 400 are wanted.
    let awk = format!("{{ system(\"sleep 0.02\") }}\n{RIGHT}");
    let wanted = Wanted {
        needed: vec![16],
        further: vec![64, 200],
        realisations: 400,
        patience: Duration::from_secs(2),
    };
    let Got {
        points,
        wrong,
        remarks,
    } = got("random", &awk, &wanted);
    assert_eq!(wrong, None, "slow is not wrong");
    let few = points[&16].len();
    assert!((4..400).contains(&few), "what came in time: {few}");
    let many = points.get(&200).map_or(0, Vec::len);
    assert!(many < few, "fewer of the many: {many}, {few}");
    assert!(!remarks.is_empty(), "and it is said");
}
