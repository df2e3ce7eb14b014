//! Scripts of which it is known how often they were started.

use crate::ask::LIMITS;
use raybook_grader::ask::{Asker, Said};
use raybook_grader::converse::{Limits, Program};
use std::fs;
use std::time::Duration;

/// Long enough on a machine that does other things too.
pub const PATIENT: Limits = Limits {
    output: LIMITS.output,
    ..Limits::of(Duration::from_secs(5))
};

/// A script that counts its starts in a file.
pub struct Counted {
    folder: tempfile::TempDir,
    pub program: Program,
}

impl Counted {
    pub fn new(script: &str) -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let script = format!("echo start >> starts; {script}");
        let program = Program {
            file: "/bin/sh".into(),
            arguments: vec!["-c".into(), script.into()],
            folder: folder.path().to_owned(),
            sandbox: None,
        };
        Self { folder, program }
    }

    pub fn starts(&self) -> usize {
        let starts = fs::read_to_string(self.folder.path().join("starts"));
        starts.unwrap_or_default().lines().count()
    }
}

pub fn lists(lists: &[&[&str]]) -> Vec<Vec<String>> {
    let list = |list: &&[&str]| list.iter().map(ToString::to_string).collect();
    lists.iter().map(list).collect()
}

/// What a script says to several lists of questions, and how often it is started.
pub fn heard(script: &str, questions: &[&[&str]]) -> (Vec<Vec<Said>>, usize) {
    let counted = Counted::new(script);
    let mut asker = Asker::new(&counted.program, PATIENT);
    let mut said = Vec::new();
    for list in lists(questions) {
        let replies = asker.ask(&list).expect("the shell can be started");
        said.push(replies.into_iter().map(|reply| reply.said).collect());
    }
    (said, counted.starts())
}
