//! A sandbox for strangers' programs: what one may read, call and use, laid down before its first instruction runs.
//!
//! The layers, in the order in which they are put on between fork and exec:
//!
//! | layer | what it takes away |
//! |---|---|
//! | files | descriptors above 2, the grader's environment, the controlling terminal, the grader's session |
//! | limits | processor time, memory, file size, open files, threads, core files |
//! | namespaces | where the system allows: the network, System V memory, rights over anything outside; an extra |
//! | capabilities | all, so that root in the sandbox is nobody |
//! | landlock | every file but the program's own folder and the system's libraries; all writing; TCP; signals to others |
//! | seccomp | sockets of every family, new processes, tracing, and whatever is not on a list of some 150 calls |
//!
//! `no_new_privs`, landlock and seccomp are necessary: where one is missing nothing is started. The others are told by
//! `raybook doctor`.
//!
//! **Why a program may replace itself.** `#!/usr/bin/env python3` is a chain of `execve`s, so the first of them cannot be the
//! last. A filter cannot count, and a helper that installs the filter later would have to be readable in the sandbox. So
//! `execve` stays allowed and everything that makes a second process (`fork`, `vfork`, `clone` without `CLONE_THREAD`) is
//! refused: a program can only become another one, which stands under the same rules, has the same process number and dies with the
//! grader. `clone3` keeps its flags in memory, where a filter cannot see them: it does not exist here, and the C libraries then
//! use `clone`.
//!
//! **Why a list of allowed calls.** A call that the kernel learns next year is not on it. A call that is neither on the list nor among
//! those refused by name does not exist (`ENOSYS`), for which C libraries have a second way; those refused by name fail with
//! `EPERM`, which a student's error message then says.
//!
//! **Why no namespace of processes.** It needs a process between the grader and the program that waits, and would only hide
//! what cannot be touched: landlock leaves no file of `/proc` readable, and signals to others are refused twice.
//!
//! **What is left.** `stat` and `readlink` tell of any path whether it exists, and how long it is: landlock does not hide names.
//! While a workbook is built, rights and times of files of the same user can be changed by name, though neither their text nor the files
//! themselves: compilers change both, and landlock knows of neither. A thread's stack may be small, so threads are counted from outside every few milliseconds, not by the kernel, where
//! namespaces are not allowed, and for root.

#[cfg(target_os = "linux")]
mod build;
#[cfg(target_os = "linux")]
mod build_by;
#[cfg(target_os = "linux")]
mod call_lists;
#[cfg(target_os = "linux")]
mod calls;
#[cfg(target_os = "linux")]
mod cpp;
#[cfg(target_os = "linux")]
mod enclose;
#[cfg(target_os = "linux")]
mod enter;
#[cfg(target_os = "linux")]
mod landlocked;
#[cfg(target_os = "linux")]
pub mod layers;
#[cfg(target_os = "linux")]
mod python;
#[cfg(target_os = "linux")]
pub(crate) mod watch;

pub mod doctor;
pub mod paths;

#[cfg(not(target_os = "linux"))]
use crate::{converse::Program, student::StudentError};
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Child, Command};
use std::time::Duration;

/// What a program may use in all, from its start to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Allowance {
    /// Processor time of all threads together.
    pub processor_time: Duration,
    /// Bytes of memory.
    pub memory: u64,
    /// Threads.
    pub threads: usize,
    /// Open files.
    pub files: u64,
}

impl Default for Allowance {
    /// Half an hour of processor time, a gibibyte, 256 threads and 256 files: more than any honest answer program uses.
    fn default() -> Self {
        Self {
            processor_time: Duration::from_secs(1800),
            memory: 1 << 30,
            threads: 256,
            files: 256,
        }
    }
}

/// A sandbox: every layer that this system has, and all the necessary ones.
#[derive(Clone, Debug)]
pub struct Sandbox {
    /// What no program in it may read, wherever it lies.
    #[cfg_attr(
        not(target_os = "linux"),
        allow(dead_code, reason = "no sandbox is made")
    )]
    hidden: Vec<PathBuf>,
    /// The file that the program interprets: its folder can be read as the program's own can.
    #[cfg_attr(
        not(target_os = "linux"),
        allow(dead_code, reason = "no sandbox is made")
    )]
    script: Option<PathBuf>,
    /// What a program may use.
    pub allowance: Allowance,
}

/// A layer without which no stranger's program is started.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "strangers' programs cannot be contained here: {0}; --trust runs the program with all your rights"
)]
pub struct Missing(pub &'static str);

/// The place of a running program that another build has replaced since: Linux then says "(deleted)" behind it.
#[cfg(target_os = "linux")]
pub(crate) fn as_it_was(program: PathBuf) -> PathBuf {
    let place = program
        .to_str()
        .and_then(|text| text.strip_suffix(" (deleted)"));
    place.map(PathBuf::from).unwrap_or(program)
}

/// The program of a workbook that answers its exercises.
pub const ANSWER: &str = "answer";

/// What is compiled already, in folders that may be read.
#[derive(Clone, Debug, Default)]
pub struct Ready {
    /// Objects that are linked with the rest.
    pub objects: Vec<PathBuf>,
    /// A header that every file includes first. If g++ compiled it before, it is not read again.
    pub header: Option<PathBuf>,
}

impl Sandbox {
    /// A sandbox in which these files and folders, and the grader's own program, cannot be read.
    ///
    /// # Errors
    /// If a necessary layer is missing here.
    #[cfg(target_os = "linux")]
    pub fn new(hidden: impl IntoIterator<Item = PathBuf>) -> Result<Self, Missing> {
        layers::necessary()?;
        let own = std::env::current_exe().ok().map(as_it_was);
        Ok(Self {
            hidden: hidden
                .into_iter()
                .chain(own)
                .map(|path| path.canonicalize().unwrap_or(path))
                .collect(),
            script: None,
            allowance: Allowance::default(),
        })
    }

    /// No sandbox: only Linux has what it is made of.
    ///
    /// # Errors
    /// Always.
    #[cfg(not(target_os = "linux"))]
    pub fn new(_hidden: impl IntoIterator<Item = PathBuf>) -> Result<Self, Missing> {
        Err(Missing("it takes Linux, with landlock and seccomp"))
    }

    /// The same sandbox with this limit of processor time.
    #[must_use]
    pub fn with_processor_time(mut self, time: Duration) -> Self {
        self.allowance.processor_time = time;
        self
    }

    /// The same sandbox for an interpreter of this file.
    #[must_use]
    pub fn with_script(mut self, script: Option<PathBuf>) -> Self {
        self.script = script;
        self
    }

    /// The Python that strangers' programs are run by: the one of the grader's user.
    pub fn python() -> Option<PathBuf> {
        #[cfg(target_os = "linux")]
        return python::find().map(|python| python.executable.clone());
        #[cfg(not(target_os = "linux"))]
        None
    }

    /// Starts a command that was made ready.
    #[cfg(target_os = "linux")]
    pub(crate) fn spawn(&self, command: &mut Command) -> io::Result<Child> {
        let child = command.spawn();
        let program = Path::new(command.get_program());
        let child = child.map_err(|error| enclose::explain(error, program))?;
        watch::threads(child.id(), self.allowance.threads);
        Ok(child)
    }

    /// There is no sandbox.
    ///
    /// # Errors
    /// Always.
    #[cfg(not(target_os = "linux"))]
    pub fn build(&self, _workbook: &Path) -> Result<Program, StudentError> {
        Err(StudentError::of("build it")(io::Error::other(
            "no sandbox here",
        )))
    }

    /// There is no sandbox.
    ///
    /// # Errors
    /// Always.
    #[cfg(not(target_os = "linux"))]
    pub fn build_by(&self, _workbook: &Path, _words: &[String]) -> Result<(), StudentError> {
        Err(StudentError::of("build it")(io::Error::other(
            "no sandbox here",
        )))
    }

    /// There is no sandbox.
    #[cfg(not(target_os = "linux"))]
    pub fn build_told(
        &self,
        workbook: &Path,
        _binary: &str,
    ) -> (Result<Program, StudentError>, String) {
        (self.build(workbook), String::new())
    }

    /// There is no sandbox.
    #[cfg(not(target_os = "linux"))]
    pub fn compile_cpp(
        &self,
        folder: &Path,
        _files: &[String],
        _ready: &Ready,
        _output: &Path,
    ) -> (Result<Program, StudentError>, String) {
        (self.build(folder), String::new())
    }

    /// There is no sandbox.
    #[cfg(not(target_os = "linux"))]
    pub fn compile_objects(
        &self,
        folder: &Path,
        _files: &[String],
    ) -> (Result<(), StudentError>, String) {
        (self.build(folder).map(|_| ()), String::new())
    }

    /// There is no sandbox.
    #[cfg(not(target_os = "linux"))]
    pub fn precompile(&self, folder: &Path, _header: &str) -> (Result<(), StudentError>, String) {
        (self.build(folder).map(|_| ()), String::new())
    }

    /// There is no sandbox.
    #[cfg(not(target_os = "linux"))]
    pub(crate) fn enclose(&self, _command: &mut Command) -> io::Result<()> {
        Err(io::Error::other("no sandbox here"))
    }

    /// There is no sandbox.
    #[cfg(not(target_os = "linux"))]
    pub(crate) fn spawn(&self, _command: &mut Command) -> io::Result<Child> {
        Err(io::Error::other("no sandbox here"))
    }
}
