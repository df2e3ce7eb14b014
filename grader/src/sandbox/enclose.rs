//! Making a command ready to start in the sandbox: what may be read, its environment, its limits.

use super::calls::{self, Phase};
use super::enter::{NOT_CONTAINED, Prepared, at_most, landlock_version, shut_in};
use super::paths::{self, Readable};
use super::{Sandbox, landlocked, python};
use raybook::store;
use rustix::process::{Resource, Rlimit, getrlimit};
use std::ffi::{OsStr, OsString};
use std::io::{self, Read};
use std::os::fd::OwnedFd;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Libraries, interpreters, and what they read when they start.
const SYSTEM: &[&str] = &[
    "/usr",
    "/bin",
    "/sbin",
    "/lib",
    "/lib32",
    "/lib64",
    "/libx32",
    "/nix/store",
    "/etc/ld.so.cache",
    "/etc/ld.so.preload",
    "/etc/alternatives",
    "/etc/localtime",
    "/etc/timezone",
    "/etc/ssl/openssl.cnf", // Node.js ends where it cannot read it
    "/etc/pki/tls/openssl.cnf",
];

/// What may be written too: nothing of it is kept.
const DEVICES: &[&str] = &["/dev/null", "/dev/urandom", "/dev/random"];

/// Where programs are looked for, after the folder of the Python that the grader's user has.
const PATH: &str = "/usr/local/bin:/usr/bin:/bin";

/// The stack of the first thread, and of others unless they say otherwise.
const STACK: u64 = 8 << 20;

/// Addresses, of which a runtime may reserve more than it uses. Tables of pages are an eighth of a percent of it.
const ADDRESSES: u64 = 64 << 30;

/// The longest file that a compiler writes, in bytes.
const LONGEST_FILE: u64 = 1 << 30;

impl Sandbox {
    /// Makes a command start in the sandbox, in its program's own folder and with an environment that says nothing.
    ///
    /// # Errors
    /// If a layer cannot be prepared.
    pub(crate) fn enclose(&self, command: &mut Command) -> io::Result<()> {
        let program = PathBuf::from(command.get_program());
        let folder = command.get_current_dir().map(Path::to_owned);
        let of_program = paths::own(&program);
        let of_script = self.script.as_deref().and_then(paths::own);
        let own = of_script.or_else(|| of_program.clone());
        if folder.is_none() {
            let own = own.as_deref().filter(|own| own.is_dir());
            command.current_dir(own.unwrap_or(Path::new("/")));
        }
        let python = (is_script(&program) || is_python(&program))
            .then(python::find)
            .flatten();
        let mut path = OsString::new();
        if let Some(python) = python {
            path.push(&python.programs);
            path.push(":");
        }
        path.push(PATH);
        environment(command, &path);
        let of_python = python.into_iter().flat_map(|python| python.read.clone());
        let readable = of_python.chain(of_program).chain(own).chain(folder);
        let rules = self.rules(readable, &[])?;
        self.shut_in(command, rules, Phase::Run, 0)
    }

    /// Makes a compiler start in the sandbox: it reads these files and folders too, and writes into some.
    ///
    /// # Errors
    /// If a layer cannot be prepared.
    pub(crate) fn enclose_compiler(
        &self,
        command: &mut Command,
        path: &OsStr,
        readable: impl IntoIterator<Item = PathBuf>,
        written: &[&PathBuf],
    ) -> io::Result<()> {
        environment(command, path);
        let rules = self.rules(readable, written)?;
        self.shut_in(command, rules, Phase::Build, LONGEST_FILE)
    }

    /// The rules of landlock: the system's files and these can be read, but for what is hidden.
    fn rules(
        &self,
        readable: impl IntoIterator<Item = PathBuf>,
        written: &[&PathBuf],
    ) -> io::Result<OwnedFd> {
        let roots = SYSTEM.iter().map(PathBuf::from).chain(readable);
        let readable: Vec<Readable> = roots
            .filter_map(|root| root.canonicalize().ok())
            .flat_map(|root| paths::less(&root, &self.hidden))
            .collect();
        let rules = landlocked::ruleset(&readable, written, DEVICES).map_err(io::Error::other)?;
        rules.ok_or_else(not_contained)
    }

    fn shut_in(
        &self,
        command: &mut Command,
        rules: OwnedFd,
        phase: Phase,
        longest_file: u64,
    ) -> io::Result<()> {
        let prepared = Prepared {
            rules,
            filters: calls::filters(phase, landlock_version()).map_err(io::Error::other)?,
            limits: self.limits(longest_file),
            threads: self.allowance.threads as u64,
            grader: rustix::process::getpid(),
        };
        shut_in(command, prepared);
        Ok(())
    }

    /// The limits that a process keeps by itself, none above what the grader has.
    fn limits(&self, longest_file: u64) -> Vec<(Resource, Rlimit)> {
        let limits = [
            (
                Resource::Cpu,
                self.allowance.processor_time.as_secs().max(1),
            ),
            (Resource::Data, self.allowance.memory),
            (Resource::As, ADDRESSES),
            (Resource::Stack, STACK),
            (Resource::Nofile, self.allowance.files),
            (Resource::Fsize, longest_file),
            // With 1, unlike 0, a program that collects core files through a pipe is not started either.
            (Resource::Core, 1),
            (Resource::Memlock, 0),
            (Resource::Msgqueue, 0),
            (Resource::Rtprio, 0),
        ];
        let most = |resource| getrlimit(resource).maximum.unwrap_or(u64::MAX);
        let bounded = limits.map(|(resource, limit)| {
            let most = most(resource);
            let mut limits = at_most(limit.min(most));
            if resource == Resource::Cpu {
                // First by a signal of its own, which a compiler tells of; by the one that cannot be caught a second later.
                limits.maximum = Some(limit.saturating_add(1).min(most));
            }
            (resource, limits)
        });
        bounded.into()
    }
}

/// Nothing of the grader's environment, but what was set for this command.
fn environment(command: &mut Command, path: &OsStr) {
    let set: Vec<_> = command
        .get_envs()
        .filter_map(|(name, value)| Some((name.to_owned(), value?.to_owned())))
        .collect();
    command
        .env_clear()
        .env("PATH", path)
        .env("LANG", "C.UTF-8")
        .env("HOME", "/nonexistent")
        .env("PYTHONHASHSEED", "0") // the same order of a set's members each time
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .env("PYTHONNOUSERSITE", "1")
        .envs(set);
}

/// Why a command in the sandbox did not start, if the sandbox is to blame.
pub fn explain(error: io::Error, program: &Path) -> io::Error {
    if error.raw_os_error() == Some(NOT_CONTAINED) {
        return not_contained();
    }
    let executable = || {
        use std::os::unix::fs::PermissionsExt;
        program
            .metadata()
            .is_ok_and(|file| file.permissions().mode() & 0o111 != 0)
    };
    if error.kind() == io::ErrorKind::PermissionDenied && executable() {
        return io::Error::other(
            "in the sandbox only what lies in its own folder, in /usr or beside Python is run: is the file a link that leads elsewhere, or does its first line name a program elsewhere? --trust runs it with all your rights",
        );
    }
    error
}

fn not_contained() -> io::Error {
    io::Error::other("a layer of the sandbox could not be put on; `raybook doctor` says which")
}

/// Whether a file may be Python itself.
fn is_python(file: &Path) -> bool {
    let name = file.file_name().unwrap_or_default();
    name.as_encoded_bytes().starts_with(b"python")
}

/// Whether a file is run by an interpreter.
fn is_script(file: &Path) -> bool {
    let mut start = [0; 2];
    store::open(file).is_ok_and(|mut file| file.read_exact(&mut start).is_ok()) && &start == b"#!"
}
