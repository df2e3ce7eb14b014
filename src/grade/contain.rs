//! Holding a student's process and its children together, so that none is left behind. The Unix-only code is here.

use crate::grade::converse::wait;
use std::process::{Child, Command, ExitStatus};
use std::time::Duration;

/// Starts the command as the head of a process group of its own: its children can then be ended with it.
pub fn own_group(command: &mut Command) {
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(command, 0);
    #[cfg(not(unix))]
    let _ = command;
}

/// Ends the child and all of its group. If it closed its output by itself, it has so long to end by itself.
pub fn end_group(child: &mut Child, by_itself: bool, limit: Duration) -> Option<ExitStatus> {
    let status = if by_itself { wait(child, limit) } else { None };
    // The child may have ended and been waited for, but its own children may not.
    kill_group(child);
    status.or_else(|| child.wait().ok())
}

/// A signal by its name.
pub fn signal_name(status: ExitStatus) -> String {
    #[cfg(unix)]
    if let Some(signal) = std::os::unix::process::ExitStatusExt::signal(&status) {
        let meaning = match signal {
            4 => " (illegal instruction)",
            6 => " (abort)",
            8 => " (arithmetic error)",
            9 => " (killed)",
            11 => " (segmentation fault: memory that is not yours, or endless recursion)",
            _ => "",
        };
        return format!("signal {signal}{meaning}");
    }
    status.to_string()
}

fn kill_group(child: &mut Child) {
    #[cfg(unix)]
    if let Some(group) = i32::try_from(child.id())
        .ok()
        .and_then(rustix::process::Pid::from_raw)
    {
        // Nobody left to kill is no error.
        let _ = rustix::process::kill_process_group(group, rustix::process::Signal::KILL);
    }
    #[cfg(not(unix))]
    let _ = child.kill();
}
