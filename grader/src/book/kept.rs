//! What an earlier build of the book made, for as long as the program is the same.

use crate::fingerprint::hex;
use raybook::store;
use sha2::{Digest, Sha256};
use std::path::Path;
use std::sync::LazyLock;

/// The hash of the running program: what it draws can change only with it.
static PROGRAM: LazyLock<Option<String>> = LazyLock::new(|| {
    let program = store::read(&std::env::current_exe().ok()?).ok()?;
    Some(hex(&Sha256::digest(program)))
});

/// The text that `make` makes, or made in an earlier run of this very program. The first line of the file says which program it was.
///
/// # Errors
/// If `make` fails, or the file cannot be written.
pub fn or_make(
    file: &Path,
    make: impl FnOnce() -> Result<String, String>,
) -> Result<String, String> {
    let Some(program) = PROGRAM.as_deref() else {
        return make();
    };
    if let Ok(text) = store::read_text(file)
        && let Some((by, text)) = text.split_once('\n')
        && by == program
    {
        return Ok(text.to_owned());
    }
    let text = make()?;
    store::write(file, format!("{program}\n{text}").as_bytes()).map_err(|e| e.to_string())?;
    Ok(text)
}
