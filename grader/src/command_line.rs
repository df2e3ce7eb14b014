//! The program that `--program` names: a file, or a command such as `python3 answer.py`.

use crate::converse::Program;
use crate::recipe::split;
use crate::sandbox::Sandbox;
use std::ffi::OsString;
use std::io;
use std::path::{Path, PathBuf};

/// The program. What is no file and has several words is a command; its words are split as a shell splits them. A word that names a
/// file is that file, wherever the program runs.
///
/// # Errors
/// If the present folder is not known.
pub fn program(named: &Path, sandbox: Option<Sandbox>) -> io::Result<Program> {
    let words = named.to_str().filter(|_| !named.exists()).and_then(split);
    let Some([first, rest @ ..]) = words.as_deref().filter(|words| words.len() > 1) else {
        return Ok(Program {
            file: std::path::absolute(named)?,
            arguments: Vec::new(),
            folder: PathBuf::new(),
            sandbox,
        });
    };
    let mut script = None;
    let mut arguments: Vec<OsString> = Vec::new();
    for word in rest {
        if Path::new(word).is_file() {
            let file = std::path::absolute(word)?;
            arguments.push(file.clone().into());
            script.get_or_insert(file);
        } else {
            arguments.push(word.into());
        }
    }
    Ok(Program {
        file: if first.contains('/') {
            std::path::absolute(first)?
        } else {
            first.into()
        },
        arguments,
        folder: PathBuf::new(),
        sandbox: sandbox.map(|sandbox| sandbox.with_script(script)),
    })
}
