//! The parts of the sandbox. (What attacks it is in `hostile.rs`.)

#[cfg(target_os = "linux")]
mod layers;
#[cfg(unix)]
mod paths;
#[cfg(target_os = "linux")]
mod replaced;
#[cfg(target_os = "linux")]
mod watch;
