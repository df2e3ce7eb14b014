//! A student's own sampling patterns, asked of an answer program as questions of chapter 22.

use crate::grade::ask::{Said, silence, understand};
use crate::grade::converse::{Limits, Program, converse};
use crate::grade::own_pattern::OwnPattern;
use crate::lab::sampling::subject::Realisations;
use crate::workbook::row;
use glam::Vec2;
use std::collections::HashMap;
use std::io;
use std::time::{Duration, Instant};

/// What is wanted of each pattern.
pub struct Wanted {
    /// Numbers of points without which it cannot be shown.
    pub needed: Vec<usize>,
    /// Further numbers of points.
    pub further: Vec<usize>,
    /// How often, each time with another seed: 0, 1, 2 …
    pub realisations: u64,
    /// How long a program is asked for one pattern. What it has answered by then is what there is.
    pub patience: Duration,
}

/// What came of it.
#[derive(Default)]
pub struct Got {
    /// The points by their number; none where they cannot be shown.
    pub points: Realisations,
    /// What was wrong: points that were asked for are missing.
    pub wrong: Option<String>,
    /// What else there is to say.
    pub remarks: Vec<String>,
}

/// Fewer realisations than these tell nothing of an error.
const FEWEST: usize = 4;

/// Asks a program for one of its patterns.
///
/// The questions go to the program in batches, each of twice the points of the one before, and the small and first ones first:
/// as many realisations of 64 points as of 4096 take, so that a slow program runs out of time for all numbers alike. Where it fails, more
/// points are not asked.
///
/// # Errors
/// If the program cannot be started.
pub fn ask(
    program: &Program,
    pattern: &OwnPattern,
    wanted: &Wanted,
    limits: Limits,
) -> io::Result<Got> {
    let (start, mut got) = (Instant::now(), Got::default());
    let mut sets = sets(pattern, wanted);
    let mut batch = 1;
    let mut answers = HashMap::new();
    while !sets.is_empty() && 2 * start.elapsed() < wanted.patience {
        let points = |set: &Set| set.n;
        let mut sum = 0;
        let count = sets.iter().map(points).take_while(|n| {
            sum += n;
            sum <= batch
        });
        let rest = sets.split_off(count.count().max(1));
        let (answered, failure) = converse_about(program, pattern, &sets, limits)?;
        let done = answered.len();
        for (set, points) in sets.iter().zip(answered) {
            answers.entry(set.n).or_insert_with(Vec::new).push(points);
        }
        let left = sets.split_off(done);
        sets = left.into_iter().chain(rest).collect();
        if let Some(why) = failure {
            let n = sets.first().map_or(0, |set| set.n);
            sets.retain(|set| set.n < n);
            got.wrong = Some(format!("{why} ({n} points were asked for)"));
        }
        batch *= 2;
    }
    got.points = answers;
    got.finish(pattern, wanted);
    Ok(got)
}

/// One set of points, and the questions that ask for it.
struct Set {
    n: usize,
    number: u32,
    questions: Vec<String>,
}

/// All sets that are wanted, the cheap ones first.
fn sets(pattern: &OwnPattern, wanted: &Wanted) -> Vec<Set> {
    let mut sizes = [&wanted.needed[..], &wanted.further[..]].concat();
    sizes.sort_unstable();
    sizes.dedup();
    let most = if pattern.random { wanted.realisations } else { 1 };
    let set = |n: usize, number: u32| {
        let mut questions = Vec::new();
        (pattern.points)(n, number, &mut |question| {
            questions.push(question);
            Vec::new()
        });
        Set { n, number, questions }
    };
    let mut sets: Vec<_> = (0..most as u32)
        .flat_map(|number| sizes.iter().map(move |&n| (n, number)))
        .map(|(n, number)| set(n, number))
        .collect();
    sets.sort_by_key(|set| (set.number as usize + 1) * set.n);
    sets
}

/// Asks for some sets: the points of those before the first failure, and the failure.
fn converse_about(
    program: &Program,
    pattern: &OwnPattern,
    sets: &[Set],
    limits: Limits,
) -> io::Result<(Vec<Vec<Vec2>>, Option<String>)> {
    let questions: Vec<_> = sets.iter().flat_map(|set| set.questions.clone()).collect();
    let heard = converse(program, &questions, limits)?;
    if heard.answers.len() > questions.len() {
        let said = Said::TooMany(2);
        return Ok((Vec::new(), said.why_none()));
    }
    let mut answers = heard.answers.iter().map(|(answer, _)| answer);
    let mut done = Vec::new();
    for set in sets {
        let mut of_set = Vec::new();
        for _ in &set.questions {
            let Some(answer) = answers.next() else {
                return Ok((done, silence(heard.end).why_none()));
            };
            match read(answer) {
                Ok(points) => of_set.push(points),
                Err(why) => return Ok((done, Some(why))),
            }
        }
        let mut of_set = of_set.into_iter();
        let points = (pattern.points)(set.n, set.number, &mut |_| of_set.next().unwrap_or_default());
        if points.len() != set.n {
            let why = format!("your function returned {} points", points.len());
            return Ok((done, Some(why)));
        }
        done.push(points);
    }
    Ok((done, None))
}

/// The points of an answer.
fn read(answer: &str) -> Result<Vec<Vec2>, String> {
    /// What is printed with six digits may have been rounded up to 1.
    const ROUNDING: f32 = 1e-6;
    if let Some(why) = understand(answer).why_none() {
        return Err(why);
    }
    let points: Vec<Vec2> = row::read(answer, "point").map_err(|e| e.to_string())?;
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

impl Got {
    /// Keeps what can be shown, and says what there is to say of it.
    fn finish(&mut self, pattern: &OwnPattern, wanted: &Wanted) {
        let full = if pattern.random { wanted.realisations as usize } else { 1 };
        let same = |sets: &Vec<Vec<Vec2>>| sets.iter().all(|set| *set == sets[0]);
        let mut several = self.points.values().filter(|sets| sets.len() > 1).peekable();
        if several.peek().is_some() && several.all(same) {
            self.points.values_mut().for_each(|sets| sets.truncate(1));
            self.remarks.push("the same points whatever the seed, so that every pixel has the same ones and nothing is said of chance: let your generator follow from the seed".to_owned());
        } else {
            self.points.retain(|_, sets| sets.len() >= FEWEST.min(full));
            let fewest = self.points.values().map(Vec::len).min();
            if let Some(fewest) = fewest.filter(|fewest| *fewest < full && self.wrong.is_none()) {
                self.remarks.push(format!("{} s were enough for {fewest} of {full} realisations only where there are many points: the bands are wider there", wanted.patience.as_secs_f32()));
            }
        }
        if let Some(missing) = wanted.needed.iter().find(|n| !self.points.contains_key(n)) {
            self.points.clear();
            let slow = || format!("too slow for {missing} points");
            self.wrong.get_or_insert_with(slow);
        }
    }
}
