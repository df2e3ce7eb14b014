//! Listings that fit a page: no line is longer than `WIDEST`, and nothing but white space changes.

/// The width of a page of the book: the maximum number of characters in a line of a listing.
pub const WIDEST: usize = 85;

/// The text, its common indent taken away, with every line that is too long broken at a space, in code after a comma if there is one:
/// comments go on as comments, code two steps further in.
pub fn fit(text: &str) -> String {
    let lines = || text.lines().filter(|line| !line.trim().is_empty());
    let indent = lines().map(|line| line.len() - line.trim_start().len());
    let indent = indent.min().unwrap_or(0);
    let mut fitted = String::new();
    let mut lines = text.lines().peekable();
    while let Some(line) = lines.next() {
        let dedented = |line: &'_ str| line.get(indent..).unwrap_or("").trim_end().to_owned();
        let mut line = dedented(line);
        while let Some((start, rest)) = broken(&line) {
            fitted.push_str(start);
            fitted.push('\n');
            line = rest;
            // What is left of a comment's line is filled up from its next line.
            let goes_on = |next: &&str| goes_on(&line, &dedented(next));
            if let Some(next) = lines.next_if(goes_on) {
                let (_, words) = comment(next).unwrap_or_default();
                line = format!("{line} {words}");
            }
        }
        fitted.push_str(&line);
        fitted.push('\n');
    }
    fitted
}

/// The mark with which a line of a comment begins, with its indent, and the comment's words.
fn comment(line: &str) -> Option<(&str, &str)> {
    let body = line.trim_start();
    let marks = ["/// ", "//! ", "// ", "# "];
    let mark = marks.into_iter().find(|mark| body.starts_with(mark))?;
    Some(line.split_at(line.len() - body.len() + mark.len()))
}

/// Whether a comment goes on in the next line: not where an item of a list or a table begins.
fn goes_on(line: &str, next: &str) -> bool {
    let (Some((mark, _)), Some((next_mark, words))) = (comment(line), comment(next)) else {
        return false;
    };
    mark == next_mark && words.starts_with(|c: char| c.is_alphanumeric() || "(`[".contains(c))
}

/// A line that is too long: the part that fits, and a line of the rest.
fn broken(line: &str) -> Option<(&str, String)> {
    if line.chars().count() <= WIDEST {
        return None;
    }
    let body = line.trim_start();
    let indent = &line[..line.len() - body.len()];
    let comment = comment(line);
    // A comment at the end of a line goes on the next line as a whole, or its end would be code.
    if comment.is_none()
        && let Some(place) = line.find(" // ")
    {
        let next = format!("{indent}        {}", line[place..].trim_start());
        return Some((line[..place].trim_end(), next));
    }
    let next = comment.map_or_else(|| format!("{indent}        "), |(mark, _)| mark.to_owned());
    let after_comma = last_space(line, WIDEST / 2, |before| before.ends_with(','));
    let place = after_comma
        .filter(|_| comment.is_none())
        .or_else(|| last_space(line, next.len(), |_| true))?;
    Some((
        line[..place].trim_end(),
        format!("{next}{}", line[place..].trim_start()),
    ))
}

/// The last space before the margin and after `from`, outside of strings, that stands `after` what it should.
fn last_space(line: &str, from: usize, after: impl Fn(&str) -> bool) -> Option<usize> {
    let (mut quoted, mut place) = (false, None);
    for (column, (i, c)) in line.char_indices().enumerate() {
        if column > WIDEST {
            break;
        }
        quoted ^= c == '"';
        if c == ' ' && !quoted && i > from && after(&line[..i]) {
            place = Some(i);
        }
    }
    place
}
