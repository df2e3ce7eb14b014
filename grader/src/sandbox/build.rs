//! Building a stranger's workbook: the compiler, and what the workbook makes it run, in the sandbox.

use super::watch::{self, Bounds};
use super::{ANSWER, Sandbox};
use crate::contain;
use crate::converse::Program;
use crate::student::StudentError;
use raybook_chapters::kit::say::complain;
use raybook_chapters::kit::untrusted::Untrusted;
use std::env;
use std::ffi::OsString;
use std::fmt::Write;
use std::io::{self, Read};
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::channel;
use std::thread;
use std::time::{Duration, Instant};

/// A build that takes longer is ended, and so is a compiler that computes longer: twenty times what one takes for a workbook.
const LONGEST: Duration = Duration::from_secs(600);
const COMPUTES: Duration = Duration::from_secs(120);

/// What a compiler uses: gigabytes of memory, a file for each crate, and threads for each processor.
const MEMORY: u64 = 4 << 30;
const FILES: u64 = 4096;
const THREADS: usize = 4096;

/// Cargo starts one compiler for each processor, and each of these a few. A workbook and its packages take 200 megabytes.
const BOUNDS: Bounds = Bounds {
    processes: 512,
    bytes: 2 << 30,
};

/// Bytes of the compiler's messages that are told.
const TOLD: usize = 1 << 16;

/// The compiler's folders that are read; not those of the user's credentials.
const OF_CARGO: &[&str] = &["bin", "registry", "git", "config.toml"];
const OF_RUSTUP: &[&str] = &["toolchains", "settings.toml", "tmp"];

/// The program of a workbook, which is built in a folder of its own: nobody else's `target`.
const TARGET: &str = "target";
/// Cargo takes out of it what the workbook does not use. A link would open another file for writing.
const LOCK: &str = "Cargo.lock";

/// What to do when a package is missing: strangers' workbooks download nothing.
const OFFLINE: &str = "A stranger's workbook is built without the network. Check a workbook of your own once \
    (raybook new, raybook check): that downloads the packages that workbooks use.";

impl Sandbox {
    /// Builds the answer program of a stranger's workbook. Nothing outside of its `target` can be written, and nothing of the build goes
    /// on afterwards. What the compiler has to say goes to standard error.
    ///
    /// # Errors
    /// If cargo is missing, the program does not compile, or the workbook is not what it seems.
    pub fn build(&self, workbook: &Path) -> Result<Program, StudentError> {
        let (built, said) = self.build_told(workbook, ANSWER);
        for line in said.lines() {
            complain(Untrusted::from(line));
        }
        if built.is_err() && said.contains("--offline was specified") {
            complain(OFFLINE);
        }
        built
    }

    /// As [`Sandbox::build`], any program of the workbook, with what the compiler has to say beside it.
    pub fn build_told(
        &self,
        workbook: &Path,
        binary: &str,
    ) -> (Result<Program, StudentError>, String) {
        let mut said = String::new();
        let built = self.build_workbook(workbook, binary, &mut said);
        (built, said)
    }

    fn build_workbook(
        &self,
        workbook: &Path,
        binary: &str,
        said: &mut String,
    ) -> Result<Program, StudentError> {
        let none = || StudentError::NoProgram {
            folder: workbook.to_owned(),
            program: binary.to_owned(),
        };
        let target = workbook.join(TARGET);
        // A link would open what it leads to for writing.
        match target.symlink_metadata() {
            Ok(kind) if kind.is_dir() => {}
            Ok(_) => return Err(none()),
            Err(_) => std::fs::create_dir(&target)
                .map_err(StudentError::of("make the workbook's folder `target`"))?,
        }
        let lock = workbook.join(LOCK);
        let may_change = lock
            .symlink_metadata()
            .is_ok_and(|file| file.is_file() && file.nlink() == 1);
        let written = [&target, &lock];
        let written = &written[..=usize::from(may_change)];
        let home = |variable, folder| {
            let at_home = || Some(env::home_dir()?.join(folder));
            env::var_os(variable).map(PathBuf::from).or_else(at_home)
        };
        let cargo_home = home("CARGO_HOME", ".cargo").unwrap_or_default();
        let rustup_home = home("RUSTUP_HOME", ".rustup").unwrap_or_default();
        let of = |home: &Path, parts: &[&str]| -> Vec<_> {
            parts.iter().map(|part| home.join(part)).collect()
        };
        let mut readable = of(&cargo_home, OF_CARGO);
        readable.extend(of(&rustup_home, OF_RUSTUP));
        readable.push(workbook.to_owned());
        let mut command = Command::new("cargo");
        command
            .args(["build", "--offline", "--bin", binary])
            .current_dir(workbook)
            .env("CARGO_HOME", &cargo_home)
            .env("RUSTUP_HOME", &rustup_home)
            .env("CARGO_TARGET_DIR", &target)
            .env("TMPDIR", &target)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::piped());
        let compiler = self.compiler();
        let mut path = cargo_home.join("bin").into_os_string();
        path.push(":");
        path.push(env::var_os("PATH").unwrap_or_else(|| OsString::from("/usr/bin:/bin")));
        compiler
            .enclose_compiler(&mut command, &path, readable, written)
            .map_err(StudentError::of("enclose cargo"))?;
        let built;
        (built, *said) = compiler
            .finish(command, &[&target])
            .map_err(StudentError::of_cargo)?;
        if !built {
            return Err(StudentError::DoesNotCompile);
        }
        let file = target.join("debug").join(binary);
        if !file.symlink_metadata().is_ok_and(|kind| kind.is_file()) {
            return Err(none());
        }
        Ok(Program {
            file,
            arguments: Vec::new(),
            folder: workbook.to_owned(),
            sandbox: Some(self.clone()),
        })
    }

    /// The same sandbox with what a compiler may use.
    pub(super) fn compiler(&self) -> Self {
        let mut compiler = self.clone();
        compiler.allowance.memory = MEMORY;
        compiler.allowance.files = FILES;
        compiler.allowance.threads = THREADS;
        compiler.allowance.processor_time = COMPUTES;
        compiler
    }

    /// Runs a compiler, which writes into these folders, to its end, and ends all that it left: whether it succeeded, and what it said.
    pub(super) fn finish(
        &self,
        mut command: Command,
        written: &[&Path],
    ) -> io::Result<(bool, String)> {
        let mut held = contain::start(&mut command, Some(self))?;
        let (sender, receiver) = channel();
        if let Some(stderr) = held.child.stderr.take() {
            thread::spawn(move || sender.send(listen(stderr)));
        }
        let session = held.child.id();
        let ended = AtomicBool::new(false);
        let start = Instant::now();
        let (status, broken) = thread::scope(|scope| {
            let watched = scope.spawn(|| watch::build(session, written, BOUNDS, &ended));
            let status = held.end(true, LONGEST);
            ended.store(true, Ordering::Relaxed);
            (status, watched.join().ok().flatten())
        });
        // Whoever held the other end has been ended.
        let mut said = receiver.recv().unwrap_or_default();
        let too_long = (start.elapsed() >= LONGEST).then_some("it took more than ten minutes");
        if let Some(why) = broken.or(too_long) {
            let _ = write!(said, "\nThe compiler was ended: {why}.\n");
        }
        let built = status.is_some_and(|status| status.success()) && broken.is_none();
        Ok((built, said))
    }
}

/// The text of an output: the first of it, however long it is.
fn listen(mut output: impl Read) -> String {
    let (mut kept, mut bytes) = (Vec::new(), [0; 1 << 12]);
    while let Ok(n @ 1..) = output.read(&mut bytes) {
        let room = TOLD.saturating_sub(kept.len());
        kept.extend(&bytes[..n.min(room)]);
    }
    String::from_utf8_lossy(&kept).into_owned()
}
