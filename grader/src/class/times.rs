//! When hand-ins came, from a table that every learning platform can write: `student,time` on each line.

use super::when::Timestamp;
use raybook_chapters::kit::untrusted::Untrusted;
use std::collections::BTreeMap;
use std::path::Path;

/// The times of a table. A first line `student,time` is its heading.
///
/// # Errors
/// The first line that cannot be understood, with its number and what was expected.
pub fn read(file: &Path, text: &str) -> Result<BTreeMap<String, Timestamp>, String> {
    let mut times = BTreeMap::new();
    for (i, line) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        if line.trim().is_empty() || (i == 0 && line.trim() == "student,time") {
            continue;
        }
        let wrong = |what: &str| format!("{}:{}: {what}", Untrusted::from(file), i + 1);
        let (student, time) = line
            .rsplit_once(',')
            .ok_or_else(|| wrong("this must be a student and a time, with a comma between"))?;
        let student = student.trim().trim_matches('"').to_owned();
        let time = time.trim().trim_matches('"').parse().map_err(wrong)?;
        if times.insert(student.clone(), time).is_some() {
            return Err(wrong(&format!(
                "{} is here twice",
                Untrusted::from(student)
            )));
        }
    }
    Ok(times)
}
