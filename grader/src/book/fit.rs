//! Listings that fit a page: no line is longer than `WIDEST`, and nothing but white space changes.

/// The width of a page of the book: the maximum number of characters in a line of a listing.
pub const WIDEST: usize = 85;

/// The text, its common indent taken away, with every line that is too long broken at a space: comments go on as comments, code
/// two steps further in.
pub(super) fn fit(text: &str) -> String {
    let lines = || text.lines().filter(|line| !line.trim().is_empty());
    let indent = lines().map(|line| line.len() - line.trim_start().len());
    let indent = indent.min().unwrap_or(0);
    let mut fitted = String::new();
    for line in text.lines() {
        let mut line = line.get(indent..).unwrap_or("").trim_end().to_owned();
        while let Some((start, rest)) = broken(&line) {
            fitted.push_str(start);
            fitted.push('\n');
            line = rest;
        }
        fitted.push_str(&line);
        fitted.push('\n');
    }
    fitted
}

/// A line that is too long: the part that fits, and a line of the rest.
fn broken(line: &str) -> Option<(&str, String)> {
    if line.chars().count() <= WIDEST {
        return None;
    }
    let body = line.trim_start();
    let indent = &line[..line.len() - body.len()];
    let comment = ["/// ", "//! ", "// ", "# "]
        .into_iter()
        .find(|mark| body.starts_with(mark));
    // A comment at the end of a line goes on the next line as a whole, or its end would be code.
    if comment.is_none()
        && let Some(place) = line.find(" // ")
    {
        let next = format!("{indent}        {}", line[place..].trim_start());
        return Some((line[..place].trim_end(), next));
    }
    let next = comment.map_or_else(
        || format!("{indent}        "),
        |mark| format!("{indent}{mark}"),
    );
    let place = last_space(line, next.len())?;
    Some((
        line[..place].trim_end(),
        format!("{next}{}", line[place..].trim_start()),
    ))
}

/// The last space before the margin and after `from`, outside of strings.
fn last_space(line: &str, from: usize) -> Option<usize> {
    let (mut quoted, mut place) = (false, None);
    for (column, (i, c)) in line.char_indices().enumerate() {
        if column > WIDEST {
            break;
        }
        quoted ^= c == '"';
        if c == ' ' && !quoted && i > from {
            place = Some(i);
        }
    }
    place
}

#[cfg(test)]
mod tests {
    use super::{WIDEST, fit};

    #[test]
    fn long_lines_are_broken_and_nothing_is_lost() {
        let words = "word ".repeat(40);
        for start in ["    /// ", "    let x = ", "# "] {
            let text = format!("{start}{words}\n");
            let fitted = fit(&text);
            assert!(
                fitted.lines().all(|line| line.chars().count() <= WIDEST),
                "every line fits: {fitted}"
            );
            assert!(fitted.lines().count() > 2, "it was too long");
            assert_eq!(fitted.matches("word").count(), 40, "no word is lost");
        }
    }

    #[test]
    fn a_comment_at_the_end_of_a_line_stays_a_comment() {
        let code = "within: within.min(1.0 - f32::EPSILON / 2.0),";
        let comment = "// it may have been rounded up to the next whole number";
        assert_eq!(
            fit(&format!("    {code} {comment}\n")),
            format!("{code}\n        {comment}\n")
        );
    }

    #[test]
    fn a_string_is_not_broken() {
        let text = format!("    let x = \"{}\";\n", "word ".repeat(40));
        assert_eq!(fit(&text), text.trim_start(), "a space in a string counts");
    }
}
