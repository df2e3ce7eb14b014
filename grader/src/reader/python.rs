//! The program in Python, from version 3.9 on.

use super::{Type, safe, types_of};
use raybook_workbook::exercise::Asked;
use raybook_workbook::kind::{Kind, VECTOR};
use std::fmt::Write;

/// Reading and writing words. What they are made of is imported before.
pub(crate) const WORDS: &str = r#"T = TypeVar("T")


class Words:
    """The words of a line, one after the other."""

    def __init__(self, line: str) -> None:
        self.rest = line.split()[::-1]  # the next is the last: it is taken away in no time

    def word(self) -> str:
        if not self.rest:
            raise ValueError("the line ends too early")
        return self.rest.pop()

    def number(self) -> float:
        return float(self.word())  # also inf and nan

    def numbers(self, count: int) -> List[float]:
        words = self.rest[: -count - 1 : -1]
        del self.rest[-count:]
        if len(words) < count:
            raise ValueError("the line ends too early")
        return [*map(float, words)]

    def whole(self) -> int:
        return int(self.word())

    def direction(self, vector: Callable[[float, float, float], T]) -> T:
        """A vector of length 1, from one of any length."""
        x, y, z = self.numbers(3)
        length = math.sqrt(x * x + y * y + z * z)
        if not 0 < length < math.inf:
            raise ValueError(f"{x} {y} {z} is no direction")
        return vector(x / length, y / length, z / length)

    def optional(self, read: Callable[[], T]) -> Optional[T]:
        if self.rest and self.rest[-1].lower() == "none":
            self.word()
            return None
        return read()

    def list(self, read: Callable[[], T]) -> List[T]:
        return [read() for _ in range(self.whole())]

    def choice(self, reads: Dict[str, Callable[[], Any]]) -> Any:
        word = self.word()
        if word not in reads:
            raise ValueError(f"`{word}` is none of {', '.join(reads)}")
        return reads[word]()

    def end(self) -> None:
        if self.rest:
            raise ValueError(f"`{self.rest[-1]}` is one word too many")


@functools.lru_cache(maxsize=None)
def fields_of(record: Any) -> List[Tuple[str, str]]:
    """The names of a record's fields, and what each is declared as."""
    fields = getattr(record, "__dataclass_fields__", {}).values()
    return [(field.name, str(field.type)) for field in fields]


def words_of(value: Any, declared: str, types: Mapping[str, Any]) -> str:
    """A value as the words of an answer. Where a list is declared, they begin with its length; all else is a row of numbers."""
    if type(value) in (float, int):  # nearly every value is one
        return str(value)
    if fields := fields_of(type(value)):
        return " ".join([words_of(getattr(value, name), kind, types) for name, kind in fields])
    if hasattr(value, "tolist"):  # numpy's numbers and arrays
        value = value.tolist()
    if value is None:
        return "none"
    if isinstance(value, bool):
        return str(int(value))
    if isinstance(value, (int, float, str)):
        return str(value)
    if isinstance(value, complex):
        raise ValueError(f"math domain error: {value} is complex, as the root of a negative number is")
    declared = declared.replace(" | None", "")
    is_list = declared.startswith("list[")
    if not isinstance(value, Iterable) or isinstance(value, dict if is_list else (dict, set)):
        raise TypeError(f"an answer has no {type(value).__name__} in it, such as {value!r:.60}")
    values = list(value)
    if is_list:
        kinds = [declared[len("list[") : -1]] * len(values)
    else:
        kinds = [kind for _, kind in fields_of(types.get(declared))]
        if len(kinds) != len(values):  # other parts than the record's: what is a list stays one
            kinds = ["list[]" if isinstance(one, list) else "" for one in values]
    words = [words_of(one, kind, types) for one, kind in zip(values, kinds)]
    return " ".join([str(len(values)), *words] if is_list else words)
"#;

/// The program that answers an exercise.
pub fn program(asked: &Asked) -> String {
    let name = asked.name;
    let mut text = format!(
        "\"\"\"{name}: {task}\n\nAsk it: raybook check {name} --program this_file.py\n\"\"\"\n\nfrom __future__ import annotations\n\nimport functools\nimport math\nimport sys\nfrom dataclasses import dataclass\nfrom typing import Any, Callable, Dict, Iterable, List, Mapping, Optional, Tuple, TypeVar, Union\n\n{WORDS}",
        task = asked.task,
    );
    for found in types_of(asked) {
        text.push_str(&class(found));
    }
    let question = type_of(asked.question);
    let _ = write!(
        text,
        r#"

def {name}(q: {question}) -> {answer}:
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
            print("=", words_of({name}(question), "{answer}", globals()), file=answers, flush=True)
        except NotImplementedError:
            print("= todo {name}", file=answers, flush=True)


if __name__ == "__main__":
    main()
"#,
        answer = type_of(asked.answer.kind),
        task = asked.task,
        meaning = asked.answer.meaning,
        read = read(asked.question, "Words(rest)"),
    );
    text
}

/// The class of a type, and how it is read.
pub(crate) fn class(found: Type) -> String {
    let mut text = format!("\n\n@dataclass\nclass {}:\n", found.name());
    let mut reads = Vec::new();
    match found {
        Type::Numbers(_, parts) => {
            for part in parts {
                let _ = writeln!(text, "    {}: float", safe(part));
            }
            reads.push(format!("*words.numbers({})", parts.len()));
        }
        Type::Record(record) => {
            for field in record.fields {
                let kind = type_of(field.kind);
                let _ = writeln!(
                    text,
                    "    {}: {kind}  # {}",
                    safe(field.name),
                    field.meaning
                );
                reads.push(read(field.kind, "words"));
            }
        }
    }
    let _ = write!(
        text,
        "\n    @staticmethod\n    def read(words: Words) -> {name}:\n        return {name}({reads})\n",
        name = found.name(),
        reads = reads.join(", ")
    );
    text
}

/// The type of a kind, as an annotation.
pub(crate) fn type_of(kind: &Kind) -> String {
    match kind {
        Kind::Number => "float".to_owned(),
        Kind::Whole => "int".to_owned(),
        Kind::Numbers(parts) => parts.name.to_owned(),
        Kind::Direction => VECTOR.name.to_owned(),
        Kind::Optional(kind) => format!("{} | None", type_of(kind)),
        Kind::List(kind) => format!("list[{}]", type_of(kind)),
        Kind::Record(record) => record.name.to_owned(),
        Kind::Choice(choices) => {
            let choices: Vec<_> = choices.iter().map(|(_, kind)| type_of(kind)).collect();
            choices.join(" | ")
        }
    }
}

/// The expression that reads a value of a kind from these words.
pub(crate) fn read(kind: &Kind, words: &str) -> String {
    match kind {
        Kind::Number => format!("{words}.number()"),
        Kind::Whole => format!("{words}.whole()"),
        Kind::Numbers(parts) => format!("{}.read({words})", parts.name),
        Kind::Direction => format!("{words}.direction({})", VECTOR.name),
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
