//! The text of an SVG file as plotters writes it, made smaller: the same drawing in three fifths of the bytes.

use super::figure::{HALO, SCALE};

/// What all parts of a drawing have in common: its first lines say it once.
const COMMON: [&str; 4] = [
    " font-family=\"sans-serif\"",
    " text-anchor=\"middle\"",
    " paint-order=\"stroke\"",
    " stroke-linejoin=\"round\"",
];

/// That no line is filled, which every line says otherwise.
const LINES: &str = "<style>path{fill:none}</style>";

/// What plotters writes, and what is written instead: nothing where nothing else is meant by saying nothing.
const SHORTER: [(&str, &str); 7] = [
    (" opacity=\"1\"", ""),
    (" stroke=\"none\"", ""),
    (" stroke-width=\"1\"", ""),
    (" \"/>", "\"/>"),
    ("\">\n", "\">"),
    ("\n</text>", "</text>"),
    ("#FFFFFF", "#FFF"),
];

/// The text of a drawing of this width and height, both in pixels of a figure, from what plotters wrote of its canvas.
pub(super) fn compact(svg: &str, (width, height): (u32, u32)) -> String {
    let svg = SHORTER.iter().fold(svg.to_owned(), |svg, (long, short)| {
        svg.replace(long, short)
    });
    let svg = COMMON
        .iter()
        .fold(svg, |svg, common| svg.replace(common, ""));
    let [on_canvas, shown] =
        [SCALE, 1].map(|s| format!("width=\"{}\" height=\"{}\"", s * width, s * height));
    let svg = svg.replacen(&on_canvas, &shown, 1);
    let Some((start, rest)) = svg.split_once(" xmlns=") else {
        return svg;
    };
    let rest = rest.replacen('>', &format!(">\n{LINES}\n"), 1);
    let common = COMMON.concat();
    rounded(&rimmed(&paths(&format!("{start}{common} xmlns={rest}"))))
}

/// The same drawing, with its lines as paths, which have shorter names, and whose points are counted from the point before.
fn paths(svg: &str) -> String {
    const LINE: &str = "<polyline fill=\"none\"";
    let mut parts = svg.split(LINE);
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let line = part.split_once(" points=\"");
        match line.and_then(|(style, rest)| Some((style, rest.split_once('"')?))) {
            Some((style, (points, rest))) => {
                text.extend(["<path", style, " d=\"M", &steps(points), "\"", rest]);
            }
            None => text.extend([LINE, part]),
        }
    }
    text
}

/// The points of a line as steps: `20,20 60,20 60,0` is `20,20l40,0 0,-20`.
fn steps(points: &str) -> String {
    let points = points.split_whitespace().filter_map(|point| {
        let (x, y) = point.split_once(',')?;
        Some([x.parse::<i32>().ok()?, y.parse::<i32>().ok()?])
    });
    let mut before = [0, 0];
    let steps = points.enumerate().map(|(i, [x, y])| {
        let letter = ["", "l", " "][i.min(2)];
        let step = format!("{letter}{},{}", x - before[0], y - before[1]);
        before = [x, y];
        step
    });
    steps.collect()
}

/// The same drawing, with one stroke around words that stand on themselves in white, a little moved to all sides: pixels know no other rim.
fn rimmed(svg: &str) -> String {
    let mut parts = svg.split("<text").peekable();
    let mut text = parts.next().unwrap_or_default().to_owned();
    let words = |part: &str| {
        let (_, words) = part.split_once('>')?;
        let (words, _) = words.split_once("</text>")?;
        Some(words.to_owned())
    };
    let rim = format!(" stroke=\"#FFF\" stroke-width=\"{}\"", 2.0 * HALO);
    let mut has_rim = false;
    while let Some(part) = parts.next() {
        let is_before = |next: &&str| words(next) == words(part);
        if part.contains("fill=\"#FFF\"") && parts.peek().is_some_and(is_before) {
            has_rim = true;
            continue;
        }
        text.push_str("<text");
        if has_rim {
            text.push_str(&rim);
        }
        text.push_str(part);
        has_rim = false;
    }
    text
}

/// The same, with sizes of letters that end after a tenth of a pixel, and are not smaller.
fn rounded(svg: &str) -> String {
    const SIZE: &str = " font-size=\"";
    let mut parts = svg.split(SIZE);
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        text.push_str(SIZE);
        match part.split_once('"') {
            Some((size, rest)) => {
                let tenths = size.parse().map(|size: f64| (10.0 * size).ceil() / 10.0);
                let size = tenths.map_or_else(|_| size.to_owned(), |size| size.to_string());
                text.push_str(&size);
                text.push('"');
                text.push_str(rest);
            }
            None => text.push_str(part),
        }
    }
    text
}
