//! Points of one's own from a file, and several seeds.

use super::samplers;
use raybook_chapters::lab::subject::Subject;
use raybook_grader::patterns::file;
use std::fs;

/// Small figures.
const SMALL: [&str; 8] = [
    "--points",
    "25",
    "--samples",
    "1,4",
    "--realisations",
    "10",
    "--width",
    "16",
];

#[test]
fn a_file_of_points_is_drawn_beside_the_patterns() {
    let out = tempfile::tempdir().expect("a temporary folder");
    let file = out.path().join("my lattice.txt");
    let point = |i: usize| {
        format!(
            "{} {}\n",
            (i as f64 + 0.5) / 25.0,
            (i as f64 * 0.618_034).fract()
        )
    };
    fs::write(&file, (0..25).map(point).collect::<String>()).expect("a temporary file");
    let file = file.to_str().expect("its path is text");
    let options = [&["--patterns", "random", "--file", file], &SMALL[..]].concat();
    samplers(out.path(), &options).success();
    let read = |name: &str| fs::read_to_string(out.path().join(name)).expect("it is there");
    let numbers = read("numbers.csv");
    let star = |name: &str| -> f64 {
        let row = numbers.lines().find(|line| line.starts_with(name));
        let row = row.unwrap_or_else(|| panic!("{name}: {numbers}"));
        let star = row.split(',').nth(1).expect("a number");
        star.parse().expect("a number")
    };
    assert!(
        star("my-lattice,") < star("random,"),
        "more even: {numbers}"
    );
    let curve = read("error_smooth.csv");
    let sizes = curve.lines().filter(|line| line.starts_with("my-lattice,"));
    assert_eq!(sizes.count(), 4, "2, 4, 8, 16: it has no more");
}

#[test]
fn a_file_that_is_too_short_or_no_list_of_points_is_refused() {
    let out = tempfile::tempdir().expect("a temporary folder");
    let file = out.path().join("points.txt");
    for (text, words) in [
        (
            "0.5 0.5\n0.2 0.2\n",
            "its largest set has 2 points, and a figure shows 16: give 16 or more",
        ),
        (
            "0.5 0.5\n1.5 0.5\n",
            "line 2: 1.5 0.5: x and y are expected",
        ),
        ("", "there are no points in it"),
    ] {
        fs::write(&file, text).expect("a temporary file");
        let name = file.to_str().expect("its path is text");
        let run = samplers(&out.path().join("none"), &["--file", name]).code(2);
        let said = String::from_utf8_lossy(&run.get_output().stderr).into_owned();
        assert!(
            said.contains(words) && said.contains("points.txt"),
            "{words}: {said}"
        );
        assert!(!out.path().join("none").exists(), "and nothing is written");
    }
}

#[test]
fn two_seeds_are_two_curves_and_the_same_seed_is_the_same_page() {
    let page = |seeds: &str| {
        let out = tempfile::tempdir().expect("a temporary folder");
        let options = [&["--patterns", "jittered", "--seeds", seeds], &SMALL[..]].concat();
        samplers(out.path(), &options).success();
        let read = |name: &str| fs::read(out.path().join(name)).expect("it is there");
        (
            ["error_checker.csv", "points_25.png", "edges_4.svg"].map(read),
            String::from_utf8(read("points_25.csv")).expect("text"),
        )
    };
    let [first, again, other] = ["7", "7", "8"].map(page);
    assert_eq!(first.0, again.0, "the same seed, the same bits");
    assert_ne!(first.1, other.1, "another seed, other points");
    let both = page("7,8").1;
    for seed in [7, 8] {
        let name = format!("jittered-seed-{seed},");
        assert_eq!(both.matches(&name).count(), 25, "the points of seed {seed}");
    }
}

/// The points of a file, for figures of one and of two points.
fn points(text: &str) -> Result<Subject, String> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let file = folder.path().join("points.txt");
    fs::write(&file, text).expect("a temporary file");
    file::read(&file, [vec![1], vec![2]]).map_err(|why| why.to_string())
}

#[test]
fn empty_lines_part_sets_and_commas_or_spaces_numbers() {
    let read = points("# mine\n0.5 0.25\n0.1,0.9 # a corner\n\n\n0 0.999999999\n").expect("points");
    let sets = [1, 2].map(|n| read.realisations(n, 9));
    assert_eq!(sets, [2, 1], "two sets, of which one has a second point");
    let last = read.points(1, 1)[0];
    assert!(last.y < 1.0, "rounded down: {last}");
}

#[test]
fn a_line_that_is_no_point_is_named() {
    for (text, number) in [
        ("0.5 0.5\n0.5", 2),
        ("1.0 0.5", 1),
        ("nan 0.5", 1),
        ("a b", 1),
        ("0 0 0", 1),
    ] {
        let why = points(text).expect_err("no point");
        assert!(why.contains(&format!("line {number}:")), "{text}: {why}");
    }
    assert!(points("\n# nothing\n").is_err(), "no points");
}
