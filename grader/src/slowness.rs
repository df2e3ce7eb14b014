//! How slow this machine is. Time limits are made for one that is slow already; on one that is slower still they are longer, for nobody chooses
//! the machine on which they are graded.

use std::process::{Command, Stdio};
use std::sync::OnceLock;

/// A loop of a million rounds, and the processor time that they took, in seconds.
const LOOP: &str = "import time\nhash = 0\nfor i in range(1000000):\n    hash = (31 * hash + i) % 1009\nprint(time.process_time())\n";

/// How long the loop takes on the machine that limits are made for, in seconds: one of 2024 takes a third of it.
pub const USUAL: f64 = 0.2;

/// However slow a machine seems, limits are at most this number of times as long.
pub const SLOWEST: f64 = 8.0;

/// By what time limits are multiplied on this machine: 1 or more, and 1 where there is no Python. The loop runs at the first call, which
/// comes when a program seems to be late: who is in time does not wait for it.
pub(crate) fn slowness() -> f64 {
    *SLOWNESS.get_or_init(|| measured().map_or(1.0, of))
}

/// The same if it was measured already, else 1.
pub(crate) fn known() -> f64 {
    SLOWNESS.get().copied().unwrap_or(1.0)
}

static SLOWNESS: OnceLock<f64> = OnceLock::new();

/// The slowness of a machine on which the loop takes `seconds`.
pub fn of(seconds: f64) -> f64 {
    (seconds / USUAL).clamp(1.0, SLOWEST)
}

/// How long the loop takes here, in seconds of processor time, if it can be measured.
pub fn measured() -> Option<f64> {
    let mut python = Command::new("python3");
    let quietly = python.args(["-I", "-S", "-c", LOOP]).stdin(Stdio::null());
    let output = quietly.output().ok()?;
    let seconds: f64 = String::from_utf8(output.stdout).ok()?.trim().parse().ok()?;
    seconds.is_finite().then_some(seconds)
}
