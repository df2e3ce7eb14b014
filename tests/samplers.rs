//! The sampling lab as a lecturer meets it.

#[path = "own_patterns/scripts.rs"]
#[allow(dead_code)] // another test uses the rest
mod scripts;

use assert_cmd::Command;
use std::fs;
use std::path::Path;

fn samplers(out: &Path, options: &[&str]) -> assert_cmd::assert::Assert {
    Command::cargo_bin("raybook")
        .expect("the command is built")
        .arg("samplers")
        .args(options)
        .arg("--out")
        .arg(out)
        .assert()
}

#[test]
fn the_page_shows_figures_that_exist_as_png_svg_and_csv() {
    let out = tempfile::tempdir().expect("a temporary folder");
    let options = ["--patterns", "jittered,n-rooks,best-candidate"];
    let small = [
        "--points",
        "25",
        "--samples",
        "1,5",
        "--realisations",
        "3",
        "--width",
        "24",
    ];
    let run = samplers(out.path(), &[&options[..], &small].concat()).success();
    let said = String::from_utf8_lossy(&run.get_output().stdout).into_owned();
    assert!(
        said.contains("spectrum of n-rooks") && said.contains("index.html"),
        "plain lines where there is no terminal: {said}"
    );
    let page = fs::read_to_string(out.path().join("index.html")).expect("the page is there");
    let links = |attribute: &str| -> Vec<String> {
        let parts = page.split(attribute).skip(1);
        parts
            .filter_map(|part| Some(part.split('"').next()?.to_owned()))
            .collect()
    };
    let files = [links("src=\""), links("href=\"")].concat();
    assert!(files.len() > 30, "many files: {}", files.len());
    for file in &files {
        let bytes = fs::read(out.path().join(file)).unwrap_or_else(|e| panic!("{file}: {e}"));
        let text = String::from_utf8_lossy(&bytes);
        let sound = match file.rsplit('.').next() {
            Some("png") => bytes.starts_with(b"\x89PNG"),
            Some("svg") => text.starts_with("<svg") && text.trim_end().ends_with("</svg>"),
            Some("csv") => text.lines().count() > 3 && text.lines().all(|line| line.contains(',')),
            _ => false,
        };
        assert!(sound, "{file} is what its name says");
    }
    let left: Vec<_> = fs::read_dir(out.path())
        .expect("the folder is there")
        .flatten()
        .filter(|entry| entry.file_name().to_string_lossy().contains("partial"))
        .collect();
    assert!(left.is_empty(), "nothing half written is left: {left:?}");
    let errors = fs::read_to_string(out.path().join("error_disc_edge.csv")).expect("a curve");
    assert_eq!(
        errors.lines().next(),
        Some("pattern,samples,rms_error,low_95,high_95"),
        "its columns have names"
    );
    assert_eq!(
        errors.lines().count(),
        1 + 3 * 12,
        "twelve counts of three patterns"
    );
}

#[test]
fn a_pattern_that_is_not_there_is_named_with_those_that_are() {
    let out = tempfile::tempdir().expect("a temporary folder");
    let run = samplers(&out.path().join("none"), &["--patterns", "jitered"]).code(2);
    let said = String::from_utf8_lossy(&run.get_output().stderr).into_owned();
    assert!(
        said.contains("jitered") && said.contains("multi-jittered"),
        "{said}"
    );
    assert!(!out.path().join("none").exists(), "and nothing is written");
}

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
#[cfg(unix)]
fn program(folder: &Path, awk: &str) -> std::path::PathBuf {
    use std::os::unix::fs::PermissionsExt;
    let file = folder.join("my-answers");
    fs::write(folder.join("answers.awk"), awk).expect("a temporary file");
    let answers = folder.join("answers.awk");
    fs::write(
        &file,
        format!(
            "#!/bin/sh\nexec awk -f {:?}\n",
            answers.display().to_string()
        ),
    )
    .expect("a temporary file");
    fs::set_permissions(&file, fs::Permissions::from_mode(0o755)).expect("it is a program");
    file
}

/// The RMS errors of a pattern, by number of points.
#[cfg(unix)]
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

#[test]
#[cfg(unix)]
fn a_programs_own_patterns_are_drawn_beside_the_librarys() {
    let out = tempfile::tempdir().expect("a temporary folder");
    // The Poisson disk is not written yet, and the rotated grid hangs.
    let awk = scripts::RIGHT.replace(
        "$1 == \"rotated_grid\" {",
        "$1 == \"rotated_grid\" { system(\"sleep 60\")",
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
    assert_eq!(own.len(), 12, "every number of points");
    for ((n, own), (_, librarys)) in own.iter().zip(librarys) {
        // Twenty realisations know an error to 16 % (one standard deviation), and here are two.
        assert!(
            (own / librarys).ln().abs() < 1.2,
            "{n}: {own}, the library's {librarys}"
        );
    }
    let own = curve(out.path(), "error_slanted_edge.csv", "my-regular-grid");
    let librarys = curve(out.path(), "error_slanted_edge.csv", "regular-grid");
    for ((n, own), (_, librarys)) in own.iter().zip(librarys) {
        assert!(
            (own - librarys).abs() < 1.5 / *n as f64,
            "{n}: {own}, {librarys}: but for points on the edge"
        );
    }
}

#[test]
#[cfg(unix)]
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
