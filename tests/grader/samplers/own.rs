//! A student's own patterns beside the library's.

use super::{executable, samplers};
use crate::own_patterns::scripts;
use std::fs;
use std::path::{Path, PathBuf};

/// Small figures, of realisations that are few.
const SMALL: [&str; 8] = [
    "--points",
    "25",
    "--samples",
    "1,4",
    "--realisations",
    "20",
    "--width",
    "24",
];

/// An answer program in awk.
fn program(folder: &Path, awk: &str) -> PathBuf {
    let file = folder.join("my-answers");
    fs::write(folder.join("answers.awk"), awk).expect("a temporary file");
    let answers = folder.join("answers.awk");
    let text = format!(
        "#!/bin/sh\nexec awk -f {:?}\n",
        answers.display().to_string()
    );
    executable::script(&file, &text);
    file
}

/// The RMS errors of a pattern, by number of points.
fn curve(out: &Path, file: &str, pattern: &str) -> Vec<(usize, f64)> {
    let csv = fs::read_to_string(out.join(file)).expect("the curves are there");
    let rows = csv.lines().map(|line| line.split(',').collect::<Vec<_>>());
    rows.filter(|row| row[0] == pattern)
        .map(|row| {
            (
                row[1].parse().expect("a count"),
                row[2].parse().expect("an error"),
            )
        })
        .collect()
}

/// A program's errors, each with the library's of as many points.
fn beside<'a>(
    own: &'a [(usize, f64)],
    librarys: &'a [(usize, f64)],
) -> impl Iterator<Item = ((usize, f64), f64)> + 'a {
    own.iter().map(|&(n, error)| {
        let of_as_many = librarys.iter().find(|(of, _)| *of == n);
        ((n, error), of_as_many.expect("as many points").1)
    })
}

#[test]
fn a_programs_own_patterns_are_drawn_beside_the_librarys() {
    let out = tempfile::tempdir().expect("a temporary folder");
    // The Poisson disk is not written yet, and the rotated grid hangs.
    let awk = scripts::RIGHT.replace(
        "$1 == \"rotated_grid\" {",
        "$1 == \"rotated_grid\" { while (1) x++",
    );
    let file = program(out.path(), &awk);
    let file = file.to_str().expect("its path is text");
    let options = ["--program", file, "--time-limit", "0.5"];
    let run = samplers(out.path(), &[&options[..], &SMALL].concat()).code(1);
    let said = String::from_utf8_lossy(&run.get_output().stdout).into_owned();
    for words in [
        "my Poisson disk: poisson_disk is not written yet",
        "my rotated grid: no answer within 0.5 s",
        "it is left out",
        "raybook exercise poisson_disk",
        "--time-limit 0.5",
    ] {
        assert!(said.contains(words), "{words}: {said}");
    }
    let page = fs::read_to_string(out.path().join("index.html")).expect("the page is there");
    for words in [
        "my jittered",
        "my random",
        "my regular grid",
        "poisson_disk is not written yet",
    ] {
        assert!(page.contains(words), "{words}: on the page too");
    }
    for missing in ["my-poisson-disk", "my-rotated-grid"] {
        assert!(
            !page.contains(missing),
            "{missing}: there is no figure of it"
        );
    }
    let own = curve(out.path(), "error_smooth.csv", "my-jittered");
    let librarys = curve(out.path(), "error_smooth.csv", "jittered");
    // On a busy machine it is asked for fewer: half of them are sure to be there.
    assert!((6..=12).contains(&own.len()), "{own:?}");
    for ((n, own), librarys) in beside(&own, &librarys) {
        // Twenty realisations know an error to 16 % (one standard deviation), and here are two.
        assert!(
            (own / librarys).ln().abs() < 1.2,
            "{n}: {own}, the library's {librarys}"
        );
    }
    let own = curve(out.path(), "error_straight_edge.csv", "my-regular-grid");
    let librarys = curve(out.path(), "error_straight_edge.csv", "regular-grid");
    for ((n, own), librarys) in beside(&own, &librarys) {
        assert!(
            (own - librarys).abs() < 1.5 / n as f64,
            "{n}: {own}, {librarys}: but for points on the edge"
        );
    }
}

#[test]
fn a_clumped_pattern_shows_in_the_numbers() {
    let out = tempfile::tempdir().expect("a temporary folder");
    let file = program(out.path(), scripts::CLUMPED);
    let options = [
        "--patterns",
        "halton,jittered",
        "--program",
        file.to_str().expect("its path is text"),
    ];
    samplers(out.path(), &[&options[..], &SMALL].concat()).success();
    let numbers = fs::read_to_string(out.path().join("numbers.csv")).expect("the table is there");
    let star = |name: &str| -> f64 {
        let row = numbers
            .lines()
            .find(|line| line.split(',').next() == Some(name));
        let row = row.unwrap_or_else(|| panic!("{name}: {numbers}"));
        row.split(',')
            .nth(1)
            .and_then(|star| star.parse().ok())
            .expect("a number")
    };
    assert!(
        star("my-jittered") > 2.0 * star("jittered"),
        "far less even: {numbers}"
    );
    assert!(star("halton") > 0.0, "others are there too: {numbers}");
}

#[test]
fn a_program_that_is_not_there_is_named_and_nothing_is_written() {
    let out = tempfile::tempdir().expect("a temporary folder");
    let options = ["--program", "no-such-answers"];
    let run = samplers(&out.path().join("none"), &options).code(2);
    let said = String::from_utf8_lossy(&run.get_output().stderr).into_owned();
    assert!(
        said.contains("no-such-answers") && said.contains("cannot be run"),
        "{said}"
    );
    let options = ["--program", "no-such-answers", "--patterns", "halton"];
    let run = samplers(&out.path().join("none"), &options).code(2);
    let said = String::from_utf8_lossy(&run.get_output().stderr).into_owned();
    assert!(
        said.contains("none is an exercise") && said.contains("jittered"),
        "{said}"
    );
    assert!(!out.path().join("none").exists(), "and nothing is written");
}
