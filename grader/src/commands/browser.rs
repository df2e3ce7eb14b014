//! The browser of this machine.

use std::process::{Command, Stdio};

/// Asks the system to show an address; what it makes of it is not waited for, so whoever calls this also says the address.
///
/// Only addresses with a scheme that a browser is for are handed on: no other program is started, and nothing is taken for an option.
pub fn open(address: &str) {
    if !["http://", "file://"]
        .iter()
        .any(|scheme| address.starts_with(scheme))
    {
        return;
    }
    let (program, options): (_, &[&str]) = if cfg!(target_os = "macos") {
        ("open", &[])
    } else if cfg!(windows) {
        ("rundll32", &["url.dll,FileProtocolHandler"])
    } else {
        ("xdg-open", &[])
    };
    let mut command = Command::new(program);
    command
        .args(options)
        .arg(address)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    // There may be no browser, or no screen: then the address that was said is all.
    let _ = command.spawn();
}
