//! `--golden`: the golden files of a folder, which a lecturer edits without compiling.

use super::Examiners;
use raybook::store;
use raybook_chapters::kit::untrusted::Untrusted;
use raybook_grader::golden::{path, replaced};
use std::error::Error;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// Where the named cases come from.
#[derive(clap::Args)]
pub struct Golden {
    /// Take the named cases from the golden files of this folder, where it has one, instead of those that the command carries with it
    #[arg(long, value_name = "FOLDER")]
    pub golden: Option<PathBuf>,
}

impl Golden {
    /// The folder, which no stranger's program may read.
    pub fn folder(&self) -> Option<&Path> {
        self.golden.as_deref()
    }

    /// The exercises, each with the golden file of the folder, if it has one.
    ///
    /// # Errors
    /// If the folder has none of them, or a file or a named case cannot be read.
    pub fn replace(&self, examiners: Examiners) -> Result<Examiners, Box<dyn Error>> {
        let Some(folder) = &self.golden else {
            return Ok(examiners);
        };
        let mut found = 0;
        let mut replace = |examiner: &mut &'static dyn raybook_grader::examine::Examiner| {
            let file = folder.join(path(examiner.name()));
            match store::read_text(&file) {
                Ok(text) => {
                    let read = replaced(*examiner, text)
                        .map_err(|error| format!("{}: {error}", Untrusted::from(file.as_path())))?;
                    // Once for each exercise: the command ends soon.
                    *examiner = Box::leak(read);
                    found += 1;
                    Ok(())
                }
                Err(error) if error.reason.kind() == ErrorKind::NotFound => Ok(()),
                Err(error) => Err(error.to_string()),
            }
        };
        let mut examiners = examiners;
        examiners.iter_mut().try_for_each(&mut replace)?;
        if found == 0 {
            let first = examiners
                .first()
                .map_or_else(String::new, |e| path(e.name()));
            return Err(format!(
                "{}: there is no golden file here, such as {first}",
                Untrusted::from(folder.as_path())
            )
            .into());
        }
        Ok(examiners)
    }
}
