//! Chapter 7: what the OBJ reader makes of sound text; broken files are in ch07_files.rs.

use glam::{Vec2, Vec3, vec2, vec3};
use proptest::prelude::*;
use raybook::math::dir3::Dir3;
use raybook::shape::mesh::Mesh;
use raybook::shape::obj;

fn sound(text: &str) -> Mesh {
    obj::parse(text).unwrap_or_else(|wrong| panic!("{wrong}\n{text}"))
}

#[test]
fn a_polygon_is_a_fan_around_its_first_corner() {
    let mesh = sound("v 0 0 0\nv 2 0 0\nv 3 1 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4 5\n");
    assert_eq!(
        mesh.triangles(),
        [[0, 1, 2], [0, 2, 3], [0, 3, 4]],
        "five corners, three triangles"
    );
    assert_eq!(
        mesh.normals(),
        [Dir3::Z; 5],
        "missing normals are computed: counter-clockwise is outside"
    );
    assert_eq!(
        mesh.textures(),
        [Vec2::ZERO; 5],
        "missing texture coordinates are 0"
    );
}

#[test]
fn negative_indices_count_back_from_their_line() {
    let two = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nv 1 0 1\nv 0 1 1\nf -3 -2 -1\n";
    let mesh = sound(two);
    assert_eq!(
        mesh,
        sound(
            &two.replacen("-3 -2 -1", "1 2 3", 1)
                .replace("-3 -2 -1", "4 5 6")
        ),
        "the same mesh"
    );
    assert_eq!(
        mesh.positions()[3],
        Vec3::Z,
        "the second face is the upper one"
    );
}

#[test]
fn separate_indices_split_a_vertex() {
    // A square folded along its diagonal 1–3: the two faces share positions, not normals; vertex 3 has one texture too.
    let mesh = sound(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 2\nvn 0 1 0\n\
         f 1/1/1 2/2/1 3/3/1\nf 1/1/2 3/3/2 4/4/2\n",
    );
    assert_eq!(
        mesh.triangles(),
        [[0, 1, 2], [3, 4, 5]],
        "nothing is shared where the normals differ"
    );
    assert_eq!(
        mesh.positions()[4],
        vec3(1.0, 1.0, 0.0),
        "and the positions follow"
    );
    assert_eq!(
        mesh.normals()[..3],
        [Dir3::Z; 3],
        "normals are normalised, and the first face's are z"
    );
    assert_eq!(mesh.normals()[3..], [Dir3::Y; 3], "the second face's are y");
    assert_eq!(
        mesh.textures()[5],
        vec2(0.0, 1.0),
        "texture points go with their corner"
    );
}

#[test]
fn a_seam_in_the_texture_does_not_show_in_missing_normals() {
    let faces = "v 0 0 0\nv 0 0 -1\nv -1 -1 0\nv 1 -1 0\nvt 0 0\nvt 1 0\n";
    let mesh = sound(&format!("{faces}f 1/1 2/1 3/1\nf 1/2 4/2 2/2\n"));
    let smooth = sound(&format!("{faces}f 1 2 3\nf 1 4 2\n"));
    assert_eq!(
        mesh.positions().len(),
        6,
        "the ridge is split by its texture points"
    );
    assert_eq!(smooth.positions().len(), 4, "and whole without them");
    assert_eq!(
        mesh.normals()[0],
        smooth.normals()[0],
        "the ridge's normal is the mean either way"
    );
    assert_eq!(
        mesh.normals()[0],
        mesh.normals()[3],
        "on both sides of the seam"
    );
    assert!(
        mesh.normals()[0].y > 0.999,
        "and points up: {:?}",
        mesh.normals()[0]
    );
}

#[test]
fn the_chapter_draws_any_mesh_or_says_why_not() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let draw = |text: &str| {
        let path = folder.path().join("any.obj");
        std::fs::write(&path, text).expect("the file can be written");
        let mut command =
            assert_cmd::Command::cargo_bin("ch07_mesh").expect("the chapter has a binary");
        command
            .args(["--width", "16", "--samples", "1", "--mesh"])
            .arg(&path);
        command
            .arg("--out")
            .arg(folder.path())
            .output()
            .expect("it runs")
    };
    // Of a size, of no size, and as large as the domain: whatever is there to see, nothing panics.
    for corner in ["0 1 0", "0 0 0", "0 1e9 -1e9"] {
        let done = draw(&format!("v 0 0 0\nv 1 0 0\nv {corner}\nf 1 2 3\n"));
        assert!(
            done.status.success(),
            "{corner}: {}",
            String::from_utf8_lossy(&done.stderr)
        );
        assert!(
            folder.path().join("ch07_mesh/picture.exr").is_file(),
            "{corner}: there is a picture"
        );
    }
    let refused = draw("v 0 0\n");
    assert_eq!(
        refused.status.code(),
        Some(2),
        "an error of the input, not a panic"
    );
    let said = String::from_utf8_lossy(&refused.stderr);
    assert!(said.contains("any.obj:1:1: a vertex"), "{said}");
}

proptest! {
    #[test]
    fn nothing_makes_the_reader_panic(
        lines in prop::collection::vec("(v|vt|vn|f|f|f|#|o)( (-?[0-9]{1,3}|-?[0-9]/-?[0-9]?/-?[0-9]|nan|1e99|/|\\\\|é|\u{feff}))*", 0..20),
        bytes in prop::collection::vec(any::<u8>(), 0..60),
    ) {
        let text = lines.join("\n");
        if let Ok(mesh) = obj::parse(&text) {
            prop_assert!(mesh.positions().iter().all(|p| p.is_finite()), "only sound meshes get through");
        }
        let _ = obj::parse(&String::from_utf8_lossy(&bytes));
    }
}
