//! The sampling lab as a lecturer meets it.

#[cfg(unix)]
use crate::common::executable;
mod file;
#[cfg(unix)] // the programs are scripts
mod own;
mod page;
mod slide;

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
        "12",
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
            .filter(|address| !address.starts_with("data:")) // it is its own file
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
        Some("pattern,samples,median_error,low_10,high_90,rms_error"),
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
