//! `raybook doctor`: whether strangers' programs are contained on this machine.

use super::Done;
use raybook_chapters::kit::say::say;
use raybook_grader::sandbox::Sandbox;
use raybook_grader::sandbox::doctor::{Fate, attacks, cost_of_a_start};

/// Attacks the sandbox as a hand-in might, and tells the layers and what stopped each attack; true if none succeeded and some
/// were tried.
pub fn run() -> Done {
    #[cfg(target_os = "linux")]
    for layer in raybook_grader::sandbox::layers::all() {
        say(format!("{:<11} {}", layer.name, layer.state));
    }
    let sandbox = Sandbox::new([])?;
    let cost = cost_of_a_start(&sandbox)?;
    say(format!(
        "a start in the sandbox takes {:.1} ms longer",
        1e3 * cost.as_secs_f64()
    ));
    let attacks = attacks(Some(&sandbox))?;
    say("");
    let width = attacks
        .iter()
        .map(|attack| attack.name.chars().count())
        .max()
        .unwrap_or(0);
    for attack in &attacks {
        let fate = match attack.fate {
            Fate::Stopped => "ok",
            Fate::Reached => "BREACH",
            Fate::NotTried => "not tried",
        };
        say(format!("{fate:<9}  {:<width$}  {}", attack.name, attack.how).trim_end());
    }
    let count = |fate| attacks.iter().filter(|attack| attack.fate == fate).count();
    let (stopped, reached, missed) = (
        count(Fate::Stopped),
        count(Fate::Reached),
        count(Fate::NotTried),
    );
    say(format!(
        "\n{stopped} attacks were stopped, {reached} succeeded, {missed} could not be tried."
    ));
    if reached > 0 {
        say("Do not run strangers' programs on this machine.");
    }
    Ok(reached == 0 && stopped > 0)
}
