//! Keeps for the report how this program is compiled.

use std::env::var;

fn main() {
    let flags = var("CARGO_ENCODED_RUSTFLAGS").unwrap_or_default();
    let flags = flags.replace('\u{1f}', " ");
    let [level, profile, target] =
        ["OPT_LEVEL", "PROFILE", "TARGET"].map(|name| var(name).unwrap_or_default());
    let flags = if flags.is_empty() { "none" } else { &flags };
    println!(
        "cargo::rustc-env=HOW=profile {profile}, opt-level {level}, target {target}, RUSTFLAGS: {flags}"
    );
}
