//! What can be misread of a list.

use super::{How, Misreading};

/// The ways to go through a list wrongly.
pub fn of_list(list: usize, name: &str, all: &mut Vec<Misreading>) {
    let mut push = |what: String, rank, hint: &str, which| {
        let how = How::List(list, which);
        let hint = hint.to_owned();
        all.push(Misreading::new(what, hint, rank, how));
    };
    let loops = "Where does your loop begin, and where does it end?";
    push(
        format!("leaves out the first of the list ({name})"),
        12,
        loops,
        |n| (1..n).collect(),
    );
    push(
        format!("leaves out the last of the list ({name})"),
        12,
        loops,
        |n| (0..n.saturating_sub(1)).collect(),
    );
    push(
        format!("looks at the first of the list only ({name})"),
        13,
        "What about the others in the list?",
        |n| (0..n.min(1)).collect(),
    );
    push(
        format!("looks at the last of the list only ({name})"),
        13,
        "What about the others in the list? Is a result overwritten in every round?",
        |n| (n.saturating_sub(1)..n).collect(),
    );
    push(
        format!("goes through the list backwards ({name})"),
        14,
        "In which order do you go through the list?",
        |n| (0..n).rev().collect(),
    );
    push(
        format!("ignores the list ({name})"),
        14,
        "What would your answer be if the list were empty?",
        |_| Vec::new(),
    );
    push(
        format!("leaves out the second of the list ({name})"),
        17,
        loops,
        |n| (0..n).filter(|i| *i != 1).collect(),
    );
    push(
        format!("looks at every second of the list only ({name})"),
        18,
        loops,
        |n| (0..n).step_by(2).collect(),
    );
}
