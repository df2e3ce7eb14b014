//! Chapter 7: what the PLY reader makes of sound files and of bytes of any kind; broken files are in ch07_files.rs.

use glam::{Vec2, Vec3, vec2};
use proptest::prelude::*;
use raybook::math::dir3::Dir3;
use raybook::shape::mesh::Mesh;
use raybook::shape::ply::parse;

/// A square of two triangles that stand at an edge, as a mesh reads it from one face of four corners.
const HEADER: &str = "comment made by \\\nobj_info by hand\nelement vertex 4\nproperty float x\nproperty double y\nproperty short z
property uchar red\nelement camera 2\nproperty list int8 uint16 seen\nproperty int8 id\nelement nothing 4000000000
element face 1\nproperty uint8 flags\nproperty list uchar uint vertex_indices\nend_header\n";

fn file(format: &str, body: &[u8]) -> Vec<u8> {
    [
        format!("ply\nformat {format} 1.0\n{HEADER}").as_bytes(),
        body,
    ]
    .concat()
}

fn text() -> Vec<u8> {
    file(
        "ascii",
        b"0 0 0 255\n1 0 0 9\n\n1 1 1e0 9\r\n0 1 0 7\n2 9 8 -1\n0 -5\n3 4 0 1 2 3\n\n",
    )
}

/// The same file in binary; `order` turns the bytes of a number, least first, into the file's order.
fn binary(format: &str, order: impl Fn(&mut [u8])) -> Vec<u8> {
    let mut body = Vec::new();
    let mut push = |bytes: &[u8]| {
        let mut bytes = bytes.to_vec();
        order(&mut bytes);
        body.extend(bytes);
    };
    for (x, y, z) in [
        (0_f32, 0_f64, 0_i16),
        (1.0, 0.0, 0),
        (1.0, 1.0, 1),
        (0.0, 1.0, 0),
    ] {
        push(&x.to_le_bytes());
        push(&y.to_le_bytes());
        push(&z.to_le_bytes());
        push(&[7]);
    }
    push(&[2]);
    push(&9_u16.to_le_bytes());
    push(&8_u16.to_le_bytes());
    push(&(-1_i8).to_le_bytes());
    push(&[0]);
    push(&(-5_i8).to_le_bytes());
    push(&[3]);
    push(&[4]);
    for index in 0_u32..4 {
        push(&index.to_le_bytes());
    }
    file(format, &body)
}

fn sound(bytes: &[u8]) -> Mesh {
    parse(bytes).unwrap_or_else(|wrong| panic!("{wrong}"))
}

#[test]
fn text_and_both_orders_of_bytes_say_the_same() {
    let mesh = sound(&text());
    assert_eq!(
        mesh.positions(),
        [Vec3::ZERO, Vec3::X, Vec3::ONE, Vec3::Y],
        "colours, cameras and elements without properties are passed over"
    );
    assert_eq!(mesh.triangles(), [[0, 1, 2], [0, 2, 3]], "a fan");
    assert_eq!(sound(&binary("binary_little_endian", |_| {})), mesh);
    assert_eq!(sound(&binary("binary_big_endian", <[u8]>::reverse)), mesh);
}

#[test]
fn normals_and_texture_coordinates_are_read_by_their_names() {
    let file = |names: &str, normal: &str| {
        let header = format!(
            "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_index\nelement vertex 3
property float z\nproperty float x\nproperty float y\n{names}property float nx\nproperty float ny\nproperty float nz\nend_header\n"
        );
        format!("{header}3 0 1 2\n0 0 0 .5 .25 0 2 0\n0 1 0 0 0 {normal}\n0 0 1 0 0 0 1 0\n")
    };
    for (u, v) in [("u", "v"), ("s", "t"), ("texture_u", "texture_v")] {
        let names = format!("property float {u}\nproperty float {v}\n");
        let mesh = sound(file(&names, "0 1 0").as_bytes());
        assert_eq!(
            mesh.positions(),
            [Vec3::ZERO, Vec3::X, Vec3::Y],
            "any order"
        );
        assert_eq!(mesh.normals(), [Dir3::Y; 3], "the file's, at length 1");
        assert_eq!(mesh.textures(), [vec2(0.5, 0.25), Vec2::ZERO, Vec2::ZERO]);
        let mesh = sound(file(&names, "0 0 0").as_bytes());
        assert_eq!(
            mesh.normals(),
            [Dir3::Z; 3],
            "averaged, for one has no length"
        );
    }
}

proptest! {
    /// One to three bytes of a sound file are others, or its end is missing.
    #[test]
    fn nothing_makes_the_reader_panic(
        kind in 0..3,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..3),
        length in any::<prop::sample::Index>(),
        any in prop::collection::vec(any::<u8>(), 0..99),
    ) {
        let mut bytes = match kind {
            0 => text(),
            1 => binary("binary_little_endian", |_| {}),
            _ => binary("binary_big_endian", <[u8]>::reverse),
        };
        for (place, byte) in changes {
            *place.get_mut(&mut bytes) = byte;
        }
        for bytes in [&bytes[..], &bytes[..length.index(bytes.len())], &any[..]] {
            if let Ok(mesh) = parse(bytes) {
                prop_assert!(mesh.positions().iter().all(|p| p.is_finite()), "only sound meshes get through");
            }
        }
    }

    #[test]
    fn numbers_that_are_written_come_back(numbers in prop::array::uniform9(-1e6_f32..1e6)) {
        let header = |format| format!(
            "ply\nformat {format} 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z
element face 1\nproperty list char char vertex_indices\nend_header\n"
        );
        let [a, b, c] = [0, 3, 6].map(|i| Vec3::from_slice(&numbers[i..]));
        let row = |p: Vec3| format!("{} {} {}\n", p.x, p.y, p.z);
        let text = format!("{}{}{}{}3 0 1 2\n", header("ascii"), row(a), row(b), row(c));
        let little = numbers.into_iter().flat_map(f32::to_le_bytes);
        let little: Vec<u8> = header("binary_little_endian").bytes().chain(little).chain([3, 0, 1, 2]).collect();
        for file in [text.as_bytes(), &little] {
            let mesh = parse(file).map_err(|wrong| TestCaseError::fail(wrong.to_string()))?;
            prop_assert_eq!(mesh.positions(), [a, b, c]);
        }
    }
}
