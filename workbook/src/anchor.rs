//! Anchors: the marks around the functions that a student writes.
//!
//! `// ANCHOR: sphere_hit` and `// ANCHOR_END: sphere_hit` stand around a whole function with its comment.
//! The book's listing and the student's stub are both taken from there, so neither can drift from the code.

/// One anchored function of a source file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Anchored<'a> {
    /// The anchor's name: for an exercise, its grade key.
    pub name: &'a str,
    /// Everything between the marks.
    pub text: &'a str,
    /// The function up to its body, without comments.
    pub signature: &'a str,
    /// The function's body without its braces.
    pub body: &'a str,
}

/// What is wrong with a file's anchors.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum AnchorError {
    /// An anchor begins and does not end.
    #[error("`// ANCHOR: {0}` has no `// ANCHOR_END: {0}` after it")]
    Open(String),
}

/// The anchored functions of a source file, in order; anchors around other things, such as a trait, are left out.
///
/// # Errors
/// If an anchor has no end.
pub fn functions(source: &str) -> Result<Vec<Anchored<'_>>, AnchorError> {
    Ok(regions(source)?
        .into_iter()
        .filter_map(|(name, text)| split(name, text))
        .collect())
}

/// The names and the texts between the marks.
///
/// # Errors
/// If an anchor has no end.
pub fn regions(source: &str) -> Result<Vec<(&str, &str)>, AnchorError> {
    let mut regions = Vec::new();
    let mut at = 0;
    for line in source.split_inclusive('\n') {
        at += line.len();
        if let Some(name) = line.trim().strip_prefix("// ANCHOR: ") {
            let end = format!("// ANCHOR_END: {name}\n");
            let length = source[at..]
                .find(&end)
                .ok_or_else(|| AnchorError::Open(name.to_owned()))?;
            regions.push((name, &source[at..at + length]));
        }
    }
    Ok(regions)
}

/// The source with each anchored function rewritten: `rewrite` is given the function and returns its new text,
/// or `None` to keep it.
///
/// # Errors
/// If an anchor has no end.
pub fn rewrite(
    source: &str,
    rewrite: impl Fn(&Anchored<'_>) -> Option<String>,
) -> Result<String, AnchorError> {
    let mut rewritten = source.to_owned();
    for function in functions(source)? {
        if let Some(text) = rewrite(&function) {
            rewritten = rewritten.replacen(function.text, &text, 1);
        }
    }
    Ok(rewritten)
}

/// Takes the function apart; the body is between the first `{` outside parentheses and the last `}`.
fn split<'a>(name: &'a str, text: &'a str) -> Option<Anchored<'a>> {
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        if !line.trim_start().starts_with("//") && !line.trim_start().starts_with("#[") {
            break;
        }
        start += line.len();
    }
    let (mut depth, mut open) = (0_i32, None);
    for (i, c) in text[start..].char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            '{' if depth == 0 => {
                open = Some(start + i);
                break;
            }
            _ => {}
        }
    }
    let (open, close) = (open?, text.rfind('}')?);
    let signature = text[start..open].trim_end();
    signature.contains("fn ").then_some(Anchored {
        name,
        text,
        signature,
        body: text.get(open + 1..close)?,
    })
}
