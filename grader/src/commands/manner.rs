//! How a command tells what became of an exercise.

use raybook_chapters::kit::terminal::colourless;
use raybook_grader::dress::Dress;

/// The options of every command that tells people or programs what became of an exercise.
#[derive(clap::Args)]
pub struct Manner {
    /// Print JSON (its fields are described in `raybook_grader::json`, and those of `explain` in `raybook_grader::explain::account`)
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub look: Look,
}

/// The option of every command that tells people what became of an exercise.
#[derive(clap::Args)]
pub struct Look {
    /// No colours and no symbols in front of words
    #[arg(long)]
    plain: bool,
}

impl Look {
    /// How lines look in this terminal.
    pub fn dress(&self) -> Dress {
        Dress {
            colour: colourless().is_none() && !self.plain,
            symbols: !self.plain,
        }
    }
}
