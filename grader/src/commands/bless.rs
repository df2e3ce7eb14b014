//! `raybook bless`: writes the golden answers of the visible cases, for course authors.

use super::{Done, Target};
use raybook::image::file;
use raybook_chapters::kit::say::say;
use raybook_grader::golden;

/// Writes `golden/<chapter>/<exercise>.txt`; run it in the project's folder.
#[derive(clap::Args)]
pub struct Bless {
    #[command(flatten)]
    target: Target,
}

impl Bless {
    /// Writes them, and says how many random questions were thrown away.
    pub fn run(&self) -> Done {
        let (from, examiners) = self.target.resolve()?;
        let folder = from.join("golden");
        if !folder.is_dir() {
            return Err(format!(
                "{}: there is no folder golden here; bless is for the project's own folder",
                from.display()
            )
            .into());
        }
        for examiner in examiners {
            let (text, cases) = golden::page(examiner)?;
            let path = folder.join(golden::path(examiner.name()));
            file::write_whole(&path, text.as_bytes())?;
            let percent = 100.0 * cases.thrown_away_fraction();
            say(format!(
                "{}: {} cases; {percent:.0} % of the random questions thrown away",
                path.display(),
                cases.cases.len()
            ));
        }
        Ok(true)
    }
}
