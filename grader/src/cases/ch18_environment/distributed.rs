//! Whether directions are distributed as the light of a map.

use super::OfMap;
use super::{cell, toward};
use crate::Verdict;
use crate::together::widest_gap;
use glam::{Vec2, Vec3, vec2};
use raybook::light::environment::latlong;
use raybook_workbook::exercises::ch18_environment::SampleEnvironment;
use std::f64::consts::PI;

/// How many of the points may be on the wrong side of a line. Measured for 400 maps and 24 right methods (by rows, by columns,
/// or all texels in one list; either number first, from either end): at most 5.6.
const STRAY: usize = 10;

/// Whether directions are distributed as the map's light.
pub fn distributed(q: &SampleEnvironment, directions: &[Vec3]) -> Verdict {
    let (width, height) = (q.width as usize, q.height as usize);
    let places: Vec<Vec2> = directions
        .iter()
        .map(|d| latlong::place(toward(d.x, d.y, d.z)))
        .collect();
    let all = places.len() as f64;
    if directions.is_empty() {
        return Ok(()); // none are due: the map is black
    }
    let compare = |what: &dyn Fn() -> String, found: usize, share: f64| {
        let right = share * all;
        if (found as f64 - right).abs() <= STRAY as f64 {
            return Ok(());
        }
        let what = what();
        Err(format!(
            "of {all} directions {found} are {what}, and should be about {right:.0}"
        ))
    };
    let light = q.all_light();
    let share_of = |x: usize, y: usize| q.light(x, y) / light;
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        let inside = |p: &&Vec2| cell(p.x, q.width) == x && cell(p.y, q.height) == y;
        let found = places.iter().filter(inside).count();
        let share = share_of(x, y);
        compare(&|| format!("in column {x} of row {y}"), found, share)?;
        // At the very edge, rounding may have chosen the side.
        let deep = |p: &&Vec2| {
            let within =
                vec2(p.x * q.width as f32, p.y * q.height as f32) - vec2(x as f32, y as f32);
            (within - 0.5).abs().max_element() < 0.5 - 1e-3
        };
        let found = places.iter().filter(deep).count();
        if share == 0.0 && found > 0 {
            return Err(format!(
                "{found} directions are in the black texel {x} of row {y}"
            ));
        }
    }
    // Above every circle of latitude and left of every meridian, in quarters of texels, there must be the right share.
    for quarter in 1..4 * height {
        let (y, part) = (quarter / 4, 0.25 * (quarter % 4) as f64);
        let row = |y: usize| (0..width).map(|x| share_of(x, y)).sum::<f64>();
        let [top, bottom] = [y, y + 1].map(|row| latlong::cosine(row, height));
        let angle = PI * quarter as f64 / (4 * height) as f64;
        let of_row = (top - angle.cos()) / (top - bottom);
        let share = (0..y).map(row).sum::<f64>() + if part > 0.0 { of_row * row(y) } else { 0.0 };
        let found = places
            .iter()
            .filter(|p| f64::from(p.y) < angle / PI)
            .count();
        compare(
            &|| format!("within {:.0}° of +y", angle.to_degrees()),
            found,
            share,
        )?;
    }
    for quarter in 1..4 * width {
        let (x, part) = (quarter / 4, 0.25 * (quarter % 4) as f64);
        let column = |x: usize| (0..height).map(|y| share_of(x, y)).sum::<f64>();
        let share = (0..x).map(column).sum::<f64>() + part * column(x);
        let edge = quarter as f64 / (4 * width) as f64;
        let found = places.iter().filter(|p| f64::from(p.x) < edge).count();
        compare(&|| format!("left of {edge:.2} on the map"), found, share)?;
    }
    Ok(())
}

/// What may be chosen slightly too often, by less light and by more, by lower numbers of columns and rows and by higher ones; and by how many
/// standard deviations of a texel's the mean may be off.
const LEANINGS: [(f64, [&str; 2]); 3] = [
    (0.018, ["dark texels", "bright texels"]),
    (0.012, ["columns at the left", "columns at the right"]),
    (0.012, ["rows at the top", "rows at the bottom"]),
];

/// Whether the directions of many answers fill their texels from edge to edge, and are distributed among texels as their light is.
///
/// Measured for 60 students with 34 maps each and 48 right methods (those of [`distributed`], and what is left of a number taken for a place in
/// the texel too): no gap is wider than 0.0051 of a texel, the shares of a texel are at most 0.0070 off, and the mean logarithm of the light at most
/// 0.0098 of its standard deviation. Weights of the radiance to the power of 1.05 or 0.95 are 0.029 off at least. The mean column and row are at most
/// 0.0064 of theirs off (60 students, 4 methods); a first row that weighs 5 % too much is 0.016 off at least.
pub fn together(answers: &[(SampleEnvironment, Vec<Vec3>)]) -> Verdict {
    let mut within = [Vec::new(), Vec::new()];
    let (mut off, mut maps) = ([0.0; LEANINGS.len()], [0.0; LEANINGS.len()]);
    for (q, got) in answers {
        let light = q.all_light();
        if got.is_empty() || light == 0.0 {
            continue;
        }
        let weights = |x: usize, y: usize| {
            let is_lit = q.light(x, y) > 0.0;
            is_lit.then(|| [q.texel(x, y).ln(), x as f64, y as f64])
        };
        let texels =
            (0..q.height as usize).flat_map(|y| (0..q.width as usize).map(move |x| (x, y)));
        let texels = texels.filter_map(|(x, y)| Some((q.light(x, y) / light, weights(x, y)?)));
        let (mut means, mut squares) = ([0.0; LEANINGS.len()], [0.0; LEANINGS.len()]);
        for (share, weights) in texels {
            for (i, v) in weights.into_iter().enumerate() {
                means[i] += share * v;
                squares[i] += share * v * v;
            }
        }
        let mut found = [0.0; LEANINGS.len()];
        for d in got {
            let place = latlong::place(toward(d.x, d.y, d.z));
            let (x, y) = (cell(place.x, q.width), cell(place.y, q.height));
            let [top, bottom] = [y, y + 1].map(|row| latlong::cosine(row, q.height as usize));
            within[0].push(f64::from(place.x * q.width as f32) - x as f64);
            within[1].push((top - f64::from(d.y)) / (top - bottom));
            for (i, v) in weights(x, y).into_iter().flatten().enumerate() {
                found[i] += (v - means[i]) / got.len() as f64;
            }
        }
        for i in 0..LEANINGS.len() {
            let variance = squares[i] - means[i] * means[i];
            if variance > 1e-6 {
                off[i] += found[i] / variance.sqrt();
                maps[i] += 1.0;
            }
        }
    }
    for (places, what) in within.iter().zip([
        "of a texel's width, from its left edge",
        "of a texel's height, by area from its upper edge",
    ]) {
        are_uniform(places.clone(), what)?;
    }
    are_independent(&within)?;
    for (i, (bound, [less, more])) in LEANINGS.into_iter().enumerate() {
        if maps[i] > 0.0 && f64::abs(off[i] / maps[i]) > bound {
            let which = if off[i] > 0.0 { more } else { less };
            return Err(format!("{which} are chosen slightly too often"));
        }
    }
    Ok(())
}

/// Whether places along a texel's width, which are uniform, are independent of those along its height, which are too: their
/// correlation, which sees linear dependence only.
///
/// Measured for 60 students with 34 maps each and 32 right methods, not for all 48 of [`together`]: at most 0.016. Who uses one
/// number for both has 1 or −1.
fn are_independent([across, down]: &[Vec<f64>; 2]) -> Verdict {
    const CORRELATION: f64 = 0.1;
    let products = across.iter().zip(down).map(|(x, y)| (x - 0.5) * (y - 0.5));
    let correlation = 12.0 * products.sum::<f64>() / across.len() as f64;
    if correlation.abs() > CORRELATION {
        return Err("the directions lie along a diagonal of their texels".to_owned());
    }
    Ok(())
}

/// Whether places in texels, as shares of a width or a height, go from 0 to 1 without a gap, and equally many to each part.
fn are_uniform(mut places: Vec<f64>, what: &str) -> Verdict {
    const GAP: f64 = 0.008;
    const SHARE: f64 = 0.012;
    let [from, to] = widest_gap(places.iter().copied().chain([0.0, 1.0]));
    if to - from > GAP {
        return Err(format!("no direction is from {from:.3} to {to:.3} {what}"));
    }
    places.sort_by(f64::total_cmp);
    let n = places.len() as f64;
    for (i, v) in places.into_iter().enumerate() {
        let share = i as f64 / n;
        if (share - v).abs() > SHARE {
            return Err(format!(
                "{:.1} % of the directions are in the first {:.1} % {what}",
                100.0 * share,
                100.0 * v
            ));
        }
    }
    Ok(())
}
