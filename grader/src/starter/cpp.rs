//! The starter in C++17: a file per chapter for the student, and the folder `raybook` with what these need.

use super::stub::{SHARED, comment, file, members, own_types, wrapped};
use super::{StarterFile, readme};
use crate::reader::cpp::{WORDS, class, read, reading, type_of};
use crate::reader::{Type, safe, types_of};
use raybook_workbook::curriculum::{CHAPTERS, Chapter};
use raybook_workbook::exercise::Asked;
use raybook_workbook::kind::{Field, Kind};
use std::fmt::Write;

/// What the generated files say first.
const OURS: &str = "raybook wrote this file; you need not change it.";

/// All files.
pub fn files() -> Vec<StarterFile> {
    let mut files = vec![
        file("raybook.toml", include_str!("cpp/raybook.toml")),
        file("Makefile", include_str!("cpp/Makefile")),
        file("CMakeLists.txt", include_str!("cpp/CMakeLists.txt")),
        file("CMakePresets.json", include_str!("cpp/CMakePresets.json")),
        file(".gitignore", "/build\n/out\n/.raybook\n"),
        file(
            "README.md",
            &readme(include_str!("cpp/README.md"), |chapter| {
                format!("{chapter}.cpp")
            }),
        ),
        file("raybook/vec.hpp", include_str!("cpp/vec.hpp")),
        file("raybook/words.hpp", &words()),
        file("raybook/answer.cpp", include_str!("cpp/answer.cpp")),
        file("raybook/exercises.hpp", include_str!("cpp/exercises.hpp")),
        file("raybook/exercises.cpp", &exercises()),
    ];
    for chapter in CHAPTERS {
        files.push(file(&format!("{}.cpp", chapter.name), &stubs(chapter)));
        files.push(file(
            &format!("raybook/{}.hpp", chapter.name),
            &header(chapter),
        ));
    }
    files
}

/// The types that all chapters share, each once.
fn shared() -> Vec<Type> {
    let mut shared: Vec<Type> = Vec::new();
    for found in CHAPTERS
        .iter()
        .flat_map(Chapter::exercises)
        .flat_map(types_of)
    {
        if SHARED.contains(&found.name()) && !shared.contains(&found) {
            shared.push(found);
        }
    }
    shared
}

/// How words become values of the shared types, and values words.
fn words() -> String {
    let mut text = format!(
        "// The words of questions and answers. {OURS}\n\n#pragma once\n\n#include \"vec.hpp\"\n\n#include <cmath>\n#include <cstdlib>\n#include <optional>\n#include <sstream>\n#include <string>\n#include <variant>\n#include <vector>\n\n{WORDS}"
    );
    for found in shared() {
        text.push_str(&reading(found));
    }
    text
}

/// The chapter's types, and its functions.
fn header(chapter: &Chapter) -> String {
    let mut text = format!(
        "// What the functions of chapter {} are given and return. {OURS}\n\n#pragma once\n\n#include \"vec.hpp\"\n\n#include <optional>\n#include <variant>\n#include <vector>\n\nnamespace {} {{\n",
        chapter.number(),
        chapter.name
    );
    for found in own_types(chapter) {
        text.push_str(&class(found));
    }
    text.push('\n');
    for asked in chapter.exercises() {
        let _ = writeln!(text, "{};", signature(asked));
    }
    text + "\n}\n"
}

/// The table of all functions: how their arguments are read, and their answers written.
fn exercises() -> String {
    let mut text = format!(
        "// All exercises. {OURS}\n\n#include \"exercises.hpp\"\n\n#include \"words.hpp\"\n\n"
    );
    for chapter in CHAPTERS {
        let _ = writeln!(text, "#include \"{}.hpp\"", chapter.name);
    }
    for chapter in CHAPTERS {
        let own = own_types(chapter);
        if !own.is_empty() {
            let _ = writeln!(
                text,
                "\nnamespace {} {{\n\nusing ::read;\nusing ::write;",
                chapter.name
            );
            for found in own {
                text.push_str(&reading(found));
            }
            text.push_str("\n}\n");
        }
    }
    text.push_str("\nconst std::map<std::string, Exercise> EXERCISES = {\n");
    for chapter in CHAPTERS {
        for asked in chapter.exercises() {
            let _ = writeln!(
                text,
                "    {{\"{}\", [](Words& words, std::ostream& out) {{\n        using namespace {};",
                asked.name, chapter.name
            );
            for field in asked.parameters() {
                let (kind, name) = (type_of(field.kind), variable(field));
                let _ = writeln!(text, "        {kind} {name}{{}};");
                let _ = write!(text, "    {}", read(field.kind, &name));
            }
            let names: Vec<_> = asked.parameters().iter().map(variable).collect();
            let _ = writeln!(
                text,
                "        words.end();\n        write(out, {}::{}({}));\n    }}}},",
                chapter.name,
                asked.name,
                names.join(", ")
            );
        }
    }
    text + "};\n"
}

/// A variable that has no function's name.
fn variable(field: &Field) -> String {
    format!("{}_", field.name)
}

/// The file that the student edits.
fn stubs(chapter: &Chapter) -> String {
    let mut text = format!(
        "// Chapter {}: {}.   Check it: raybook check ch{:02}\n\n#include \"raybook/{}.hpp\"\n\nnamespace {} {{\n",
        chapter.number(),
        chapter.title,
        chapter.number(),
        chapter.name,
        chapter.name
    );
    for asked in chapter.exercises() {
        text.push_str(&stub(asked));
    }
    text + END
}

/// The end of a chapter's namespace, and of its file.
pub(super) const END: &str = "\n}\n";

/// A function that is still to be written.
pub(super) fn stub(asked: &Asked) -> String {
    let names = asked.parameters().iter().map(|field| safe(field.name));
    let names: Vec<_> = names.collect();
    format!(
        "\n{}{}{} {{\n    todo(\"{}\", {}); // write it here\n}}\n",
        comment(asked, "// ", safe),
        notes(asked),
        signature(asked),
        asked.name,
        names.join(", ")
    )
}

/// What would have to be looked up: how an answer says that there is none, and the members of the types that are given and returned.
fn notes(asked: &Asked) -> String {
    let mut notes = Vec::new();
    if matches!(asked.answer.kind, Kind::Optional(_)) {
        notes.push("Where there is none: `return std::nullopt;`.".to_owned());
    }
    notes.extend(members(asked));
    let lines = notes.iter().map(|note| wrapped(note, "// ", "//     "));
    lines.collect()
}

/// The function up to its body.
pub fn signature(asked: &Asked) -> String {
    let one = |field: &Field| {
        let kind = match field.kind {
            Kind::Number | Kind::Whole => type_of(field.kind),
            kind => format!("const {}&", type_of(kind)),
        };
        format!("{kind} {}", safe(field.name))
    };
    let given: Vec<_> = asked.parameters().iter().map(one).collect();
    let answer = type_of(asked.answer.kind);
    let line = format!("{answer} {}({})", asked.name, given.join(", "));
    if line.len() <= 110 {
        return line;
    }
    format!("{answer} {}(\n    {})", asked.name, given.join(",\n    "))
}
