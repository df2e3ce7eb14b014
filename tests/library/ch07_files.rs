//! Chapter 7: mesh files from the disk, most of them broken.

use glam::{Vec3, vec2};
use raybook::math::dir3::Dir3;
use raybook::shape::mesh::Mesh;
use raybook::shape::mesh_file::{LoadError, load};
use std::fmt::Write;
use std::fs;

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/// Loads a file that holds these bytes, through the file system as a student would.
fn load_bytes(name: &str, bytes: &[u8]) -> Result<Mesh, LoadError> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join(name);
    fs::write(&path, bytes).expect("the file can be written");
    load(&path)
}

/// What is said of a broken file, with its folder left out.
fn refusal(name: &str, bytes: &[u8]) -> String {
    let error = load_bytes(name, bytes)
        .expect_err("it is broken")
        .to_string();
    let start = error.find(name).expect("the message names the file");
    error[start..].to_owned()
}

#[test]
fn every_broken_obj_is_refused_with_the_place() {
    let cases: &[(&str, &str)] = &[
        ("a word for a number", "v 0 0 0\nv 1 zero 0\n"),
        ("a decimal comma", "v 0 0 0\nv 1,5 0 0\n"),
        ("NaN", "# fine\nv 0 nan 0\n"),
        ("infinite", "v 0 0 -inf\n"),
        ("too large for f32", "v 0 0 1e39\n"),
        ("two coordinates", "v 0 0\n"),
        ("eight numbers", "v 0 0 0 1 1 1 1 1\n"),
        ("texture point without numbers", "vt\n"),
        ("infinite texture point", "vt 0 inf\n"),
        ("normal with two numbers", "vn 0 1\n"),
        ("vertex out of range", &format!("{TRIANGLE}f 1 2 4\n")),
        (
            "vertex used before it is given",
            "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n",
        ),
        ("vertex 0", &format!("{TRIANGLE}\n\nf 0 1 2\n")),
        ("too far back", &format!("{TRIANGLE}f -1 -2 -4\n")),
        (
            "a huge index",
            &format!("{TRIANGLE}f 1 2 9223372036854775807\n"),
        ),
        (
            "an index beyond i64",
            &format!("{TRIANGLE}f 1 2 99999999999999999999\n"),
        ),
        (
            "the smallest index",
            &format!("{TRIANGLE}f 1 2 -9223372036854775808\n"),
        ),
        (
            "texture point out of range",
            &format!("{TRIANGLE}vt 0 0\nf 1/1 2/2 3/1\n"),
        ),
        (
            "texture point 0",
            &format!("{TRIANGLE}vt 0 0\nf 1/0 2/1 3/1\n"),
        ),
        (
            "normal out of range",
            &format!("{TRIANGLE}f 1//1 2//1 3//1\n"),
        ),
        ("half an index", &format!("{TRIANGLE}f 1 2.5 3\n")),
        ("no index", &format!("{TRIANGLE}vt 0 0\nf 1 /1 3\n")),
        (
            "four indices",
            &format!("{TRIANGLE}vt 0 0\nvn 0 0 1\nf 1 2/1/1/1 3\n"),
        ),
        ("two corners", &format!("{TRIANGLE}f 1 2\n")),
        (
            "joined lines",
            &format!("{TRIANGLE}f 1 2 \\\n  3 \\\n  x\n"),
        ),
        (
            "columns count characters, not bytes",
            "v\u{3000}0\u{3000}zero 0\n",
        ),
        ("empty", ""),
        ("no faces", TRIANGLE),
        ("a comment", "# v 0 0 0\n"),
    ];
    let mut table = String::new();
    for (what, text) in cases {
        writeln!(table, "{what}: {}", refusal("file.obj", text.as_bytes()))
            .expect("a string takes all");
    }
    let latin = [TRIANGLE.as_bytes(), b"v 1 \xe9 0\n"].concat();
    writeln!(
        table,
        "a number that is not UTF-8: {}",
        refusal("file.obj", &latin)
    )
    .expect("likewise");
    writeln!(
        table,
        "UTF-16: {}",
        refusal("file.obj", b"\xff\xfev\0 \x000\0")
    )
    .expect("likewise");
    writeln!(
        table,
        "another kind of file: {}",
        refusal("file.gltf", b"{}")
    )
    .expect("likewise");
    let missing = load("file.obj".as_ref())
        .expect_err("there is none")
        .to_string();
    assert!(
        missing.starts_with("file.obj: cannot read this file: "),
        "{missing}"
    );
    raybook_common::snapshot("ch07_obj_refused", &table);
}

#[test]
fn every_broken_stl_is_refused_with_the_place() {
    let begin = "solid a b\nfacet normal 0 0 1\n outer loop\n";
    let corners = "  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n";
    let binary = |triangles: u32, corner: f32| {
        let record = [corner.to_le_bytes().repeat(12), vec![0; 2]].concat();
        [vec![b' '; 80], triangles.to_le_bytes().to_vec(), record].concat()
    };
    let cases: &[(&str, Vec<u8>)] = &[
        (
            "wrong keyword",
            "solid\nfacet normal 0 0 1\n outer lop\n vertx 0 0 0\n".into(),
        ),
        ("NaN", format!("{begin}  vertex 0 nan 0\n").into()),
        ("two coordinates", format!("{begin}  vertex 0 0\n").into()),
        (
            "four corners",
            format!("{begin}{corners}  vertex 0 0 0\n").into(),
        ),
        (
            "two corners",
            format!("{begin}  vertex 0 0 0\n  vertex 1 0 0\n endloop\n").into(),
        ),
        (
            "ends in a triangle",
            format!("{begin}{corners} endloop\n").into(),
        ),
        ("has no end", "solid\n".into()),
        ("goes on after its end", "solid\nendsolid\nfacet\n".into()),
        ("no triangles", "solid\nendsolid\n".into()),
        ("empty", Vec::new()),
        ("something else", b"hello".to_vec()),
        ("binary and cut short", binary(2, 0.0)),
        ("binary and too long", binary(0, 0.0)),
        ("binary with NaN", binary(1, f32::NAN)),
        ("binary without triangles", binary(0, 0.0)[..84].to_vec()),
        ("more triangles than memory", binary(u32::MAX, 0.0)),
    ];
    let mut table = String::new();
    for (what, bytes) in cases {
        writeln!(table, "{what}: {}", refusal("file.stl", bytes)).expect("a string takes all");
    }
    raybook_common::snapshot("ch07_stl_refused", &table);
}

#[test]
fn every_broken_ply_is_refused_with_the_place() {
    let vertex = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    let face = "element face 1\nproperty list uchar int vertex_indices\n";
    let header = |format: &str| format!("ply\nformat {format} 1.0\n{vertex}{face}end_header\n");
    let text = |body: &str| header("ascii") + body;
    let binary = |corner: f32, index: i32| {
        let places = corner.to_le_bytes().repeat(9);
        let face = [vec![3], [0, 1, index].map(i32::to_le_bytes).concat()].concat();
        [header("binary_little_endian").into_bytes(), places, face].concat()
    };
    let sound = binary(1.0, 2);
    let cases: &[(&str, Vec<u8>)] = &[
        ("empty", Vec::new()),
        ("something else", b"PNG\0\n".to_vec()),
        ("no end of the header", b"ply\nformat ascii 1.0\n".to_vec()),
        ("no format", format!("ply\n{vertex}").into()),
        ("a format of its own", b"ply\nformat utf8 1.0\n".to_vec()),
        ("a later version", b"ply\nformat ascii 2.0\n".to_vec()),
        (
            "a count of rows below 0",
            b"ply\nformat ascii 1.0\nelement vertex -1\n".to_vec(),
        ),
        (
            "a property of nothing",
            b"ply\nformat ascii 1.0\nproperty float x\n".to_vec(),
        ),
        (
            "an unknown type",
            text("").replace("float z", "half z").into(),
        ),
        ("no z", text("").replace("float z", "float w").into()),
        (
            "no corners",
            text("").replace("vertex_indices", "neighbours").into(),
        ),
        (
            "no faces",
            text("")
                .replace(face, "")
                .replace("vertex 3", "vertex 0")
                .into(),
        ),
        ("no rows", text("").into()),
        ("a row is missing", text("0 0 0\n1 0 0\n0 1 0\n").into()),
        ("two coordinates", text("0 0 0\n1 0\n").into()),
        ("four coordinates", text("0 0 0 1\n").into()),
        ("a word for a number", text("0 zero 0\n").into()),
        ("NaN", text("0 0 nan\n").into()),
        ("too large for f32", text("0 0 1e39\n").into()),
        ("too far", text("0 2e9 0\n").into()),
        (
            "vertex out of range",
            text("0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n").into(),
        ),
        (
            "a vertex below 0",
            text("0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n").into(),
        ),
        (
            "half a vertex",
            text("0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n").into(),
        ),
        ("two corners", text("0 0 0\n1 0 0\n0 1 0\n2 0 1\n").into()),
        (
            "fewer corners than promised",
            text("0 0 0\n1 0 0\n0 1 0\n4 0 1 2\n").into(),
        ),
        (
            "half a length of a list",
            text("0 0 0\n1 0 0\n0 1 0\n2.5 0 1 2\n").into(),
        ),
        (
            "goes on",
            text("0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n").into(),
        ),
        (
            "too small",
            text("0 0 0\n1e-20 0 0\n0 0 0\n3 0 1 2\n").into(),
        ),
        ("binary and cut short", sound[..sound.len() - 1].to_vec()),
        ("binary and too long", [&sound[..], b"!!"].concat()),
        ("binary with NaN", binary(f32::NAN, 2)),
        ("binary and too far", binary(2e9, 2)),
        ("binary with a vertex out of range", binary(1.0, 3)),
        (
            "more rows than memory",
            String::from_utf8_lossy(&sound)
                .replace("vertex 3", "vertex 18446744073709551615")
                .into(),
        ),
    ];
    let mut table = String::new();
    for (what, bytes) in cases {
        writeln!(table, "{what}: {}", refusal("file.ply", bytes)).expect("a string takes all");
    }
    raybook_common::snapshot("ch07_ply_refused", &table);
}

#[test]
fn what_is_not_needed_does_no_harm() {
    let mut bytes = b"\xef\xbb\xbfv 0 0 0 1\r\nv 9 9 9\r\nv 1 0 0 0.5 0.5 0.5 # red\r\n".to_vec();
    bytes.extend(b"o caf\xe9\r\ng all\nusemtl blue\nmtllib x.mtl\ns off\nl 1 2\np 1\n\n\tv 0 1 0\nvt 0.5\nvn 0 0 0\n");
    bytes.extend(b"f 1/1/1 \\\n 3/1/1 4//\n");
    let mesh = load_bytes("FILE.OBJ", &bytes).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(
        mesh.positions(),
        [Vec3::ZERO, Vec3::X, Vec3::Y],
        "a mark, colours, weights, and a vertex without a face"
    );
    assert_eq!(
        mesh.normals(),
        [Dir3::Z; 3],
        "a normal without length is a missing one"
    );
    assert_eq!(
        mesh.textures()[0],
        vec2(0.5, 0.0),
        "a texture point may have one coordinate"
    );
}

#[test]
fn a_face_of_more_than_a_million_corners_is_refused() {
    let text = |corners: usize| {
        format!(
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3{}\n",
            " 1".repeat(corners - 3)
        )
    };
    let error = refusal("long.obj", text(2_000_000).as_bytes());
    assert!(
        error.contains("long.obj:4:1: a face (f) needs 3 corners or more, and at most a million"),
        "{error}"
    );
    let mesh = load_bytes("fan.obj", text(100_000).as_bytes()).expect("this is not too long");
    assert_eq!(mesh.triangles().len(), 100_000 - 2, "a fan");
}

/// 27 MB of text make thirteen million triangles, which take forty times as much.
#[test]
fn faces_that_take_more_memory_than_the_budget_are_refused() {
    let face = format!("f{}\n", " 1".repeat(1_000_000));
    let text = format!("v 0 0 0\n{}", face.repeat(13));
    let error = refusal("bomb.obj", text.as_bytes());
    assert!(
        error.contains("bomb.obj:14:1: up to here the mesh takes 1.1 GB of memory"),
        "{error}"
    );
}
