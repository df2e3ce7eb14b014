//! Equal meshes are loaded once, whatever their number: an allocator counts.

use crate::CAMERA;
use raybook_common::counting::{allocations, peak};
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// A triangle of one material, which is described in the file `paint.mtl` and has bumps and a picture.
const OBJ: &str = "mtllib paint.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl paint\nf 1 2 3\n";

/// The bytes that reading a scene needs at most, and the number of its allocations, if one table of a shape stands there this number
/// of times, each at another place.
fn cost(folder: &Path, shape: &str, count: usize) -> (usize, u64) {
    let mut text = CAMERA.to_owned();
    for i in 0..count {
        write!(text, "[[shapes]]\n{shape}\nmove_m = [{i}, 0, 0]\n").expect("a string");
    }
    let read = || raybook_scenes::parse(&folder.join("scene.toml"), &text, None);
    let (bytes, (allocations, shot)) = peak(|| allocations(read));
    shot.unwrap_or_else(|error| panic!("{error}"));
    (bytes, allocations)
}

#[test]
fn three_hundred_equal_meshes_are_one_mesh_at_three_hundred_places() {
    let folder = tempfile::tempdir().expect("a folder");
    let gallery = raybook_common::project("chapters/scenes/gallery");
    for name in ["china.png", "hammered.png"] {
        fs::copy(gallery.join(name), folder.path().join(name)).expect("copied");
    }
    fs::write(folder.path().join("a.obj"), OBJ).expect("written");
    let paint = "newmtl paint\nmap_Kd china.png\nnorm hammered.png\n";
    fs::write(folder.path().join("paint.mtl"), paint).expect("written");
    let matte = "material = { kind = \"matte\", colour = 0.5 }";
    for shape in [
        format!("kind = \"teapot\"\n{matte}"),
        format!("kind = \"teapot\"\nfacets = \"flat\"\n{matte}"),
        format!("kind = \"teapot\"\nnormal_map = \"hammered.png\"\n{matte}"),
        format!("kind = \"mesh\"\nfile = \"a.obj\"\nnormal_map = \"china.png\"\n{matte}"),
        "kind = \"mesh\"\nfile = \"a.obj\"".to_owned(),
        format!(
            "kind = \"rectangle\"\ncorner_m = [0, 0, 0]\na_m = [1, 0, 0]\nb_m = [0, 1, 0]\nnormal_map = \"china.png\"\n{matte}"
        ),
    ] {
        let [(one, _), (many, calls)] = [1, 300].map(|count| cost(folder.path(), &shape, count));
        // A table of text, a material and a place take 3 to 10 kB, a picture or a teapot a few hundred.
        assert!(one > 100_000, "{shape}: {one} bytes");
        assert!(
            many < one + 300 * 15_000,
            "{shape}: {one} bytes for one, {many} for 300, {calls} allocations"
        );
    }
}

#[test]
fn meshes_that_differ_are_not_shared() {
    let folder = tempfile::tempdir().expect("a folder");
    let matte = "material = { kind = \"matte\", colour = 0.5 }";
    let (plain, _) = cost(folder.path(), &format!("kind = \"teapot\"\n{matte}"), 1);
    let both = format!(
        "kind = \"teapot\"\n{matte}\n[[shapes]]\nkind = \"teapot\"\nfacets = \"flat\"\n{matte}"
    );
    let (both, _) = cost(folder.path(), &both, 1);
    assert!(
        both > plain + plain / 2,
        "{plain} bytes, and {both} for a flat one too"
    );
}
