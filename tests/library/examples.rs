//! The examples are as short as the README says.

use raybook_common::source::read;

#[test]
fn an_example_has_the_lines_that_the_readme_counts() {
    let (readme, mut counted) = (read("README.md"), 0);
    for line in readme.lines().filter(|line| line.contains("--example")) {
        let (_, words) = line.split_once("--example ").expect("a name");
        let name = words.split(' ').next().expect("a name");
        let lines = read(&format!("examples/{name}.rs")).lines().count();
        assert!(
            line.ends_with(&format!(", in {lines} lines")),
            "{lines}: {line}"
        );
        counted += 1;
    }
    assert!(counted >= 2, "{counted} examples");
}

#[test]
fn hundreds_of_balls_are_fewer_than_sixty_lines() {
    let lines = read("examples/many_balls.rs").lines().count();
    assert!(lines < 60, "{lines}");
}
