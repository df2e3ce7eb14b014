//! Landlock: which files a program may read and execute. Only a compiler may write, into its folder.

use super::paths::Readable;
use landlock::{
    ABI, Access, AccessFs, AccessNet, BitFlags, PathBeneath, PathFd, Ruleset, RulesetAttr,
    RulesetCreatedAttr, RulesetError, Scope,
};
use std::os::fd::OwnedFd;
use std::path::{Path, PathBuf};

/// The newest version of landlock whose rights are asked for. What the kernel does not know of them it leaves out.
const NEWEST: ABI = ABI::V6;

/// A set of rules that is not in force yet: everything is forbidden but reading and executing these files and folders, all that can
/// be done in those that are `written`, and writing to `devices`, where nothing of it is kept.
///
/// # Errors
/// If the kernel refuses it, or has no landlock.
pub fn ruleset(
    readable: &[Readable],
    written: &[&PathBuf],
    devices: &[&str],
) -> Result<Option<OwnedFd>, RulesetError> {
    let mut rules = Ruleset::default()
        .handle_access(AccessFs::from_all(NEWEST))?
        .handle_access(AccessNet::from_all(NEWEST))?
        .scope(Scope::from_all(NEWEST))?
        .create()?;
    for path in readable {
        let (path, rights) = match path {
            Readable::All(path) => (
                path,
                AccessFs::Execute | AccessFs::ReadFile | AccessFs::ReadDir,
            ),
            Readable::Names(path) => (path, AccessFs::ReadDir.into()),
        };
        if let Some(rule) = beneath(path, rights) {
            rules = rules.add_rule(rule)?;
        }
    }
    for path in written {
        if let Some(rule) = beneath(path, AccessFs::from_all(NEWEST)) {
            rules = rules.add_rule(rule)?;
        }
    }
    for device in devices {
        let rights = AccessFs::ReadFile | AccessFs::WriteFile;
        if let Some(rule) = beneath(Path::new(device), rights) {
            rules = rules.add_rule(rule)?;
        }
    }
    Ok(rules.into())
}

/// The rule for a path; none if there is nothing.
fn beneath(path: &Path, rights: BitFlags<AccessFs>) -> Option<PathBeneath<PathFd>> {
    let file = PathFd::new(path).ok()?;
    let rights = if path.is_dir() {
        rights
    } else {
        rights & AccessFs::from_file(NEWEST)
    };
    Some(PathBeneath::new(file, rights))
}
