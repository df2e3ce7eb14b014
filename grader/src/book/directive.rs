//! A directive on its line: `{{word name | rest}}`.

/// A directive.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Directive<'a> {
    /// What to do.
    pub(crate) word: &'a str,
    /// Of what.
    pub(crate) name: &'a str,
    /// What stands after the bar; empty without one.
    pub(crate) rest: &'a str,
}

/// The directive of a line, if it is one. mdBook's own begin with `{{#` and are left to it.
///
/// # Errors
/// If there are double braces, and no directive alone on the line.
pub(crate) fn read(line: &str) -> Result<Option<Directive<'_>>, String> {
    let Some((before, after)) = line.split_once("{{") else {
        return Ok(None);
    };
    if after.starts_with('#') {
        return Ok(None);
    }
    let inside = after.trim_end().strip_suffix("}}");
    let Some(inside) = inside.filter(|_| before.trim().is_empty()) else {
        return Err("a directive stands alone on its line: {{word name}}".to_owned());
    };
    let (what, rest) = inside.split_once('|').unwrap_or((inside, ""));
    let (word, name) = what.trim().split_once(' ').ok_or_else(|| {
        format!("`{inside}` is no directive: expected a word and a name, such as {{{{turn sphere_hit}}}}")
    })?;
    Ok(Some(Directive {
        word,
        name: name.trim(),
        rest: rest.trim(),
    }))
}
