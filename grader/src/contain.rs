//! Holding a student's process and its children together, so that none is left behind. The system's own code is here.

use crate::keys;
use crate::mutex::lock;
use crate::sandbox::Sandbox;
#[cfg(target_os = "linux")]
use crate::stat::{Stat, is_in_group, processes};
use crate::suspend;
#[cfg(target_os = "linux")]
use rustix::process::Pid;
use std::io;
#[cfg(target_os = "linux")]
use std::path::Path;
use std::process::{Child, Command, ExitStatus};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard};
use std::thread;
use std::time::{Duration, Instant};

/// The environment variable that marks a process as a student's.
const MARK: &str = "RAYBOOK_ASKED";

/// A student's process, and how to find all that it started.
pub struct Held {
    /// The process, head of a group of its own.
    pub child: Child,
    mark: String,
    /// Whether it has been ended.
    ended: bool,
}

/// The groups' numbers and the marks of all that is held now.
static HELD: Mutex<Vec<(u32, String)>> = Mutex::new(Vec::new());

/// Starts a command so that all of it can be ended: it becomes the head of a process group, and it and its children carry
/// a mark. On Linux it also ends when the grader does, even by a signal that cannot be caught.
/// A command that was made ready for a sandbox is held by that.
///
/// # Errors
/// If it cannot be started.
pub fn start(command: &mut Command, sandbox: Option<&Sandbox>) -> io::Result<Held> {
    static NUMBER: AtomicU64 = AtomicU64::new(0);
    let mark = format!(
        "{}-{}",
        std::process::id(),
        NUMBER.fetch_add(1, Ordering::Relaxed)
    );
    command.env(MARK, &mark);
    if sandbox.is_none() {
        hold(command);
    }
    // Locked until it is on the list: nothing can be started while `end_all` goes through it.
    let mut held = held();
    let child = match sandbox {
        Some(sandbox) => sandbox.spawn(command)?,
        None => command.spawn()?,
    };
    held.push((child.id(), mark.clone()));
    let ended = false;
    Ok(Held { child, mark, ended })
}

impl Held {
    /// Asks the process where in its program it is.
    pub fn interrupt(&self) {
        signal_group(self.child.id(), Signal::SayWhere);
    }

    /// Ends the process and all that it started. If it closed its output by itself, it has the time `limit` to end by itself.
    pub fn end(mut self, by_itself: bool, limit: Duration) -> Option<ExitStatus> {
        let status = if by_itself {
            wait(&mut self.child, limit)
        } else {
            None
        };
        self.kill(status)
    }

    /// Ends all of it; `status` is how the process ended, if it has.
    fn kill(&mut self, status: Option<ExitStatus>) -> Option<ExitStatus> {
        self.ended = true;
        // The child may have ended and been waited for, but its own children may not.
        signal_group(self.child.id(), Signal::Kill);
        #[cfg(not(unix))]
        let _ = self.child.kill();
        let status = status.or_else(|| self.child.wait().ok());
        kill_left(self.child.id(), &self.mark);
        held().retain(|(_, mark)| *mark != self.mark);
        status
    }
}

/// Nothing of it is left, even where nobody came to end it.
impl Drop for Held {
    fn drop(&mut self) {
        if !self.ended {
            self.kill(None);
        }
    }
}

/// Waits for a process to end, at most the time `limit`.
fn wait(child: &mut Child, limit: Duration) -> Option<ExitStatus> {
    let deadline = Instant::now() + limit;
    loop {
        match child.try_wait() {
            Ok(Some(status)) => return Some(status),
            Ok(None) if Instant::now() < deadline => thread::sleep(Duration::from_millis(1)),
            _ => return None,
        }
    }
}

/// From now on, Ctrl-C and the polite signals end the grader with all that it started, and Ctrl-Z stops both.
///
/// # Errors
/// If the system refuses.
pub fn obey_signals() -> Result<(), ctrlc::Error> {
    /// What shells report of a program that Ctrl-C ended: 128 and the signal's number.
    const INTERRUPTED: i32 = 130;
    suspend::suspend_on_signals();
    ctrlc::set_handler(|| end_all(INTERRUPTED))
}

/// Ends the grader at once, with this exit code and with all that it started.
pub fn end_all(code: i32) -> ! {
    let held = held();
    for (group, mark) in held.iter() {
        signal_group(*group, Signal::Kill);
        kill_left(*group, mark);
    }
    keys::restore();
    std::process::exit(code)
}

/// All that is held stands still, and nothing is started, until this is dropped.
#[cfg(unix)]
pub(crate) struct Stopped(MutexGuard<'static, Vec<(u32, String)>>);

/// Stops all that is held.
#[cfg(unix)]
pub(crate) fn stop_all() -> Stopped {
    let held = held();
    for (group, _) in held.iter() {
        signal_group(*group, Signal::Stop);
    }
    Stopped(held)
}

#[cfg(unix)]
impl Drop for Stopped {
    fn drop(&mut self) {
        for (group, _) in self.0.iter() {
            signal_group(*group, Signal::GoOn);
        }
    }
}

fn held() -> MutexGuard<'static, Vec<(u32, String)>> {
    lock(&HELD)
}

/// A signal by its name.
pub fn signal_name(status: ExitStatus) -> String {
    #[cfg(unix)]
    if let Some(signal) = std::os::unix::process::ExitStatusExt::signal(&status) {
        let meaning = match signal {
            4 => " (illegal instruction)",
            6 => " (abort: a condition of the language's library or of your own does not hold)",
            8 => " (arithmetic error: a whole number is divided by 0)",
            9 => " (killed)",
            11 => " (segmentation fault: memory that is not yours, or endless recursion)",
            24 => " (its processor time is used up)",
            _ => "",
        };
        return format!("signal {signal}{meaning}");
    }
    status.to_string()
}

/// Its own process group; on Linux it ends with the grader.
fn hold(command: &mut Command) {
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(command, 0);
    #[cfg(target_os = "linux")]
    die_with_the_grader(command);
    #[cfg(not(unix))]
    let _ = command;
}

#[cfg(target_os = "linux")]
#[expect(
    unsafe_code,
    reason = "`pre_exec` runs in the new process, where only few calls are allowed"
)]
fn die_with_the_grader(command: &mut Command) {
    let ask = || {
        Ok(rustix::process::set_parent_process_death_signal(Some(
            rustix::process::Signal::KILL,
        ))?)
    };
    // SAFETY: between fork and exec the closure makes one system call, prctl, which is async-signal-safe; it allocates nothing.
    unsafe { std::os::unix::process::CommandExt::pre_exec(command, ask) };
}

/// What is told to a group of processes.
#[derive(Clone, Copy)]
enum Signal {
    Kill,
    #[cfg(unix)]
    Stop,
    #[cfg(unix)]
    GoOn,
    /// To say where it is: SIGUSR1, which ends a program that has not asked for it.
    SayWhere,
}

fn signal_group(group: u32, signal: Signal) {
    #[cfg(unix)]
    if let Some(group) = i32::try_from(group)
        .ok()
        .and_then(rustix::process::Pid::from_raw)
    {
        let signal = match signal {
            Signal::Kill => rustix::process::Signal::KILL,
            Signal::Stop => rustix::process::Signal::STOP,
            Signal::GoOn => rustix::process::Signal::CONT,
            Signal::SayWhere => rustix::process::Signal::USR1,
        };
        // Nobody left to hear it is no error.
        let _ = rustix::process::kill_process_group(group, signal);
    }
    #[cfg(not(unix))]
    let _ = (group, signal);
}

/// Ends the processes that left the group, by `setsid` for example, and waits until nothing is left of them and of the group: a
/// signal only asks a process to end, and a busy machine takes its time.
fn kill_left(group: u32, mark: &str) {
    #[cfg(target_os = "linux")]
    {
        let deadline = Instant::now() + PATIENCE;
        let mut nobody = 0;
        while nobody < LOOKS && Instant::now() < deadline {
            nobody += 1;
            for process in left(group, mark) {
                // Already gone is no error.
                let _ = rustix::process::kill_process(process, rustix::process::Signal::KILL);
                nobody = 0;
            }
            thread::sleep(Duration::from_millis(1));
        }
    }
    #[cfg(not(target_os = "linux"))]
    let _ = (group, mark);
}

/// How often nobody is found before nobody is left. A process that is just starting a program has no environment to be known by: a
/// millisecond later it has.
#[cfg(target_os = "linux")]
const LOOKS: usize = 3;

/// How long what was killed is waited for: a disk that does not answer may hold it longer.
#[cfg(target_os = "linux")]
const PATIENCE: Duration = Duration::from_secs(2);

/// The processes of a group, and those whose environment carries the mark.
#[cfg(target_os = "linux")]
fn left(group: u32, mark: &str) -> impl Iterator<Item = Pid> {
    let variable = format!("{MARK}={mark}").into_bytes();
    let is_marked = move |folder: &Path| {
        let environment = std::fs::read(folder.join("environ")).unwrap_or_default();
        environment
            .split(|&byte| byte == 0)
            .any(|found| found == variable)
    };
    // Those that have ended are of the group too, until somebody has asked how.
    let goes_on = |folder: &Path| {
        let stat = Stat::read(&folder.join("stat"));
        stat.is_some_and(|stat| !stat.has_ended())
    };
    let is_left = move |process: Pid, folder: &Path| {
        is_in_group(process, group) && goes_on(folder) || is_marked(folder)
    };
    processes().filter_map(move |(process, folder)| is_left(process, &folder).then_some(process))
}
