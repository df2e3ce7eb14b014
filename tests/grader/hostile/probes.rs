//! The attacks of `raybook doctor`.

use super::there_is;
use raybook_grader::sandbox::Sandbox;
use raybook_grader::sandbox::doctor::{Attack, Fate, attacks, cost_of_a_start};
use std::sync::{Mutex, PoisonError};

/// Both tests make the doctor's folder, which has one name for a process.
static FOLDER: Mutex<()> = Mutex::new(());

fn tried(sandbox: Option<&Sandbox>) -> Vec<Attack> {
    let _alone = FOLDER.lock().unwrap_or_else(PoisonError::into_inner);
    attacks(sandbox).expect("they can be tried")
}

fn named(attacks: &[Attack], fate: Fate) -> Vec<&str> {
    let of_fate = attacks.iter().filter(|attack| attack.fate == fate);
    of_fate.map(|attack| attack.name.as_str()).collect()
}

#[test]
fn the_sandbox_stops_every_attack() {
    if !there_is("python3") {
        return;
    }
    let sandbox = Sandbox::new([]).expect("this machine has the necessary layers");
    let attacks = tried(Some(&sandbox));
    let reached = named(&attacks, Fate::Reached);
    assert!(reached.is_empty(), "these attacks succeeded: {reached:?}");
    let stopped = named(&attacks, Fate::Stopped);
    assert!(stopped.len() >= 120, "most are tried: {attacks:#?}");
    let cost = cost_of_a_start(&sandbox).expect("`true` can be started");
    println!("a start in the sandbox takes {cost:?} longer");
}

/// A probe that cannot succeed proves nothing: without the sandbox these do, for any user.
#[test]
fn the_attacks_succeed_without_the_sandbox() {
    if !there_is("python3") {
        return;
    }
    let attacks = tried(None);
    let reached = named(&attacks, Fate::Reached);
    for name in [
        "read a secret file",
        "read it through a link in its own folder",
        "read it by `..`",
        "read it through /proc/self/root",
        "read /etc/passwd",
        "list the root folder",
        "list the folder above its own",
        "list the processes",
        "read the grader's cmdline",
        "read the grader's environ",
        "read the grader's program",
        "list the grader's open files",
        "find the grader's environment",
        "make a file in its own folder",
        "make a file in the grader's folder",
        "make a file in /tmp",
        "write to a file",
        "cut a file of its own",
        "cut a file by its name",
        "change a file's rights",
        "change a file's owner",
        "change a file's times",
        "rename a file",
        "make a folder",
        "make a link",
        "make a hard link",
        "make a pipe with a name",
        "remove a file",
        "start a process by fork",
        "start a process by posix_spawn",
        "start a process by clone",
        "start a process by clone3",
        "signal the grader",
        "signal a thread of the grader",
        "signal the grader as a thread",
        "take a handle of the grader",
        "limit the grader",
        "slow the grader",
        "move the grader to a processor",
        "let a file's signals go to the grader",
        "a socket of family INET",
        "a socket of family UNIX",
        "a socket of family NETLINK",
        "a pair of sockets",
        "outlive the grader",
        "shared memory of nobody",
        "System V memory",
        "a file in memory",
        "open by the newer call",
        "read a secret file, by a shell",
        "read the grader's command line, by a shell",
        "make a file, by a shell",
        "signal the grader, by a shell",
        "start a process, by a shell",
    ] {
        assert!(
            reached.contains(&name),
            "`{name}` can succeed: {attacks:#?}"
        );
    }
}
