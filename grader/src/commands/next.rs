//! The next step of a student, which fits how an exercise stands.

use raybook_grader::check::State;
use raybook_grader::progress::Progress;
use raybook_grader::student;
use std::path::Path;

/// What to do about an exercise that stands like this, in a student's folder if there is one. Without a state it was never checked.
pub fn step(folder: Option<&Path>, exercise: &str, state: Option<&State>) -> String {
    let placed = |name: &str| {
        let place = folder.and_then(|folder| student::place(folder, name));
        place.map_or_else(|| name.to_owned(), |file| format!("{name} in {file}"))
    };
    let gone = folder
        .and_then(|folder| Some((folder, student::place(folder, exercise)?)))
        .filter(|(folder, file)| !folder.join(file).is_file());
    if let Some((_, file)) = gone {
        return format!("Next: {}.", student::gone(&file));
    }
    let this = placed(exercise);
    let what = match state {
        Some(State::Wrong) => format!("mend {this}"),
        Some(State::NotStarted) => {
            format!("write {this}; `raybook exercise {exercise}` says what it is asked")
        }
        Some(State::WaitsFor(other)) => {
            format!("write {}, for which {exercise} waits", placed(other))
        }
        Some(State::Right) | None => {
            format!("{this}; `raybook check {exercise}` says how it stands")
        }
    };
    format!("Next: {what}.")
}

/// What to do about the first exercise of the course that was not right when it was last checked.
pub fn in_course(folder: &Path, progress: &Progress) -> String {
    match progress.first_open() {
        Some(open) => step(Some(folder), open, progress.state(open).as_ref()),
        None => {
            "Every exercise of the course is right: `raybook report` writes a page of your work."
                .to_owned()
        }
    }
}
