//! The program in C++17.

use super::{Type, safe, types};
use raybook_workbook::exercise::Asked;
use raybook_workbook::kind::{Kind, VECTOR};
use std::fmt::Write;

const WORDS: &str = r#"// The words of a line, one after the other.
struct Words {
    std::istringstream rest;

    std::string word() {
        std::string word;
        rest >> word;
        return word;
    }
};

inline void read(Words& words, double& value) { value = std::stod(words.word()); } // also inf and nan

inline void read(Words& words, unsigned& value) { value = static_cast<unsigned>(std::stoul(words.word())); }

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
    let mut all = Vec::new();
    types(asked.question, &mut all);
    types(asked.answer.kind, &mut all);
    let name = asked.name;
    let mut text = format!(
        "// {name}: {task}\n//\n// g++ -std=c++17 -O2 this_file.cpp -o answer && raybook check {name} --program ./answer\n\n",
        task = asked.task,
    );
    for header in [
        "iomanip", "iostream", "limits", "optional", "sstream", "string", "variant", "vector",
    ] {
        let _ = writeln!(text, "#include <{header}>");
    }
    text.push('\n');
    text.push_str(WORDS);
    for found in all {
        text.push_str(&class(found));
    }
    let _ = write!(
        text,
        r#"
// What is thrown by what is not written yet.
struct NotWritten {{}};

// Returns: {meaning}
{head} {{
    (void)q;
    throw NotWritten{{}}; // write it here
}}

int main() {{
    // What else is written to std::cout goes to standard error, so that it does not mix with the answers.
    std::ostream answers(std::cout.rdbuf(std::cerr.rdbuf()));
    answers << std::setprecision(std::numeric_limits<double>::max_digits10);
    for (std::string line; std::getline(std::cin, line);) {{
        Words words{{std::istringstream(line)}};
        const std::string name = words.word();
        std::ostringstream said;
        said.copyfmt(answers);
        try {{
            if (name != "{name}") {{
                throw NotWritten{{}};
            }}
            {question} question;
            read(words, question);
            write(said, {name}(question));
        }} catch (const NotWritten&) {{
            said.str(" todo " + name);
        }}
        answers << "=" << said.str() << std::endl;
    }}
}}
"#,
        meaning = asked.answer.meaning,
        head = head(asked),
        question = type_of(asked.question),
    );
    text
}

/// What the student writes: the structs, and the function.
pub fn signature(asked: &Asked) -> String {
    let mut all = Vec::new();
    types(asked.question, &mut all);
    types(asked.answer.kind, &mut all);
    let structs: Vec<_> = all.into_iter().map(declaration).collect();
    format!("{}\n{};\n", structs.join("\n"), head(asked))
}

/// The function up to its body.
fn head(asked: &Asked) -> String {
    format!(
        "{} {}(const {}& q)",
        type_of(asked.answer.kind),
        asked.name,
        type_of(asked.question)
    )
}

/// The struct of a type.
fn declaration(found: Type) -> String {
    let mut text = format!("struct {} {{\n", found.name());
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

/// The struct of a type, and how it is read and written.
fn class(found: Type) -> String {
    let name = found.name();
    let members: Vec<_> = match found {
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
    let mut text = format!(
        "\n{}\ninline void read(Words& words, {name}& value) {{\n",
        declaration(found)
    );
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

fn type_of(kind: &Kind) -> String {
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

/// The statement that reads a member; a choice has a word of its own for each type.
fn read(kind: &Kind, member: &str) -> String {
    let Kind::Choice(choices) = kind else {
        return format!("    read(words, {member});\n");
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
