//! Numbers as figures write them.

/// A whole number, with a thin space between the thousands.
pub fn grouped(v: f64) -> String {
    let digits = format!("{v:.0}");
    let mut grouped = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i) % 3 == 0 {
            grouped.push('\u{2009}');
        }
        grouped.push(digit);
    }
    grouped
}

/// A whole number with a minus sign instead of a hyphen.
pub fn whole(v: f64) -> String {
    format!("{v:.0}").replace('-', "−")
}
