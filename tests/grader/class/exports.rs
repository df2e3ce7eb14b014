//! What others read, read by parsers that are not ours.

use super::{Course, RIGHT, text, visible_only, wrong_sign};
use csv::ReaderBuilder;
use raybook_grader::class::export;
use raybook_grader::class::grades::Known;
use raybook_grader::class::roll::{Class, Roll};
use raybook_grader::class::similar::Pair;
use raybook_grader::class::when::Timestamp;
use roxmltree::Document;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;

/// A name that means something to a browser, a table, a page and a terminal.
pub(super) const NAME: &str = "=cmd|' <b>\"x\", & y?#\u{202e}%41";

const COURSE: &str = "title = 'Rays <1> & \"2\", 3'\nterm = '<now>'\n[[chapter]]\nchapter = 'ch01'\nweight = 2\nexercises = { ray_at = 3 }\nbonus = ['camera_ray']\n";

pub(super) fn class() -> Course {
    let course = Course::new(COURSE);
    course.hand_in(&format!("{NAME}/answer.py"), RIGHT);
    course.hand_in("wrong/answer.py", &wrong_sign());
    course.hand_in("memory/answer.py", &visible_only());
    course.hand_in("refused/none.txt", "");
    let evil = "import sys\nfor line in sys.stdin: print('= panic <script>alert(1)</script> & \\x1b[2J \\x00 \\u202e', flush=True)\n";
    course.hand_in("evil/answer.py", evil);
    course.hand_in(
        "broken/main.cpp",
        "int main() {\n    return 100 % none;\n}\n",
    );
    course.hand_in("ended/answer.py", "import sys\n\ndef x(:\n");
    let (code, said) = course.grade(&[]);
    assert_eq!(code, Some(0), "{said}");
    course
}

/// The rows of a table by their first field, and its heading.
fn table(course: &Course, file: &str) -> (Vec<String>, BTreeMap<String, Vec<String>>) {
    let text = text(&course.path(&format!("results/{file}")));
    let mut reader = ReaderBuilder::new()
        .flexible(false)
        .from_reader(text.as_bytes());
    let fields = |record: &csv::StringRecord| record.iter().map(str::to_owned).collect::<Vec<_>>();
    let head = fields(reader.headers().expect("a heading"));
    let rows = reader
        .records()
        .map(|record| fields(&record.expect("as many fields as the heading has")));
    (head, rows.map(|row| (row[0].clone(), row)).collect())
}

#[test]
fn everything_that_is_exported_can_be_read() {
    let course = class();
    tables(&course);
    junit(&course);
    gradescope(&course);
    exercism(&course);
    annotations(&course);
    grade(&course);
}

fn tables(course: &Course) {
    let shown = "'=cmd|' <b>\"x\", & y?#\\u{202e}%41";

    let (head, rows) = table(course, "grades.csv");
    assert_eq!(head[..3], ["student", "points", "of"]);
    assert_eq!(rows.len(), 7);
    assert_eq!(
        rows[shown][1..4],
        ["6", "6", "yes"],
        "what a spreadsheet would compute is a text"
    );
    let column = head
        .iter()
        .position(|name| name == "ray_at")
        .expect("a column for each exercise");
    assert_eq!(rows[shown][column], "3");
    let (head, rows) = table(course, "moodle.csv");
    assert_eq!(head, ["username", "Rays <1> & \"2\", 3", "feedback"]);
    assert_eq!(rows[shown][1], "6");
    assert!(rows["refused"][2].contains("no source file"), "{rows:?}");
    let (head, rows) = table(course, "canvas.csv");
    assert_eq!(
        head[..5],
        ["Student", "ID", "SIS User ID", "SIS Login ID", "Section"]
    );
    assert_eq!(rows["    Points Possible"][5], "6");
    assert_eq!(rows[shown][5], "6");
    let items = text(&course.path("results/items.csv"));
    for line in [
        "ray_at,standing,right on the visible cases only,1",
        "ray_at,standing,right,1",
        "ray_at,wrong case,random 1,",
    ] {
        assert!(items.contains(line), "{line}: {items}");
    }
    assert!(
        items
            .lines()
            .any(|line| line.starts_with("ray_at,mistake,") && line.ends_with(",1")),
        "{items}"
    );
}

fn junit(course: &Course) {
    let report = text(&course.path("results/junit.xml"));
    let report = Document::parse(&report).expect("it is XML");
    let suites: Vec<_> = report
        .root_element()
        .children()
        .filter(|node| node.has_tag_name("testsuite"))
        .collect();
    assert_eq!(suites.len(), 7);
    for suite in suites {
        let cases: Vec<_> = suite
            .children()
            .filter(|node| node.has_tag_name("testcase"))
            .collect();
        let count = |tag: &str| {
            cases
                .iter()
                .filter(|case| case.children().any(|node| node.has_tag_name(tag)))
                .count()
        };
        for (attribute, counted) in [
            ("tests", cases.len()),
            ("failures", count("failure")),
            ("errors", count("error")),
            ("skipped", count("skipped")),
        ] {
            assert_eq!(
                suite.attribute(attribute),
                Some(counted.to_string().as_str()),
                "{attribute} of {suite:?}"
            );
        }
        assert!(cases.iter().all(|case| case.attribute("name").is_some()
            && case.attribute("classname") == Some("ch01_rays")));
    }
}

/// The fields that Gradescope's documentation names, and no others.
fn gradescope(course: &Course) {
    for student in [NAME, "wrong", "memory", "refused", "evil"] {
        let results = course.json(&format!("results/students/{student}/results.json"));
        assert!(results["score"].is_number(), "{results:#}");
        for test in results["tests"].as_array().expect("tests") {
            let fields = test.as_object().expect("a test");
            for (name, value) in fields {
                match name.as_str() {
                    "score" | "max_score" => {
                        assert!(value.as_f64().is_some_and(|score| score >= 0.0));
                    }
                    "status" => assert!(value == "passed" || value == "failed"),
                    "visibility" => assert!(
                        ["visible", "hidden", "after_due_date", "after_published"]
                            .iter()
                            .any(|word| value == word)
                    ),
                    "output_format" => assert!(value == "text"),
                    "name" | "number" | "output" => assert!(value.is_string()),
                    other => panic!("Gradescope knows no {other}"),
                }
            }
        }
    }
    let gradescope = course.json(&format!("results/students/{NAME}/results.json"));
    assert_eq!(
        (
            gradescope["score"].as_f64(),
            gradescope["tests"][0]["max_score"].as_f64()
        ),
        (Some(6.0), Some(6.0))
    );
}

/// Reads the results of a test runner as strictly as Exercism's interface, version 3, is written
/// (<https://exercism.org/docs/building/tooling/test-runners/interface>): every field that must be there, and no others.
///
/// # Panics
/// If something else is written.
fn read_exercism(results: &Value) {
    const LONGEST: usize = 65_535;
    let text = |value: &Value| value.as_str().expect("a text").to_owned();
    let message = |value: &Value, must: bool| match value {
        Value::Null => assert!(!must, "a message is missing: {results:#}"),
        value => assert!((1..=LONGEST).contains(&text(value).len())),
    };
    let top = results.as_object().expect("an object");
    assert!(
        top.keys()
            .all(|name| ["version", "status", "message", "tests"].contains(&name.as_str()))
    );
    assert_eq!(results["version"], 3);
    let tests = results["tests"].as_array().expect("tests");
    assert!(!tests.is_empty(), "somebody is asked something");
    let mut statuses = Vec::new();
    for test in tests {
        for (name, value) in test.as_object().expect("a test") {
            match name.as_str() {
                "name" | "status" | "test_code" => assert!(!text(value).is_empty()),
                "message" => {}
                "output" => assert!(text(value).chars().count() <= 500),
                "task_id" => assert!(value.as_u64().is_some_and(|id| id > 0)),
                other => panic!("Exercism knows no {other}"),
            }
        }
        assert!(test["name"].is_string() && test["test_code"].is_string());
        let status = text(&test["status"]);
        assert!(["pass", "fail", "error"].contains(&status.as_str()));
        message(&test["message"], status != "pass");
        statuses.push(status);
    }
    let all = |of: &str| statuses.iter().all(|status| status == of);
    let status = text(&results["status"]);
    let expected = match () {
        () if all("pass") => "pass",
        () if all("error") => "error", // "should only be used if every test errored"
        () => "fail",
    };
    assert_eq!(status, expected, "{results:#}");
    message(&results["message"], status == "error");
    assert!(status == "error" || results["message"].is_null());
}

fn exercism(course: &Course) {
    let all = |student: &str| course.json(&format!("results/students/{student}/exercism.json"));
    for student in [
        NAME, "wrong", "memory", "refused", "evil", "broken", "ended",
    ] {
        read_exercism(&all(student));
    }
    for (student, status, of_tests) in [
        (NAME, "fail", ["pass", "fail"]),
        ("wrong", "fail", ["fail", "fail"]),
        ("refused", "error", ["error", "error"]),
        ("broken", "error", ["error", "error"]),
    ] {
        let results = all(student);
        assert_eq!(results["status"], status, "{results:#}");
        let tests = results["tests"].as_array().expect("tests");
        let statuses: Vec<_> = tests.iter().map(|test| &test["status"]).collect();
        assert_eq!(statuses, of_tests, "{student}");
        assert!(tests.iter().all(|test| test["task_id"] == 1), "the chapter");
    }
    let text = text(&course.path("results/students/ended/index.html"));
    assert!(
        text.contains("hand-in/answer.py") && !text.contains("stage"),
        "a traceback tells no path of ours: {text}"
    );
    let message = all("broken")["message"].to_string();
    assert!(message.contains("main.cpp:2"), "{message}");
    assert!(!message.contains("stage"), "no path of ours: {message}");
}

/// A command of a workflow: its level, its properties and its message, read as GitHub's runner does.
fn command(line: &str) -> (String, BTreeMap<String, String>, String) {
    let (head, message) = line
        .strip_prefix("::")
        .and_then(|line| line.split_once("::"))
        .unwrap_or_else(|| panic!("a command: {line}"));
    let (level, properties) = head.split_once(' ').expect("properties");
    let data = |text: &str| text.replace("%0D", "\r").replace("%0A", "\n");
    let property = |text: &str| data(text).replace("%3A", ":").replace("%2C", ",");
    let properties = properties.split(',').map(|of| {
        let (name, value) = of.split_once('=').expect("a name and a value");
        (name.to_owned(), property(value).replace("%25", "%"))
    });
    (
        level.to_owned(),
        properties.collect(),
        data(message).replace("%25", "%"),
    )
}

fn annotations(course: &Course) {
    let of = |student: &str| -> Vec<_> {
        let text = text(&course.path(&format!("results/students/{student}/annotations.txt")));
        assert!(!text.contains(['\u{1b}', '\0', '\u{202e}', '\r']), "{text}");
        text.lines().map(command).collect()
    };
    let [(level, properties, message)] = &of(NAME)[..] else {
        panic!("what is right has none: {:?}", of(NAME));
    };
    assert_eq!(
        (level.as_str(), message.as_str()),
        ("notice", "not started")
    );
    assert_eq!(
        properties["title"],
        "=cmd|' <b>\"x\", & y?#\\u{202e}%41: camera_ray"
    );
    for (student, file, line) in [("broken", "main.cpp", "2"), ("ended", "answer.py", "3")] {
        let (level, properties, message) = &of(student)[0];
        assert_eq!(level, "error", "{student}");
        assert_eq!(
            (properties["file"].as_str(), properties["line"].as_str()),
            (file, line),
            "{message}"
        );
        assert!(message.contains('\n'), "its lines are kept: {message}");
    }
    assert!(
        of("broken")[0].2.contains("100 % none"),
        "a percent sign is one: {:?}",
        of("broken")
    );
    let [(level, properties, message)] = &of("refused")[..] else {
        panic!("a hand-in is refused once");
    };
    assert_eq!(
        (level.as_str(), properties["title"].as_str()),
        ("error", "refused")
    );
    assert!(message.contains("no source file"), "{message}");
}

fn grade(course: &Course) {
    let grade = course.student(NAME);
    assert_eq!(
        (&grade["student"], &grade["term"]),
        (&Value::from(NAME), &Value::from("<now>"))
    );
    assert_eq!(
        grade["key"].as_str().map(str::len),
        Some(16),
        "the key's fingerprint"
    );
    assert!(
        grade["when"]
            .as_str()
            .is_some_and(|when| when.parse::<Timestamp>().is_ok()),
        "{grade:#}"
    );
    let size = text(&course.path("results/students/wrong/grade.json")).len();
    assert!(size < 10_000, "{size} bytes");
}

#[test]
fn a_field_ends_where_it_ends_in_every_reader() {
    let pairs = [["a,b\\", "x\\\",100,\""], ["C:\\x", "=1"], ["\\\\,", "y"]];
    let pair = |names: [&str; 2]| Pair {
        students: names.map(str::to_owned),
        share: 0.5,
    };
    let course = raybook_grader::class::course::Course::read(
        Path::new("course.toml"),
        "[[chapter]]\nchapter = 'ch01'\n",
    );
    let course = course.expect("it is right");
    let roll = Roll {
        pairs: pairs.map(pair).into(),
        ..Roll::default()
    };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let class = Class::of(&course, &roll, &Known::new());
    export::write(folder.path(), &class).expect("it is written");
    assert_eq!(
        text(&folder.path().join("similar.csv")),
        "student,other student,alike\r\n\"a,b/\",\"x/\"\",100,\"\"\",0.50\r\nC:\\x,'=1,0.50\r\n\"\\\\,\",y,0.50\r\n"
    );
}
