//! What is kept of a class between commands.

use raybook_grader::class::course::Course;
use raybook_grader::class::grades::{Known, Sheet};
use raybook_grader::class::record::{Marked, Standing};
use raybook_grader::class::roll::{Class, Results, Roll, Written};
use std::collections::BTreeSet;
use std::path::Path;

#[test]
fn points_that_are_read_again_are_the_same() {
    let course = "partial = 1.0\n[[chapter]]\nchapter = 'ch01'\nexercises = { ray_at = 1 }\n";
    let course = Course::read(Path::new("course.toml"), course).expect("it is right");
    let (mut roll, mut known) = (Roll::default(), Known::new());
    for asked in 1..=64 {
        for right in 0..=asked {
            let student = format!("{right} of {asked}");
            let mut result = Marked::without_cases(Standing::Wrong, "");
            result.right = [right, asked];
            known.insert((student.clone(), "ray_at".to_owned()), result);
            roll.sheets.push(Sheet {
                print: Ok(student.clone()),
                student,
                language: "python".to_owned(),
                taken: BTreeSet::new(),
                tries: BTreeSet::new(),
                notes: Vec::new(),
                handed_in: None,
            });
        }
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let results = Results::take(folder.path()).expect("nobody else has it");
    let class = Class::of(&course, &roll, &known);
    results.remember(&class).expect("it is written");
    let written = results.written().expect("it is read");
    assert_eq!(written.len(), class.grades.len(), "everybody's");
    for grade in &class.grades {
        let student = &grade.sheet.student;
        let again = written.get(student);
        assert_eq!(again, Some(&Written::of(grade)), "{student}");
    }
}
