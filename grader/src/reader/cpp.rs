//! The program in C++17.

use super::{Type, safe, types_of};
use raybook_workbook::exercise::Asked;
use raybook_workbook::kind::{Kind, VECTOR};
use std::fmt::Write;

/// Reading and writing words, after the headers that these take.
pub(crate) const WORDS: &str = r#"// A line that is no question, and why.
struct NoQuestion {
    std::string why;
};

// The words of a line, one after the other.
struct Words {
    std::istringstream rest;

    std::string word() {
        std::string word;
        if (!(rest >> word)) {
            throw NoQuestion{"the line ends too early"};
        }
        return word;
    }

    void end() {
        std::string word;
        if (rest >> word) {
            throw NoQuestion{"`" + word + "` is one word too many"};
        }
    }
};

inline void read(Words& words, double& value) {
    const std::string word = words.word();
    char* end = nullptr;
    value = std::strtod(word.c_str(), &end); // unlike >>, it reads inf and nan too
    if (*end != '\0') {
        throw NoQuestion{"`" + word + "` is no number"};
    }
}

inline void read(Words& words, unsigned& value) {
    const std::string word = words.word();
    char* end = nullptr;
    value = static_cast<unsigned>(std::strtoul(word.c_str(), &end, 10));
    if (*end != '\0') {
        throw NoQuestion{"`" + word + "` is no whole number"};
    }
}

// A vector of length 1, from one of any length.
template <class Vector> void read_direction(Words& words, Vector& value) {
    read(words, value.x);
    read(words, value.y);
    read(words, value.z);
    const double length = std::sqrt(value.x * value.x + value.y * value.y + value.z * value.z);
    value.x /= length;
    value.y /= length;
    value.z /= length;
}

template <class T> void read(Words& words, std::optional<T>& value);

template <class T> void read(Words& words, std::vector<T>& values) {
    unsigned count = 0;
    read(words, count);
    values.clear();
    for (unsigned i = 0; i < count; i++) {
        values.emplace_back();
        read(words, values.back());
    }
}

template <class T> void read(Words& words, std::optional<T>& value) {
    const auto before = words.rest.tellg();
    const std::string word = words.word();
    if (word == "none" || word == "None") {
        value.reset();
    } else {
        words.rest.clear();
        words.rest.seekg(before);
        value.emplace();
        read(words, *value);
    }
}

inline void write(std::ostream& out, double value) { out << ' ' << value; }

inline void write(std::ostream& out, unsigned value) { out << ' ' << value; }

template <class T> void write(std::ostream& out, const std::optional<T>& value);

template <class T> void write(std::ostream& out, const std::vector<T>& values) {
    write(out, static_cast<unsigned>(values.size()));
    for (const T& value : values) {
        write(out, value);
    }
}

template <class T> void write(std::ostream& out, const std::optional<T>& value) {
    if (value) {
        write(out, *value);
    } else {
        out << " none";
    }
}
"#;

/// The program that answers an exercise.
pub fn program(asked: &Asked) -> String {
    let name = asked.name;
    let mut text = format!(
        "// {name}: {task}\n//\n// g++ -std=c++17 -O2 this_file.cpp -o answer && raybook check {name} --program ./answer\n\n",
        task = asked.task,
    );
    for header in [
        "cmath", "cstdlib", "iomanip", "iostream", "limits", "optional", "sstream", "string",
        "variant", "vector",
    ] {
        let _ = writeln!(text, "#include <{header}>");
    }
    text.push('\n');
    text.push_str(WORDS);
    for found in types_of(asked) {
        text.push_str(&class(found));
        text.push_str(&reading(found));
    }
    let _ = write!(
        text,
        r#"
// What is thrown by what is not written yet.
struct NotWritten {{}};

// Returns: {meaning}
{answer} {name}(const {question}& q) {{
    (void)q;
    throw NotWritten{{}}; // write it here
}}

int main() {{
    // What else is written to std::cout goes to standard error, so that it does not mix with the answers.
    std::ostream answers(std::cout.rdbuf(std::cerr.rdbuf()));
    answers << std::setprecision(std::numeric_limits<double>::max_digits10);
    for (std::string line; std::getline(std::cin, line);) {{
        Words words{{std::istringstream(line)}};
        std::ostringstream said;
        said.copyfmt(answers);
        std::string name;
        try {{
            name = words.word();
            if (name != "{name}") {{
                throw NotWritten{{}};
            }}
            {question} question;
            read(words, question);
            write(said, {name}(question));
        }} catch (const NotWritten&) {{
            said.str(" todo " + name);
        }} catch (const NoQuestion& no) {{
            said.str(" error " + no.why);
        }}
        answers << "=" << said.str() << std::endl;
    }}
}}
"#,
        meaning = asked.answer.meaning,
        answer = type_of(asked.answer.kind),
        question = type_of(asked.question),
    );
    text
}

/// The struct of a type.
pub(crate) fn class(found: Type) -> String {
    let mut text = format!("\nstruct {} {{\n", found.name());
    match found {
        Type::Numbers(_, parts) => {
            for part in parts {
                let _ = writeln!(text, "    double {} = 0;", safe(part));
            }
        }
        Type::Record(record) => {
            for field in record.fields {
                let (kind, name) = (type_of(field.kind), safe(field.name));
                let _ = writeln!(text, "    {kind} {name}{{}}; // {}", field.meaning);
            }
        }
    }
    text.push_str("};\n");
    text
}

/// How a type is read, and written.
pub(crate) fn reading(found: Type) -> String {
    let name = found.name();
    let members: Vec<(String, Kind)> = match found {
        Type::Numbers(_, parts) => {
            let parts = parts.iter();
            parts.map(|part| (safe(part), Kind::Number)).collect()
        }
        Type::Record(record) => {
            let fields = record.fields.iter();
            fields
                .map(|field| (safe(field.name), *field.kind))
                .collect()
        }
    };
    let mut text = format!("\ninline void read(Words& words, {name}& value) {{\n");
    for (member, kind) in &members {
        text.push_str(&read(kind, &format!("value.{member}")));
    }
    let _ = write!(
        text,
        "}}\n\ninline void write(std::ostream& out, const {name}& value) {{\n"
    );
    for (member, kind) in &members {
        text.push_str(&write(kind, &format!("value.{member}")));
    }
    text.push_str("}\n");
    text
}

/// The type of a kind.
pub(crate) fn type_of(kind: &Kind) -> String {
    match kind {
        Kind::Number => "double".to_owned(),
        Kind::Whole => "unsigned".to_owned(),
        Kind::Numbers(parts) => parts.name.to_owned(),
        Kind::Direction => VECTOR.name.to_owned(),
        Kind::Optional(kind) => format!("std::optional<{}>", type_of(kind)),
        Kind::List(kind) => format!("std::vector<{}>", type_of(kind)),
        Kind::Record(record) => record.name.to_owned(),
        Kind::Choice(choices) => {
            let choices: Vec<_> = choices.iter().map(|(_, kind)| type_of(kind)).collect();
            format!("std::variant<{}>", choices.join(", "))
        }
    }
}

/// The statement that reads a variable; a choice has a word of its own for each type.
pub(crate) fn read(kind: &Kind, member: &str) -> String {
    let choices = match kind {
        Kind::Choice(choices) => choices,
        Kind::Direction => return format!("    read_direction(words, {member});\n"),
        _ => return format!("    read(words, {member});\n"),
    };
    let mut text = format!(
        "    {{\n        const std::string word = words.word();\n        {member} = {{}};\n"
    );
    for (i, (word, _)) in choices.iter().enumerate() {
        let _ = write!(
            text,
            "        if (word == \"{word}\") {{\n            read(words, {member}.emplace<{i}>());\n        }}\n"
        );
    }
    text.push_str("    }\n");
    text
}

/// The statement that writes a member.
fn write(kind: &Kind, member: &str) -> String {
    let Kind::Choice(choices) = kind else {
        return format!("    write(out, {member});\n");
    };
    let words: Vec<_> = choices
        .iter()
        .map(|(word, _)| format!("\" {word}\""))
        .collect();
    format!(
        "    {{\n        const char* const words[] = {{{}}};\n        out << words[{member}.index()];\n        std::visit([&](const auto& chosen) {{ write(out, chosen); }}, {member});\n    }}\n",
        words.join(", ")
    )
}
