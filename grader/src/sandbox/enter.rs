//! What a new process does to itself between fork and exec. All code of the sandbox that the compiler cannot check is here.
//!
//! Between the two only calls are allowed that a signal handler may make: other threads of the grader may have held any lock at the
//! fork. So everything is prepared before, and nothing here allocates.
#![expect(
    unsafe_code,
    reason = "`pre_exec` runs in the new process, and two system calls have no wrapper"
)]

use super::calls::{Filters, name_itself};
use rustix::process::{Resource, Rlimit, Signal};
use rustix::thread::{CapabilitySet, CapabilitySets, UnshareFlags};
use std::io;
use std::os::fd::{AsRawFd, OwnedFd};
use std::os::unix::process::CommandExt;
use std::process::Command;

/// What a new process needs to shut itself in.
pub struct Prepared {
    /// The rules of landlock.
    pub rules: OwnedFd,
    /// The filters of seccomp.
    pub filters: Filters,
    /// Limits of use.
    pub limits: Vec<(Resource, Rlimit)>,
    /// How many threads there may be, where they can be counted for this process alone.
    pub threads: u64,
    /// The grader's process.
    pub grader: rustix::process::Pid,
}

/// What a necessary layer fails with, so that it is told from a failing exec.
pub const NOT_CONTAINED: i32 = libc::ENOTRECOVERABLE;

/// The version of landlock that this kernel has; 0 if it has none, or it is not switched on.
pub fn landlock_version() -> i32 {
    const ASK_VERSION: libc::c_uint = 1;
    // SAFETY: with this flag the call reads no memory: it takes a null pointer and a length of 0, and returns a number.
    let version = unsafe {
        libc::syscall(
            libc::SYS_landlock_create_ruleset,
            std::ptr::null::<libc::c_void>(),
            0_usize,
            ASK_VERSION,
        )
    };
    i32::try_from(version).unwrap_or(0).max(0)
}

/// Lets the command's process shut itself in before it executes the program.
pub fn shut_in(command: &mut Command, mut prepared: Prepared) {
    let enter = move || prepared.enter();
    // SAFETY: `enter` makes system calls only, and writes to memory that was allocated before the fork. It takes no lock,
    // allocates nothing and drops nothing.
    unsafe { command.pre_exec(enter) };
}

impl Prepared {
    fn enter(&mut self) -> io::Result<()> {
        // Fails only for the head of a process group, which a forked process is not.
        necessary(rustix::process::setsid().map(drop))?;
        rustix::process::umask(rustix::fs::Mode::from_raw_mode(0o077));
        close_on_exec()?;
        // An extra: many systems do not allow it to everybody. Outside of a space of its own, all that its user runs would count.
        if leave_the_system().is_ok() {
            limit(Resource::Nproc, at_most(self.threads))?;
        }
        for &(resource, most) in &self.limits {
            limit(resource, most)?;
        }
        let none = CapabilitySets {
            effective: CapabilitySet::empty(),
            permitted: CapabilitySet::empty(),
            inheritable: CapabilitySet::empty(),
        };
        necessary(rustix::thread::set_capabilities(None, none))?;
        necessary(rustix::thread::set_no_new_privs(true))?;
        restrict(&self.rules)?;
        // After all that changes rights: each such change takes this back.
        necessary(rustix::process::set_parent_process_death_signal(Some(
            Signal::KILL,
        )))?;
        if rustix::process::getppid() != Some(self.grader) {
            return Err(not_contained()); // the grader ended before the line above
        }
        name_itself(
            &mut self.filters.refused,
            rustix::process::getpid()
                .as_raw_nonzero()
                .get()
                .cast_unsigned(),
        );
        // The last one refuses further filters.
        let filters = [&self.filters.listed, &self.filters.refused];
        for filter in self.filters.pretended.iter().chain(filters) {
            if seccompiler::apply_filter(filter).is_err() {
                return Err(not_contained());
            }
        }
        Ok(())
    }
}

/// A limit that cannot be raised.
pub fn at_most(most: u64) -> Rlimit {
    Rlimit {
        current: Some(most),
        maximum: Some(most),
    }
}

fn limit(resource: Resource, most: Rlimit) -> io::Result<()> {
    necessary(rustix::process::setrlimit(resource, most))
}

/// Own networks, System V memory and host name, without any right over those outside.
fn leave_the_system() -> rustix::io::Result<()> {
    let spaces =
        UnshareFlags::NEWUSER | UnshareFlags::NEWNET | UnshareFlags::NEWIPC | UnshareFlags::NEWUTS;
    // SAFETY: the table of open files, the one thing that threads would miss, is not among what is left; and a forked process has
    // one thread.
    unsafe { rustix::thread::unshare_unsafe(spaces) }
}

/// No file that the grader has open stays open, but for standard input and outputs. They close with the exec, so that an error can
/// still be told.
fn close_on_exec() -> io::Result<()> {
    const ALL: libc::c_uint = libc::c_uint::MAX;
    // SAFETY: marks descriptors by number; touches no memory. What is marked is used by nobody after the exec.
    let marked = unsafe {
        libc::syscall(
            libc::SYS_close_range,
            3 as libc::c_uint,
            ALL,
            libc::CLOSE_RANGE_CLOEXEC,
        )
    };
    if marked == 0 {
        Ok(())
    } else {
        Err(not_contained())
    }
}

/// Puts the rules of landlock in force.
fn restrict(rules: &OwnedFd) -> io::Result<()> {
    // SAFETY: takes a descriptor, which is open as long as it is borrowed, and no memory.
    let restricted =
        unsafe { libc::syscall(libc::SYS_landlock_restrict_self, rules.as_raw_fd(), 0) };
    if restricted == 0 {
        Ok(())
    } else {
        Err(not_contained())
    }
}

fn necessary(done: rustix::io::Result<()>) -> io::Result<()> {
    done.map_err(|_| not_contained())
}

/// An error that is a number, and nothing allocated.
fn not_contained() -> io::Error {
    io::Error::from_raw_os_error(NOT_CONTAINED)
}
