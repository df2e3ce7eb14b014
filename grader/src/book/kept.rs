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
pub(super) fn or_make(
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_this_program_made_is_not_made_again_and_anothers_is() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("gallery.md");
        let made = or_make(&file, || Ok("two\nlines".to_owned()));
        assert_eq!(made.as_deref(), Ok("two\nlines"));
        let again = or_make(&file, || Err("it is made again".to_owned()));
        assert_eq!(again, made);

        store::write(&file, b"another program\nold").expect("it can be written");
        let new = or_make(&file, || Ok("new".to_owned()));
        assert_eq!(new.as_deref(), Ok("new"));
    }

    #[test]
    fn what_fails_is_not_kept() {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("gallery.md");
        assert!(or_make(&file, || Err("no".to_owned())).is_err());
        assert!(!file.exists());
    }
}
