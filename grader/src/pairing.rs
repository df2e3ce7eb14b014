//! Whether answers stand beside the questions that they belong to.
//!
//! A program that is silent once and speaks twice another time gives as many answers as there are questions, and those in
//! between belong to their neighbours. This is noticed by what is wrong: it is asked again.

use crate::ask::{Asker, Reply, Said};
use std::io;

/// How many answers may have changed for each of their questions to be asked in a process of its own, whatever they are: random numbers
/// change all of them, and processes take long to start.
const FEW: usize = 4;

/// Asks once more what was wrong, and returns the replies as they should have been understood, if the answers had moved.
///
/// The questions are asked again in another order; those whose answers have changed, in a process for each, which nothing can
/// move: but not if they are more than a few, and what was said first is not said again to any question, for then nothing has moved.
/// If each answer that has changed was the one to another question, the answers had moved, and the new ones count; where a
/// question has none now, nobody knows what it was, so that may be one more. If not, the program says another thing each time,
/// and its first word counts.
///
/// # Errors
/// If the program cannot be started.
pub fn put_right(
    asker: &mut Asker<'_>,
    questions: &[String],
    replies: &[Reply],
    wrong: &[usize],
) -> io::Result<Option<Vec<Reply>>> {
    let answered = |i: usize| matches!(replies[i].said, Said::Answer(_));
    if !wrong.iter().any(|&i| answered(i)) {
        return Ok(None);
    }
    // Every second one first: what moves along then comes to a question that is not its neighbour's.
    let (even, odd): (Vec<usize>, Vec<usize>) = wrong.iter().partition(|&&i| i % 2 == 0);
    let order = [even, odd].concat();
    let asked: Vec<_> = order.iter().map(|&i| questions[i].clone()).collect();
    let again = asker.ask(&asked)?;
    let changed = order.into_iter().zip(&again);
    let changed = changed.filter(|(i, again)| again.said != replies[*i].said);
    let mut changed: Vec<_> = changed.map(|(i, _)| i).collect();
    let is_said_again = |&i: &usize| again.iter().any(|again| again.said == replies[i].said);
    if changed.len() > FEW && !changed.iter().any(is_said_again) {
        return Ok(None);
    }
    let mut right = replies.to_vec();
    for &i in &changed {
        let mut alone = Vec::new();
        asker.ask_apart(&questions[i..=i], &mut alone)?;
        right[i] = alone.swap_remove(0);
        if matches!(right[i].said, Said::Over(_)) {
            return Ok(None);
        }
    }
    changed.retain(|&i| right[i].said != replies[i].said);
    let is_anothers = |i: usize| {
        let mut others = right.iter().enumerate().filter(|(j, _)| *j != i);
        others.any(|(_, reply)| reply.said == replies[i].said)
    };
    let (moved, other): (Vec<_>, Vec<_>) = changed.into_iter().partition(|&i| is_anothers(i));
    let silent = |&&i: &&usize| !right[i].said.is_line();
    let silent = moved.iter().chain(&other).filter(silent).count();
    let moved = moved.iter().any(|&i| answered(i)) && other.len() <= silent;
    if moved {
        asker.begin_anew();
    }
    Ok(moved.then_some(right))
}
