//! Grading elsewhere: the files that a cluster needs to grade a class with `raybook grade`. They are short scripts, to be read and
//! changed.

pub mod beside;
pub mod github;
pub mod gradescope;

use raybook::store::{self, StoreError};
use raybook_chapters::kit::untrusted::Untrusted;
use std::path::{Path, PathBuf};

/// What is graded, and where. All paths are absolute: a cluster runs scripts in folders of its own.
#[derive(Clone, Debug)]
pub struct Job {
    /// The command itself.
    pub raybook: PathBuf,
    /// The hand-ins.
    pub hand_ins: PathBuf,
    /// The course file.
    pub course: PathBuf,
    /// The file of the course key.
    pub key: PathBuf,
    /// The folder of the results.
    pub out: PathBuf,
    /// Into how many parts the class is cut.
    pub parts: u32,
}

impl Job {
    /// A script with the words of this job in it, each as a shell reads it.
    fn filled(&self, script: &str) -> String {
        let word = |path: &Path| Untrusted::from(path).shell();
        script
            .replace("@RAYBOOK", &word(&self.raybook))
            .replace("@HAND_INS", &word(&self.hand_ins))
            .replace("@COURSE", &word(&self.course))
            .replace("@KEY", &word(&self.key))
            .replace("@OUT", &word(&self.out))
            .replace("@PARTS", &self.parts.to_string())
    }

    /// Writes the scripts of a job array for Slurm into a new folder.
    ///
    /// # Errors
    /// If there is something already, or a file cannot be written.
    pub fn slurm(&self, folder: &Path) -> Result<(), StoreError> {
        let files = [
            ("part.sh", include_str!("slurm/part.sh")),
            ("merge.sh", include_str!("slurm/merge.sh")),
            ("submit.sh", include_str!("slurm/submit.sh")),
        ];
        let files =
            files.map(|(name, script)| (PathBuf::from(name), self.filled(script).into_bytes()));
        store::new_folder(folder, &files)
    }
}
