//! Asking an answer program for one of its patterns, again and again.

use crate::ask::{Asker, Reply, Said};
use crate::converse::{Limits, Program};
use crate::patterns::OwnPattern;
use crate::patterns::got::{FEWEST, Got, Wanted};
use crate::prints::short;
use glam::Vec2;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_chapters::lab::subject::Realisations;
use raybook_workbook::row;
use std::io;
use std::time::Instant;

/// Asks a program for one of its patterns.
///
/// First it is asked for what is needed at least; then for as much as there is time for at the pace at which it has answered so
/// far, in two or three batches. A slow program so has less of everything, and least of what takes longest. Where it fails,
/// more points are not asked.
///
/// # Errors
/// If the program cannot be started.
pub fn ask(
    program: &Program,
    pattern: &OwnPattern,
    wanted: &Wanted,
    limits: Limits,
) -> io::Result<Got> {
    let start = Instant::now();
    let mut asker = Asker::at_once(program, limits);
    let (mut points, mut wrong) = (Realisations::new(), None);
    let mut sets = sets(pattern, wanted);
    let mut batch = sets.iter().filter(|set| set.needed).count();
    let mut asked = 0;
    while batch > 0 {
        let rest = sets.split_off(batch);
        asked += sets.iter().map(|set| set.n).sum::<usize>();
        let (answered, failure) = converse_about(&mut asker, pattern, &sets)?;
        let done = answered.len();
        for (set, answer) in sets.iter().zip(answered) {
            points.entry(set.n).or_default().push(answer);
        }
        let left = sets.split_off(done);
        sets = left.into_iter().chain(rest).collect();
        if let Some(why) = failure {
            let n = sets.first().map_or(0, |set| set.n);
            sets.retain(|set| set.n < n);
            points.retain(|size, _| *size < n);
            wrong = Some(match n {
                0 | 1 => why,
                _ => format!("{why} ({n} points were asked for)"),
            });
        }
        // Half of the time that is left, because the pace may become slower; and no batch for the last bit of it.
        let taken = start.elapsed();
        let left = (wanted.patience * 3 / 4).saturating_sub(taken);
        let pace = asked as f64 / taken.as_secs_f64();
        batch = affordable(&sets, 0.5 * pace * left.as_secs_f64());
        // A program that starts slowly may be quick afterwards: as long as most of the time is left, one more is asked.
        if taken < left / 4 {
            batch = batch.max(1).min(sets.len());
        }
    }
    Ok(Got::of(points, wrong, pattern.realisations(wanted), wanted))
}

/// How many of the first sets have at most `points` points together.
fn affordable(sets: &[Set], points: f64) -> usize {
    let mut sum = 0;
    let fits = |set: &&Set| {
        sum += set.n;
        sum as f64 <= points
    };
    sets.iter().take_while(fits).count()
}

/// One set of points, and the questions that ask for it.
struct Set {
    /// Whether it is one of the few without which there is no figure.
    needed: bool,
    n: usize,
    number: u32,
    questions: Vec<String>,
}

/// All sets that are wanted: what is needed first, then the cheap ones first, as many points of each number.
fn sets(pattern: &OwnPattern, wanted: &Wanted) -> Vec<Set> {
    let mut sizes = [&wanted.needed[..], &wanted.further[..]].concat();
    sizes.sort_unstable();
    sizes.dedup();
    let set = |n: usize, number: u32| {
        let mut questions = Vec::new();
        (pattern.points)(n, number, &mut |question| {
            questions.push(question);
            Vec::new()
        });
        let needed = wanted.needed.contains(&n) && number < FEWEST as u32;
        Set {
            needed,
            n,
            number,
            questions,
        }
    };
    let mut sets: Vec<_> = (0..pattern.realisations(wanted) as u32)
        .flat_map(|number| sizes.iter().map(move |&n| (n, number)))
        .map(|(n, number)| set(n, number))
        .collect();
    sets.sort_by_key(|set| (!set.needed, (set.number as usize + 1) * set.n));
    sets
}

/// Asks for some sets: the points of those before the first failure, and the failure.
fn converse_about(
    asker: &mut Asker<'_>,
    pattern: &OwnPattern,
    sets: &[Set],
) -> io::Result<(Vec<Vec<Vec2>>, Option<String>)> {
    let questions: Vec<_> = sets.iter().flat_map(|set| set.questions.clone()).collect();
    let replies = asker.ask(&questions)?;
    let mut replies = replies.iter();
    let mut done = Vec::new();
    for set in sets {
        let mut of_set = Vec::new();
        for _ in &set.questions {
            match replies.next().map(read) {
                Some(Ok(points)) => of_set.push(points),
                Some(Err(why)) => return Ok((done, Some(why))),
                None => return Ok((done, None)),
            }
        }
        let mut of_set = of_set.into_iter();
        let points = (pattern.points)(set.n, set.number, &mut |_| {
            of_set.next().unwrap_or_default()
        });
        if points.len() != set.n {
            let why = format!(
                "your function returned {} points where there should be {}",
                points.len(),
                set.n
            );
            return Ok((done, Some(why)));
        }
        done.push(points);
    }
    Ok((done, None))
}

/// The points of an answer.
fn read(reply: &Reply) -> Result<Vec<Vec2>, String> {
    /// What is printed with six digits may have been rounded up to 1.
    const ROUNDING: f32 = 1e-6;
    let Said::Answer(answer) = &reply.said else {
        return Err(reply.said.why_none().unwrap_or_default() + reply.said.help());
    };
    let points: Vec<Vec2> = row::read(answer.unescaped(), "point")
        .map_err(|error| short(&Untrusted::from(error.to_string())))?;
    let inside = |p: &Vec2| {
        let (least, most) = (Vec2::splat(-ROUNDING), Vec2::splat(1.0 + ROUNDING));
        p.cmpge(least).all() && p.cmple(most).all()
    };
    if let Some(p) = points.iter().find(|p| !inside(p)) {
        return Err(format!(
            "your point ({}, {}) is not in the unit square, 0 ≤ x < 1 and 0 ≤ y < 1",
            p.x, p.y
        ));
    }
    let below_one = |p: Vec2| p.clamp(Vec2::ZERO, Vec2::splat(1.0_f32.next_down()));
    Ok(points.into_iter().map(below_one).collect())
}
