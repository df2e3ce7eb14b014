//! What is linked into the command may be passed on: each package's licence is on the list in `deny.toml`, and `NOTICE` names
//! the package.
//!
//! `RAYBOOK_BLESS=1 cargo test -p raybook-grader licences` writes `NOTICE` anew. What belongs to other systems is left to
//! `cargo deny check`.
#![cfg(all(target_os = "linux", target_arch = "x86_64"))] // the packages of one system, so that NOTICE is one

use raybook_common::project;
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::process::Command;

/// The beginning of `NOTICE`.
const HEAD: &str = "\
raybook is under the MIT licence or the Apache licence, version 2.0, as you like.

The command `raybook` also holds the font DejaVu Sans (chapters/kit/fonts, with its licence beside it) and, on Linux, what is
compiled of these packages; their texts are in the packages, on https://crates.io. `RAYBOOK_BLESS=1 cargo test -p raybook-grader
licences` renews the list.

";

/// Name, version and licence of each package that is linked into the command, macros and build scripts left out, the course's
/// own too.
fn linked() -> Vec<[String; 3]> {
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--format-version", "1", "--locked"])
        .args(["--filter-platform", "x86_64-unknown-linux-gnu"])
        .current_dir(project(""))
        .output()
        .expect("cargo can be run");
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{error}");
    let metadata: Value = serde_json::from_slice(&output.stdout).expect("cargo writes JSON");
    let by_id = |list: &Value| -> BTreeMap<String, Value> {
        let list = list.as_array().expect("a list").iter();
        list.map(|of| (of["id"].as_str().expect("an id").to_owned(), of.clone()))
            .collect()
    };
    let packages = by_id(&metadata["packages"]);
    let nodes = by_id(&metadata["resolve"]["nodes"]);
    let root = packages
        .iter()
        .find(|(_, of)| of["name"] == "raybook-grader");
    let mut open = vec![root.expect("the command's package").0.as_str()];
    let mut seen = BTreeSet::new();
    while let Some(id) = open.pop() {
        if is_macro(&packages[id]) || !seen.insert(id) {
            continue;
        }
        for dependency in nodes[id]["deps"].as_array().expect("a list") {
            let kinds = dependency["dep_kinds"].as_array().expect("a list");
            if kinds.iter().any(|kind| kind["kind"].is_null()) {
                open.push(dependency["pkg"].as_str().expect("an id"));
            }
        }
    }
    let foreign = seen.iter().map(|id| &packages[*id]);
    let foreign = foreign.filter(|package| !package["source"].is_null());
    let text = |of: &Value| of.as_str().unwrap_or("none").to_owned();
    let rows = foreign.map(|of| {
        [
            text(&of["name"]),
            text(&of["version"]),
            text(&of["license"]),
        ]
    });
    let rows: BTreeSet<_> = rows.collect();
    rows.into_iter().collect()
}

/// Macros run in the compiler, and stay there.
fn is_macro(package: &Value) -> bool {
    let targets = package["targets"].as_array().expect("a list");
    targets
        .iter()
        .any(|target| target["kind"][0] == "proc-macro")
}

/// The licences that `deny.toml` allows.
fn allowed() -> BTreeSet<String> {
    let text = fs::read_to_string(project("deny.toml")).expect("it is there");
    let list = text
        .split_once("\nallow = [")
        .and_then(|(_, rest)| rest.split_once(']'));
    let (list, _) = list.expect("it allows licences");
    let names = list.split('"').skip(1).step_by(2).map(str::to_owned);
    names.collect()
}

/// Whether a licence may be chosen that is allowed: an SPDX expression of names, AND, OR and brackets; `/` is an old OR.
fn may_be_used(licence: &str, allowed: &BTreeSet<String>) -> bool {
    let spaced = licence
        .replace('/', " OR ")
        .replace('(', " ( ")
        .replace(')', " ) ");
    let mut words = spaced.split_whitespace().peekable();
    let sound = any(&mut words, allowed);
    sound && words.next().is_none()
}

type Words<'a> = std::iter::Peekable<std::str::SplitWhitespace<'a>>;

/// Alternatives, of which one is enough.
fn any(words: &mut Words, allowed: &BTreeSet<String>) -> bool {
    let mut sound = all(words, allowed);
    while words.next_if_eq(&"OR").is_some() {
        sound |= all(words, allowed);
    }
    sound
}

/// Parts, all of which count.
fn all(words: &mut Words, allowed: &BTreeSet<String>) -> bool {
    let mut sound = one(words, allowed);
    while words.next_if_eq(&"AND").is_some() {
        sound &= one(words, allowed);
    }
    sound
}

/// A name, with its exception where it has one, or an expression in brackets.
fn one(words: &mut Words, allowed: &BTreeSet<String>) -> bool {
    match words.next() {
        Some("(") => any(words, allowed) && words.next() == Some(")"),
        Some(name) => {
            let exception = words.next_if_eq(&"WITH").and_then(|_| words.next());
            let name = exception.map_or(name.to_owned(), |with| format!("{name} WITH {with}"));
            allowed.contains(&name)
        }
        None => false,
    }
}

#[test]
fn every_package_has_a_licence_that_is_allowed() {
    let (packages, allowed) = (linked(), allowed());
    assert!(
        packages.len() > 50,
        "the test must see the packages: {packages:?}"
    );
    assert!(allowed.contains("MIT"), "and the list: {allowed:?}");
    for [name, version, licence] in &packages {
        assert!(
            may_be_used(licence, &allowed),
            "{name} {version} is under {licence}, which deny.toml does not allow"
        );
    }
}

#[test]
fn the_notice_names_what_is_linked() {
    let rows = linked().into_iter().map(|row| row.join("  ") + "\n");
    let notice = HEAD.to_owned() + &rows.collect::<String>();
    if std::env::var_os("RAYBOOK_BLESS").is_some() {
        fs::write(project("NOTICE"), &notice).expect("it can be written");
    }
    let kept = fs::read_to_string(project("NOTICE")).unwrap_or_default();
    assert_eq!(kept, notice, "RAYBOOK_BLESS=1 writes NOTICE anew");
}

#[test]
fn licences_are_understood() {
    let allowed = ["MIT", "Apache-2.0", "Unicode-3.0"]
        .map(str::to_owned)
        .into();
    for (licence, sound) in [
        ("MIT", true),
        ("MIT OR GPL-3.0", true),
        ("GPL-3.0/MIT", true),
        ("(MIT OR Apache-2.0) AND Unicode-3.0", true),
        ("Apache-2.0 WITH LLVM-exception OR MIT", true),
        ("LGPL-3.0", false),
        ("MIT AND LGPL-3.0", false),
        ("(MIT OR Apache-2.0) AND GPL-3.0", false),
        ("GPL-3.0 AND (MIT OR Apache-2.0)", false),
        ("Apache-2.0 WITH some-exception", false),
        ("none", false),
        ("", false),
        ("MIT Apache-2.0", false),
        ("(MIT", false),
    ] {
        assert_eq!(may_be_used(licence, &allowed), sound, "{licence}");
    }
}
