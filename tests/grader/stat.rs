//! What Linux tells of a process.

#![cfg(target_os = "linux")] // elsewhere there is no such file

use raybook_grader::inside::Stat;

#[test]
fn it_is_read_whatever_the_name() {
    let text = "12 (a) b (c) S 1 13 14 0 -1 4194560 92 0 0 0 1 2 3 4 20 0 7 0 100 1 2";
    let stat = Stat {
        state: b'S',
        session: 14,
        ticks: 10,
        threads: 7,
    };
    assert_eq!(Stat::of(text.as_bytes()), Some(stat));
    assert!(!stat.has_ended(), "it sleeps");
    let ended = Stat::of(text.replace(") S", ") Z").as_bytes());
    assert!(ended.is_some_and(|stat| stat.has_ended()));
    assert_eq!(Stat::of(b"12 (cut off"), None);
}
