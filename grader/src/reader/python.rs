//! The program in Python, from version 3.9 on.

use super::{Type, safe, types};
use raybook_workbook::exercise::Asked;
use raybook_workbook::kind::{Kind, VECTOR};
use std::fmt::Write;

const WORDS: &str = r#"class Words:
    """The words of a line, one after the other."""

    def __init__(self, line: str):
        self.rest = line.split()

    def word(self) -> str:
        return self.rest.pop(0)

    def number(self) -> float:
        return float(self.word())  # also inf and nan

    def whole(self) -> int:
        return int(self.word())

    def optional(self, read):
        if self.rest[0].lower() == "none":
            self.word()
            return None
        return read()

    def list(self, read) -> list:
        return [read() for _ in range(self.whole())]

    def choice(self, reads) -> tuple:
        word = self.word()
        return word, reads[word]()


def words_of(value) -> str:
    """A value as the words of an answer."""
    if value is None:
        return "none"
    if isinstance(value, bool):
        return str(int(value))
    if isinstance(value, list):
        return " ".join([str(len(value)), *map(words_of, value)])
    if hasattr(value, "__dataclass_fields__"):
        return " ".join(words_of(getattr(value, name)) for name in value.__dataclass_fields__)
    if isinstance(value, tuple):
        return " ".join(map(words_of, value))
    return str(value)
"#;

/// The program that answers an exercise.
pub fn program(asked: &Asked) -> String {
    let mut all = Vec::new();
    types(asked.question, &mut all);
    types(asked.answer.kind, &mut all);
    let name = asked.name;
    let mut text = format!(
        "\"\"\"{name}: {task}\n\nAsk it: raybook check {name} --program this_file.py\n\"\"\"\n\nfrom __future__ import annotations\n\nimport sys\nfrom dataclasses import dataclass\nfrom typing import Any\n\n\n{WORDS}",
        task = asked.task,
    );
    for found in all {
        text.push_str(&class(found));
    }
    let _ = write!(
        text,
        r#"

{head}:
    """{task}

    Returns {meaning}
    """
    raise NotImplementedError  # write it here


def main():
    # What else is printed goes to standard error, so that it does not mix with the answers.
    answers, sys.stdout = sys.stdout, sys.stderr
    for line in sys.stdin:
        name, _, rest = line.strip().partition(" ")
        if name != "{name}":
            print("= todo", name, file=answers, flush=True)
            continue
        question = {read}
        try:
            print("=", words_of({name}(question)), file=answers, flush=True)
        except NotImplementedError:
            print("= todo {name}", file=answers, flush=True)


if __name__ == "__main__":
    main()
"#,
        head = head(asked),
        task = asked.task,
        meaning = asked.answer.meaning,
        read = read(asked.question, "Words(rest)"),
    );
    text
}

/// What the student writes: the classes, and the function.
pub fn signature(asked: &Asked) -> String {
    let mut all = Vec::new();
    types(asked.question, &mut all);
    types(asked.answer.kind, &mut all);
    let classes: Vec<_> = all.into_iter().map(declaration).collect();
    format!("{}\n\n{}: ...\n", classes.join("\n\n"), head(asked))
}

/// The function up to its body.
fn head(asked: &Asked) -> String {
    format!(
        "def {}(q: {}) -> {}",
        asked.name,
        type_of(asked.question),
        type_of(asked.answer.kind)
    )
}

/// The fields of a type.
fn declaration(found: Type) -> String {
    let mut text = format!("@dataclass\nclass {}:\n", found.name());
    match found {
        Type::Numbers(_, parts) => {
            for part in parts {
                let _ = writeln!(text, "    {}: float", safe(part));
            }
        }
        Type::Record(record) => {
            for field in record.fields {
                let (name, kind) = (safe(field.name), type_of(field.kind));
                let _ = writeln!(text, "    {name}: {kind}  # {}", field.meaning);
            }
        }
    }
    text
}

/// The class of a type, and how it is read.
fn class(found: Type) -> String {
    let reads: Vec<_> = match found {
        Type::Numbers(_, parts) => parts.iter().map(|_| read(&Kind::Number, "words")).collect(),
        Type::Record(record) => {
            let fields = record.fields.iter();
            fields.map(|field| read(field.kind, "words")).collect()
        }
    };
    format!(
        "\n\n{class}\n    @staticmethod\n    def read(words: Words) -> {name}:\n        return {name}({reads})\n",
        class = declaration(found),
        name = found.name(),
        reads = reads.join(", ")
    )
}

fn type_of(kind: &Kind) -> String {
    match kind {
        Kind::Number => "float".to_owned(),
        Kind::Whole => "int".to_owned(),
        Kind::Numbers(parts) => parts.name.to_owned(),
        Kind::Direction => VECTOR.name.to_owned(),
        Kind::Optional(kind) => format!("{} | None", type_of(kind)),
        Kind::List(kind) => format!("list[{}]", type_of(kind)),
        Kind::Record(record) => record.name.to_owned(),
        Kind::Choice(_) => "tuple[str, Any]".to_owned(),
    }
}

fn read(kind: &Kind, words: &str) -> String {
    match kind {
        Kind::Number => format!("{words}.number()"),
        Kind::Whole => format!("{words}.whole()"),
        Kind::Numbers(parts) => format!("{}.read({words})", parts.name),
        Kind::Direction => format!("{}.read({words})", VECTOR.name),
        Kind::Optional(kind) => format!("{words}.optional(lambda: {})", read(kind, words)),
        Kind::List(kind) => format!("{words}.list(lambda: {})", read(kind, words)),
        Kind::Record(record) => format!("{}.read({words})", record.name),
        Kind::Choice(choices) => {
            let choice =
                |(word, kind): &(&str, &Kind)| format!("\"{word}\": lambda: {}", read(kind, words));
            let choices: Vec<_> = choices.iter().map(choice).collect();
            format!("{words}.choice({{{}}})", choices.join(", "))
        }
    }
}
