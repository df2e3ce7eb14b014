//! `raybook exercise`: what an exercise asks, word by word.

use super::{Done, Target};
use raybook_chapters::kit::say::say;
use raybook_grader::describe::describe;

/// Describes exercises.
#[derive(clap::Args)]
pub struct Exercise {
    #[command(flatten)]
    target: Target,
}

impl Exercise {
    /// Describes them; without a name, all.
    pub fn run(&self) -> Done {
        let (_, examiners) = self.target.resolve()?;
        let texts: Vec<_> = examiners.into_iter().map(describe).collect();
        say(texts.join("\n"));
        Ok(true)
    }
}
