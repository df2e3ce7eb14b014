//! Which layers this system has.

use super::enter::landlock_version;
use super::{Missing, calls};
use std::fs;

/// A layer, and what it is here.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Layer {
    /// Its name.
    pub name: &'static str,
    /// What it is here: its version, or why it is missing.
    pub state: String,
    /// Whether it is there.
    pub there: bool,
}

/// Whether the necessary layers are there.
///
/// # Errors
/// Which one is missing.
pub fn necessary() -> Result<(), Missing> {
    let landlock = landlock_version();
    let filters = calls::filters(calls::Phase::Run, landlock).is_ok();
    suffices(landlock, has_seccomp(), filters)
}

/// Whether this version of landlock, seccomp, and filters for the processor are enough.
pub(crate) fn suffices(landlock: i32, seccomp: bool, filters: bool) -> Result<(), Missing> {
    match (landlock, seccomp, filters) {
        (0, ..) => Err(Missing(
            "the kernel has no landlock (Linux 5.13 or later, with `landlock` in its `lsm=` line, and not forbidden in this container)",
        )),
        (_, false, _) => Err(Missing(
            "the kernel has no seccomp filters (CONFIG_SECCOMP_FILTER)",
        )),
        (.., false) => Err(Missing(
            "for this kind of processor there are no seccomp filters",
        )),
        _ => Ok(()),
    }
}

/// All layers, the necessary ones first.
pub fn all() -> Vec<Layer> {
    let landlock = landlock_version();
    let seccomp = has_seccomp();
    let namespaces = own_namespaces();
    vec![
        Layer {
            name: "landlock",
            state: match landlock {
                0 => "missing: Linux 5.13 or later has it, with `landlock` in its `lsm=` line"
                    .to_owned(),
                1..=3 => format!("version {landlock}; TCP is left to seccomp, and so are signals"),
                4..=5 => format!("version {landlock}; signals are left to seccomp"),
                _ => format!("version {landlock}"),
            },
            there: landlock > 0,
        },
        Layer {
            name: "seccomp",
            state: if seccomp { "filters" } else { "missing" }.to_owned(),
            there: seccomp,
        },
        Layer {
            name: "namespaces",
            state: match &namespaces {
                Ok(()) => "user, network, IPC and host name; an extra".to_owned(),
                Err(why) => {
                    format!("not allowed here ({why}); an extra that the others do without")
                }
            },
            there: namespaces.is_ok(),
        },
    ]
}

fn has_seccomp() -> bool {
    fs::read_to_string("/proc/sys/kernel/seccomp/actions_avail")
        .is_ok_and(|actions| actions.contains("errno"))
}

/// Whether a process can leave for namespaces of its own, tried by one that does nothing else.
fn own_namespaces() -> Result<(), String> {
    let tried = std::process::Command::new("unshare")
        .args(["--user", "--net", "--ipc", "--uts", "true"])
        .output()
        .map_err(|error| format!("`unshare` cannot be run: {error}"))?;
    if tried.status.success() {
        return Ok(());
    }
    Err(String::from_utf8_lossy(&tried.stderr).trim().to_owned())
}
