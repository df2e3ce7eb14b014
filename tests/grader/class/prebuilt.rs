//! What is compiled of the starter in C++ once for the class.

use raybook_grader::class::files::Files;
use raybook_grader::inside::class::{standard_headers, unchanged};
use raybook_grader::starter::cpp;
use raybook_workbook::curriculum::CHAPTERS;

#[test]
fn what_is_written_anew_is_not_taken_from_the_starter() {
    let starter = cpp::files();
    let handed_in = |changed: &str| -> Files {
        let file = |(path, bytes): &(std::path::PathBuf, Vec<u8>)| {
            let name = path.display().to_string();
            let more: &[u8] = if name == changed { b"//\n" } else { b"" };
            (name, [bytes, more].concat())
        };
        starter.iter().map(file).collect()
    };
    let all = unchanged(&starter, &handed_in("")).len();
    let chapters = CHAPTERS.len();
    assert_eq!(all, chapters + 2, "with the answer loop and the exercises");
    for (changed, taken) in [
        ("README.md", all),
        ("ch03_sphere.cpp", all - 1),
        ("raybook/exercises.cpp", all - 1),
        ("raybook/vec.hpp", 0),
    ] {
        let given = unchanged(&starter, &handed_in(changed));
        assert_eq!(given.len(), taken, "{changed} is changed");
        assert!(!given.contains(&changed.as_ref()), "{changed}");
    }
}

#[test]
fn what_chapters_and_many_students_include_is_compiled_before() {
    let headers = standard_headers(&cpp::files());
    for name in [
        "cmath",
        "optional",
        "string",
        "variant",
        "vector",
        "algorithm",
        "queue",
    ] {
        let line = format!("#include <{name}>\n");
        assert_eq!(headers.matches(&line).count(), 1, "{name} in\n{headers}");
    }
}
