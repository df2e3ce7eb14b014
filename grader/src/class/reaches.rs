//! What the text of a hand-in reaches for that no exercise needs. The sandbox refuses it; an instructor wants to know who tried.
//!
//! It is a list of words that stand in the text, also in a comment: a reason to look, and no proof.

use std::collections::BTreeSet;

/// What is tried, and the words by which Python, C++ and Rust do so.
const WORDS: [(&str, &[&str]); 4] = [
    (
        "start programs",
        &[
            "subprocess",
            "os.system",
            "os.exec",
            "os.popen",
            "os.posix_spawn",
            "popen(",
            "system(",
            "execv",
            "posix_spawn",
            "process::Command",
        ],
    ),
    (
        "use the network",
        &[
            "socket",
            "urllib",
            "http.client",
            "sys/socket.h",
            "std::net",
        ],
    ),
    (
        "reach other processes",
        &[
            "ctypes", "os.kill", "os.fork", "killpg", "kill(", "fork(", "ptrace", "syscall(",
        ],
    ),
    (
        "reach files of the system",
        &["/proc/", "/etc/", "/home/", "/root/", "/dev/", "/tmp/"],
    ),
];

/// What a text tries, as verbs.
pub fn reaches(text: &str) -> BTreeSet<&'static str> {
    let tries = WORDS
        .iter()
        .filter(|(_, words)| words.iter().any(|word| stands(word, text)));
    tries.map(|(what, _)| *what).collect()
}

/// Whether a word stands in a text, not as the end of another: `coordinate_system(` starts nothing.
fn stands(word: &str, text: &str) -> bool {
    let begins = |(at, _): (usize, &str)| {
        let before = text[..at].chars().next_back();
        !before.is_some_and(|c| c.is_alphanumeric() || c == '_')
    };
    text.match_indices(word).any(begins)
}
