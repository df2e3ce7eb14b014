//! The starter in Python: a file per chapter for the student, and the folder `raybook` with what these need.

use super::stub::{SHARED, comment, file, members, own_types, wrapped};
use super::{StarterFile, readme};
use crate::book::WIDEST;
use crate::reader::python::{WORDS, class, read, type_of};
use crate::reader::{Type, safe, types_of};
use raybook_workbook::curriculum::{CHAPTERS, Chapter};
use raybook_workbook::exercise::Asked;
use raybook_workbook::kind::Field;
use std::collections::BTreeSet;
use std::fmt::Write;

/// Functions of Python that students call: no parameter hides them.
const BUILT_IN: [&str; 2] = ["max", "min"];

/// What `words.py` takes of the standard library.
const IMPORTS: &str = "\"\"\"The words of questions and answers. raybook wrote this file; you need not change it.\"\"\"

from __future__ import annotations

import functools
import math
from typing import Any, Callable, Dict, Iterable, List, Mapping, Optional, Tuple, TypeVar
";

/// All files.
pub fn files() -> Vec<StarterFile> {
    let mut files = vec![
        file("raybook.toml", include_str!("python/raybook.toml")),
        file("pyproject.toml", include_str!("python/pyproject.toml")),
        file(".gitignore", "__pycache__/\n/out\n/.raybook\n"),
        file(
            "README.md",
            &readme(include_str!("python/README.md"), |chapter| {
                format!("{chapter}.py")
            }),
        ),
        file("answer.py", include_str!("python/answer.py")),
        file("raybook/__init__.py", ""),
        file("raybook/vec.py", include_str!("python/vec.py")),
        file("raybook/batch.py", include_str!("python/batch.py")),
        file("raybook/words.py", &format!("{IMPORTS}\n{WORDS}")),
        file("raybook/exercises.py", &exercises()),
    ];
    for chapter in CHAPTERS {
        files.push(file(&format!("{}.py", chapter.name), &stubs(chapter)));
        files.push(file(
            &format!("raybook/{}.py", types_module(chapter)),
            &types(chapter),
        ));
    }
    files
}

/// The module of a chapter's types: `ch03_types`.
fn types_module(chapter: &Chapter) -> String {
    format!("ch{:02}_types", chapter.number())
}

/// A name that hides nothing that a student needs.
fn parameter(name: &str) -> String {
    if BUILT_IN.contains(&name) {
        format!("{name}_")
    } else {
        safe(name)
    }
}

/// In which chapter an exercise is.
fn exercises() -> String {
    let mut text = "\"\"\"In which file each exercise is written. raybook wrote this file; you need not change it.\"\"\"\n\nCHAPTERS = {\n".to_owned();
    for chapter in CHAPTERS {
        for asked in chapter.exercises() {
            let _ = writeln!(
                text,
                "    \"{}\": (\"{}\", \"raybook.{}\"),",
                asked.name,
                chapter.name,
                types_module(chapter)
            );
        }
    }
    text + "}\n"
}

/// The shared types that a chapter uses.
fn shared(chapter: &Chapter) -> Vec<&'static str> {
    let types = chapter.exercises().iter().flat_map(types_of);
    let names: BTreeSet<_> = types.map(Type::name).collect();
    names
        .into_iter()
        .filter(|name| SHARED.contains(name))
        .collect()
}

fn import(module: &str, names: &[&str]) -> String {
    if names.is_empty() {
        return String::new();
    }
    format!("from {module} import {}\n", names.join(", "))
}

/// The chapter's types, and how the arguments of its functions are read.
fn types(chapter: &Chapter) -> String {
    let (own, shared) = (own_types(chapter), shared(chapter));
    let mut text = format!(
        "\"\"\"What the functions of chapter {} are given and return. raybook wrote this file; you need not change it.\"\"\"\n\nfrom __future__ import annotations\n\n",
        chapter.number()
    );
    if !own.is_empty() {
        text.push_str("from dataclasses import dataclass\n");
    }
    text.push_str("from typing import Any, Callable, Dict, Tuple\n\n");
    text.push_str(&import(".vec", &shared));
    text.push_str("from .words import Words\n");
    for found in own {
        text.push_str(&class(found));
    }
    text.push_str(
        "\n\n# How the arguments of each function are read.\nARGUMENTS: Dict[str, Callable[[Words], Tuple[Any, ...]]] = {\n",
    );
    for asked in chapter.exercises() {
        let _ = writeln!(text, "    \"{}\": lambda words: (", asked.name);
        for field in asked.parameters() {
            let _ = writeln!(text, "        {},", read(field.kind, "words"));
        }
        text.push_str("    ),\n");
    }
    text.push_str("}\n\n# What each function returns.\nANSWERS: Dict[str, str] = {\n");
    for asked in chapter.exercises() {
        let answer = type_of(asked.answer.kind);
        let _ = writeln!(text, "    \"{}\": \"{answer}\",", asked.name);
    }
    text + "}\n"
}

/// The file that the student edits.
fn stubs(chapter: &Chapter) -> String {
    let (own, shared) = (own_types(chapter), shared(chapter));
    let own: Vec<_> = own.iter().map(|found| found.name()).collect();
    let mut text = format!(
        "\"\"\"Chapter {}: {}.   Check it: raybook check ch{:02}\"\"\"\n\nfrom __future__ import annotations\n\n",
        chapter.number(),
        chapter.title,
        chapter.number()
    );
    text.push_str(&import(&format!("raybook.{}", types_module(chapter)), &own));
    text.push_str(&import("raybook.vec", &shared));
    for asked in chapter.exercises() {
        text.push_str(&stub(asked));
    }
    text
}

/// The function's head, up to its colon: on one line if it is no wider than a listing of the book.
pub fn signature(asked: &Asked) -> String {
    let one = |field: &Field| format!("{}: {}", parameter(field.name), type_of(field.kind));
    let given: Vec<_> = asked.parameters().iter().map(one).collect();
    let answer = type_of(asked.answer.kind);
    let line = format!("def {}({}) -> {answer}:", asked.name, given.join(", "));
    if line.len() <= WIDEST {
        return line;
    }
    format!(
        "def {}(\n    {},\n) -> {answer}:",
        asked.name,
        given.join(",\n    ")
    )
}

/// A function that is still to be written.
pub(super) fn stub(asked: &Asked) -> String {
    let signature = signature(asked);
    let mut comment = comment(asked, "    ", parameter);
    if let Some(members) = members(asked) {
        comment.push_str(&wrapped(&members, "    ", "        "));
    }
    format!(
        "\n\n{signature}\n    \"\"\"{}    \"\"\"\n    raise NotImplementedError(\"{}\")  # write it here\n",
        comment.trim_start(),
        asked.name
    )
}
