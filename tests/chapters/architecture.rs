//! The rules about the house: floors, packages and claims.

use raybook_chapters::LESSONS;
use raybook_common::project;
use raybook_common::source::{file_of, read, rust_files, top_module, used_paths};
use std::collections::{BTreeMap, BTreeSet};

#[test]
fn a_module_uses_only_lower_floors() {
    let floors = floors();
    let mut uses = 0;
    for (file, text) in rust_files("src") {
        let Some(&place) = floors.get(top_module(&file)) else {
            assert!(
                !file.contains('/'),
                "{file}: its module is not in the map of floors in src/lib.rs"
            );
            continue;
        };
        for path in used_paths(&text, "crate") {
            let module = path.split("::").next().expect("a path has a first part");
            let used = *floors
                .get(module)
                .unwrap_or_else(|| panic!("{file}: `{module}` is not in the map of floors"));
            assert!(
                used < place || module == top_module(&file),
                "{file} uses {path}: a module may use only lower floors, and what is to its left on its own"
            );
            uses += 1;
        }
    }
    assert!(uses > 50, "the test must see the uses; it saw {uses}");
}

#[test]
fn a_file_of_the_library_is_new_in_one_chapter_at_the_most() {
    let mut claims = BTreeMap::<&str, Vec<&str>>::new();
    for lesson in LESSONS {
        for file in lesson.new_files() {
            assert!(
                project("src").join(file).is_file(),
                "{} claims src/{file}, which does not exist",
                lesson.name
            );
            claims.entry(file).or_default().push(lesson.name);
        }
    }
    assert!(
        claims.len() > 150,
        "the chapters teach most of the library's files; they claim {}",
        claims.len()
    );
    for (file, by) in claims {
        assert_eq!(
            by.len(),
            1,
            "src/{file} is on the `New:` lines of {by:?}, and can be new only once"
        );
    }
}

/// What a chapter may use before it is taught: the fastest structure, where the chapter is about something else; and what the one
/// interface of materials and the one film loop speak of: the medium that light comes through, directions that are chosen by chance,
/// and the filter of the samples.
const TOOLS: [&str; 4] = [
    "accel/wide_bvh/mod.rs",
    "material/glass.rs",
    "sample/filter.rs",
    "sample/hemisphere.rs",
];

#[test]
fn no_chapter_uses_a_file_that_a_later_one_claims() {
    let chapter_of: BTreeMap<_, _> = LESSONS
        .iter()
        .flat_map(|lesson| {
            lesson
                .new_files()
                .into_iter()
                .map(|file| (file, lesson.chapter().number()))
        })
        .collect();
    let sources: BTreeMap<_, _> = rust_files("src").collect();
    let mut uses = 0;
    for lesson in LESSONS {
        let own = lesson
            .new_files()
            .into_iter()
            .map(|file| (file, sources[file].as_str(), "crate"));
        for (file, text, root) in own.chain([(lesson.name, lesson.source, "raybook")]) {
            for path in used_paths(text, root) {
                let used = file_of(&path, &sources);
                let Some(&by) = chapter_of.get(used.as_str()) else {
                    continue;
                }; // a file that no chapter teaches belongs to all
                assert!(
                    by <= lesson.chapter().number() || TOOLS.contains(&used.as_str()),
                    "{file} of {} uses {path} (src/{used}), which chapter {by} introduces",
                    lesson.name
                );
                uses += 1;
            }
        }
    }
    assert!(uses > 30, "the test must see the uses; it saw {uses}");
}

/// What the packages may depend on, lowest first. Whoever wants a ray tracer does not pay for plots or for grading.
const PACKAGES: [(&str, &[&str]); 5] = [
    ("Cargo.toml", &[]),
    ("workbook/Cargo.toml", &["raybook"]),
    ("chapters/scenes/Cargo.toml", &["raybook"]),
    (
        "chapters/Cargo.toml",
        &["raybook", "raybook-scenes", "raybook-workbook"],
    ),
    (
        "grader/Cargo.toml",
        &[
            "raybook",
            "raybook-workbook",
            "raybook-chapters",
            "raybook-scenes",
        ],
    ),
];

#[test]
fn a_package_depends_only_on_lower_ones() {
    for (manifest, lower) in PACKAGES {
        let text = read(manifest);
        let ours = dependencies(&text).filter(|name| name.starts_with("raybook"));
        assert_eq!(
            ours.collect::<BTreeSet<_>>(),
            lower.iter().copied().collect(),
            "{manifest} depends on these packages of the house"
        );
    }
}

#[test]
fn the_library_has_a_ray_tracers_dependencies_and_no_others() {
    let text = read("Cargo.toml");
    let needed = [
        "arrayvec",
        "exr",
        "glam",
        "image",
        "libc",
        "rand",
        "rand_pcg",
        "rayon",
        "thiserror",
    ];
    assert_eq!(
        dependencies(&text).collect::<BTreeSet<_>>(),
        needed.into(),
        "what the library is compiled with"
    );
}

/// `Cargo.lock` holds a few packages at the last version before these came in (CONTRIBUTING tells which).
#[test]
fn the_first_build_compiles_no_package_that_is_heavy_and_idle() {
    let lock = read("Cargo.lock");
    for (idle, what) in [
        (
            "moxcms",
            "colour profiles, a fifth of what all packages took",
        ),
        (
            "pulp",
            "vectors for halves of floats, which EXR does without",
        ),
        ("zerocopy", "macros for the same"),
        ("miniz_oxide\"\nversion = \"0.9", "a second inflater"),
    ] {
        let name = format!("name = \"{idle}");
        assert!(!lock.contains(&name), "{idle} is back: {what}");
    }
}

/// The names in a manifest's tables of dependencies; those of the tests do not count.
fn dependencies(manifest: &str) -> impl Iterator<Item = &str> {
    let mut inside = false;
    manifest.lines().filter_map(move |line| {
        if line.starts_with('[') {
            inside = line == "[dependencies]" || line.ends_with(".dependencies]");
            inside &= !line.starts_with("[workspace");
            return None;
        }
        let (name, _) = line.split_once([' ', '.', '='])?;
        (inside && !name.is_empty() && !name.starts_with('#')).then_some(name)
    })
}

/// Module → floor and place on it from the left, from the table in `lib.rs`.
fn floors() -> BTreeMap<String, (u32, usize)> {
    let text = read("src/lib.rs");
    let rows = text
        .lines()
        .filter_map(|line| line.strip_prefix("//! | ")?.split_once(" | "));
    let floors: BTreeMap<_, _> = rows
        .filter_map(|(floor, modules)| {
            Some((floor.parse::<u32>().ok()?, modules.trim_end_matches(" |")))
        })
        .flat_map(|(floor, modules)| {
            modules
                .split(", ")
                .enumerate()
                .map(move |(place, module)| (module.to_owned(), (floor, place)))
        })
        .collect();
    assert!(
        floors.len() >= 10,
        "the map of floors in src/lib.rs has a row per floor"
    );
    floors
}

#[test]
fn uses_are_taken_apart() {
    let text =
        "use crate::a::{self, b::{C, d::E}, F};\nfn f() { crate::g::h() } // crate::not::this";
    assert_eq!(
        used_paths(text, "crate"),
        ["a", "a::b::C", "a::b::d::E", "a::F", "g::h"],
        "each path on its own"
    );
}

/// Nobody builds it in a test: it downloads another path tracer.
#[test]
fn the_race_of_pictures_locks_what_the_library_depends_on() {
    let manifest = read("Cargo.toml");
    let sections = manifest.split("\n[");
    let sections = sections.filter_map(|section| section.split_once("dependencies]\n"));
    let sections = sections.filter(|(of, _)| !of.ends_with("dev-") && *of != "workspace.");
    let lines = sections.flat_map(|(_, lines)| lines.lines());
    let depends: BTreeSet<_> = lines
        .filter_map(|line| line.split([' ', '.', '=']).next())
        .filter(|name| !name.is_empty() && !name.starts_with('#'))
        .collect();
    let lock = read("benches/peers/pictures/Cargo.lock");
    let (_, locked) = lock
        .split_once("name = \"raybook\"\n")
        .expect("raybook is locked");
    let (_, locked) = locked.split_once("dependencies = [\n").expect("a list");
    let (locked, _) = locked.split_once(']').expect("its end");
    let names = locked.split('"').skip(1).step_by(2);
    let locked: BTreeSet<_> = names.filter_map(|name| name.split(' ').next()).collect();
    assert_eq!(
        locked, depends,
        "benches/peers/run pictures cannot start: run `cargo metadata` in benches/peers/pictures, which writes its Cargo.lock anew"
    );
}

/// The packages that other programs use.
const LIBRARIES: [&str; 2] = ["src/lib.rs", "chapters/scenes/src/lib.rs"];

#[test]
fn every_public_module_of_a_library_has_an_example() {
    let mut open = LIBRARIES.map(String::from).to_vec();
    let mut seen = 0;
    while let Some(file) = open.pop() {
        let text = read(&file);
        let has_example = text.lines().any(|line| line == "//! ```");
        assert!(has_example, "{file}: its documentation has no example");
        seen += 1;
        let below = ["/lib.rs", "/mod.rs", ".rs"]
            .iter()
            .find_map(|end| file.strip_suffix(end));
        let below = below.expect("a file of Rust");
        let public = text
            .lines()
            .filter_map(|line| line.strip_prefix("pub mod ")?.strip_suffix(';'));
        open.extend(public.map(|module| {
            let file = format!("{below}/{module}.rs");
            if project(&file).is_file() {
                file
            } else {
                format!("{below}/{module}/mod.rs")
            }
        }));
    }
    assert!(seen > 150, "the test must see them all; it saw {seen}");
}

/// Where each thing that implements one of the library's interfaces must be named: the file of its laws, or the folder of all tests.
const NAMED: [(&str, &str); 5] = [
    (
        "Material",
        "tests/library/ch17_rendering_equation/materials.rs",
    ),
    ("Light", "tests"),
    ("Camera", "tests"),
    ("Shape", "tests/library/laws/wild.rs"),
    ("Accel<S>", "tests/library/bounded.rs"),
];

/// What only passes on to others, and `()`, the material of who asks for none: it has their laws.
const WRAPPERS: [&str; 6] = ["", "T", "Facet", "Thing", "Form", "Meshed"];

#[test]
fn what_is_added_stands_in_a_table_of_laws() {
    let mut seen = 0;
    for (interface, place) in NAMED {
        let tests: String = if project(place).is_file() {
            read(place)
        } else {
            rust_files(place).map(|(_, text)| text).collect()
        };
        let words: BTreeSet<_> = tests
            .split(|c: char| !(c.is_alphanumeric() || c == '_'))
            .collect();
        let implements = format!(" {interface} for ");
        for (file, text) in rust_files("src") {
            let heads = text.lines().filter(|line| line.starts_with("impl"));
            for head in heads.filter_map(|line| line.split_once(&implements)) {
                let name = head.1.split(|c: char| !c.is_alphanumeric()).next();
                let name = name.unwrap_or_default();
                if WRAPPERS.contains(&name) {
                    continue;
                }
                assert!(
                    words.contains(name),
                    "src/{file}: {name} is a {interface} that {place} does not name; see CONTRIBUTING.md"
                );
                seen += 1;
            }
        }
    }
    assert!(seen > 30, "the test must see them all; it saw {seen}");
}
