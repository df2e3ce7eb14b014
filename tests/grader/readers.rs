//! The programs that `raybook exercise --reader` prints: they compile, read every question, and write what they read.

use raybook_grader::cases;
use raybook_grader::examine::{Examiner, visible_rng};
use raybook_grader::reader::{cpp, python};
use raybook_workbook::exercise::Asked;
use raybook_workbook::kind::{Kind, Record};
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

/// Whether there is this program; else the test says so.
fn there_is(program: &str) -> bool {
    let output = Command::new(program).arg("--version").output();
    let there = output.is_ok_and(|output| output.status.success());
    if !there {
        println!("there is no {program} here: its programs are not tried");
    }
    there
}

/// What a program says to these lines.
fn said(program: &mut Command, lines: &str) -> String {
    let child = program.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
    let mut child = child.expect("it can be started");
    let mut input = child.stdin.take().expect("it is piped");
    let lines = lines.to_owned();
    let writer = std::thread::spawn(move || input.write_all(lines.as_bytes()));
    let output = child.wait_with_output().expect("it ends");
    let written = writer.join().expect("the writer ends");
    written.expect("all lines are read");
    assert!(output.status.success(), "it ends well");
    String::from_utf8(output.stdout).expect("it is text")
}

/// A line for each row.
fn lines<'a>(name: &str, rows: impl Iterator<Item = &'a String>) -> String {
    rows.flat_map(|row| [name, " ", row, "\n"]).collect()
}

/// An exercise whose questions are the answers of another one, to be answered by themselves.
fn echo(examiner: &dyn Examiner) -> Asked {
    let answer = examiner.asked().answer;
    let record: &'static Record = Box::leak(Box::new(Record {
        name: "Echo",
        fields: Vec::leak(vec![answer]),
    }));
    Asked {
        name: "echo",
        task: "Return what is asked.",
        in_rust: "",
        question: Box::leak(Box::new(Kind::Record(record))),
        answer,
        call: <[f64]>::to_vec,
    }
}

/// Asks a program for the golden answers of an exercise, and expects them back.
fn echoes(program: &mut Command, examiner: &dyn Examiner) {
    let cases = examiner.cases(&mut visible_rng(examiner.name())).cases;
    let answers = cases.iter().map(|case| &case.answers[0]);
    let said = said(program, &lines("echo", answers));
    assert_eq!(said.lines().count(), cases.len(), "{}", examiner.name());
    let read = |line: &str| examiner.asked().read_answer(line).expect("it is an answer");
    for (line, case) in said.lines().zip(&cases) {
        let line = line.strip_prefix("= ").expect("it is marked as an answer");
        assert_eq!(read(line), read(&case.answers[0]), "{}", examiner.name());
    }
}

#[test]
fn python_reads_every_question_and_writes_every_answer() {
    if !there_is("python3") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    for examiner in cases::all() {
        let name = examiner.name();
        let file = home.path().join(format!("{name}.py"));
        fs::write(&file, python::program(examiner.asked())).expect("it can be written");
        let cases = examiner.cases(&mut visible_rng(name)).cases;
        let lines = lines(name, cases.iter().map(|case| &case.question));
        let said = said(Command::new("python3").arg(&file), &lines);
        assert_eq!(
            said,
            format!("= todo {name}\n").repeat(cases.len()),
            "{name}"
        );

        let asked = echo(examiner);
        let text = python::program(&asked);
        let stub = "raise NotImplementedError  # write it here";
        assert!(text.contains(stub), "it has a stub");
        let text = text.replace(stub, &format!("return q.{}", asked.answer.name));
        fs::write(&file, text).expect("it can be written");
        echoes(Command::new("python3").arg(&file), examiner);
    }
}

/// Compiles without a warning.
fn compile(file: &Path, options: &[&str]) {
    let output = Command::new("g++")
        .args(["-std=c++17", "-Wall", "-Wextra", "-Werror"])
        .args(options)
        .arg(file)
        .output()
        .expect("the compiler runs");
    let complaints = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{complaints}");
}

#[test]
fn every_program_in_cpp_compiles_without_a_warning() {
    if !there_is("g++") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let mut all = String::new();
    for examiner in cases::all() {
        let text = cpp::program(examiner.asked());
        let includes = |line: &&str| line.starts_with("#include");
        // One file for all: the headers take longer than the programs.
        if all.is_empty() {
            all.extend(text.lines().filter(includes).flat_map(|line| [line, "\n"]));
        }
        all.extend(["namespace of_", examiner.name(), " {\n"]);
        let rest = text.lines().filter(|line| !includes(line));
        all.extend(rest.flat_map(|line| [line, "\n"]));
        all.push_str("}\n");
    }
    let file = home.path().join("all.cpp");
    fs::write(&file, all.replace("int main()", "int run()")).expect("it can be written");
    compile(&file, &["-fsyntax-only"]);
}

#[test]
fn cpp_reads_and_writes_every_kind() {
    if !there_is("g++") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let (file, program) = (home.path().join("a.cpp"), home.path().join("program"));
    let output = ["-o", program.to_str().expect("it is text")];
    // A choice in the question; a number that may be missing, a list that may be, and a record with one that may be.
    for name in [
        "trace",
        "sphere_hit",
        "sample_rect",
        "wide_closest",
        "collapse",
    ] {
        let examiner = cases::find(name).expect("an exercise");
        fs::write(&file, cpp::program(examiner.asked())).expect("it can be written");
        compile(&file, &output);
        let cases = examiner.cases(&mut visible_rng(name)).cases;
        let lines = lines(name, cases.iter().map(|case| &case.question));
        let said = said(&mut Command::new(&program), &lines);
        assert_eq!(
            said,
            format!("= todo {name}\n").repeat(cases.len()),
            "{name}"
        );

        let asked = echo(examiner);
        let text = cpp::program(&asked);
        let stub = "(void)q;\n    throw NotWritten{}; // write it here";
        assert!(text.contains(stub), "it has a stub");
        let text = text.replace(stub, &format!("return q.{};", asked.answer.name));
        fs::write(&file, text).expect("it can be written");
        compile(&file, &output);
        echoes(&mut Command::new(&program), examiner);
    }
}
