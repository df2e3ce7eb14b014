//! `{{measured proof}}`: what a test measured, in the words that it wrote down.

use include_dir::{Dir, include_dir};

/// A file for each measurement, written by the test of the same numbers (`raybook_common::measured`).
static MEASURED: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/../golden/measured");

/// The text of a measurement. A single sentence goes on in the paragraph in which the directive stands.
///
/// # Errors
/// If no test wrote one of this name.
pub(super) fn expand(name: &str) -> Result<String, String> {
    let file = MEASURED.get_file(format!("{name}.md"));
    let text = file.and_then(|file| file.contents_utf8());
    let text = text.ok_or_else(|| {
        let names = MEASURED
            .files()
            .filter_map(|file| file.path().file_stem()?.to_str());
        let names: Vec<_> = names.collect();
        format!(
            "nothing was measured as `{name}`; golden/measured has {}",
            names.join(", ")
        )
    })?;
    Ok(text.trim_end().to_owned())
}
