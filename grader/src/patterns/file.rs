//! Points of one's own, from a file.

use glam::{Vec2, vec2};
use raybook::store;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_chapters::lab::settings::FEW;
use raybook_chapters::lab::subject::{Realisations, Subject};
use std::error::Error;
use std::path::Path;

/// Reads a file of points as a subject of the lab: of each of its sets the first n points, for all n of some sizes for which it has enough.
///
/// # Errors
/// If it cannot be read, a line is no point of the unit square, or there are not enough points for a size that is needed.
pub fn read(path: &Path, [needed, further]: [Vec<usize>; 2]) -> Result<Subject, Box<dyn Error>> {
    let text = store::read_text(path)?;
    let name = Untrusted::from(path);
    let sets = sets(&text).map_err(|why| format!("{name}: {why}"))?;
    let most = sets.iter().map(Vec::len).max().unwrap_or(0);
    if let Some(n) = needed.iter().find(|n| **n > most) {
        let fewer = if most < FEW {
            format!("give {FEW} or more, which the page shows at the least")
        } else {
            format!("give more points, or ask for fewer, --points {most} and --samples 1,4")
        };
        return Err(format!(
            "{name}: its largest set has {most} points, and a figure shows {n}: {fewer}"
        )
        .into());
    }
    let mut given = Realisations::new();
    for n in needed.into_iter().chain(further) {
        let first = sets.iter().filter_map(|set| set.get(..n));
        let first: Vec<_> = first.map(<[Vec2]>::to_vec).collect();
        if !first.is_empty() {
            given.insert(n, first);
        }
    }
    let stem = Path::new(path.file_stem().unwrap_or_default());
    Ok(Subject::from_file(
        &Untrusted::from(stem).to_string(),
        given,
    ))
}

/// The sets of points in a text: x and y on each line, by spaces or a comma; an empty line ends a set, and # a line.
fn sets(text: &str) -> Result<Vec<Vec<Vec2>>, String> {
    let mut sets = vec![Vec::new()];
    for (number, line) in (1..).zip(text.lines()) {
        let content = line.split('#').next().unwrap_or_default().trim();
        if content.is_empty() {
            if line.trim().is_empty() && sets.last().is_some_and(|set| !set.is_empty()) {
                sets.push(Vec::new());
            }
            continue;
        }
        let words = content.split(|c: char| c == ',' || c.is_whitespace());
        let numbers = words.filter(|word| !word.is_empty()).map(str::parse::<f64>);
        let numbers: Result<Vec<_>, _> = numbers.collect();
        let inside = |x: &f64| (0.0..1.0).contains(x);
        match numbers.as_deref() {
            Ok([x, y]) if inside(x) && inside(y) => {
                let below_one = |x: f64| (x as f32).min(1.0_f32.next_down());
                if let Some(set) = sets.last_mut() {
                    set.push(vec2(below_one(*x), below_one(*y)));
                }
            }
            _ => {
                let line = Untrusted::from(content);
                return Err(format!(
                    "line {number}: {line}: x and y are expected, two numbers from 0 up to but not including 1, like 0.25 0.75"
                ));
            }
        }
    }
    sets.retain(|set| !set.is_empty());
    if sets.is_empty() {
        return Err("there are no points in it; each line is a point, x and y".to_owned());
    }
    Ok(sets)
}
