//! Chapter 7: what the STL reader makes of sound files; broken ones are in ch07_files.rs.

use glam::{Vec3, vec3};
use proptest::prelude::*;
use raybook::math::dir3::Dir3;
use raybook::shape::mesh::Mesh;
use raybook::shape::stl::{is_binary, parse, parse_binary};
use std::fmt::Write;

/// Two triangles that share an edge, the second folded up along it.
const FOLDED: [[Vec3; 3]; 2] = [
    [Vec3::ZERO, Vec3::X, Vec3::Y],
    [Vec3::X, Vec3::ONE, Vec3::Y],
];

fn text(triangles: &[[Vec3; 3]]) -> String {
    let mut text = "solid any name\n".to_owned();
    for corners in triangles {
        text.push_str("facet normal nan nan nan\n  outer loop\n");
        for p in corners {
            writeln!(text, "    vertex {} {} {}", p.x, p.y, p.z).expect("a string takes all");
        }
        text.push_str("  endloop\nendfacet\n");
    }
    text + "endsolid any name\n"
}

fn binary(header: &str, triangles: &[[Vec3; 3]]) -> Vec<u8> {
    let mut bytes = format!("{header:80}").into_bytes();
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for corners in triangles {
        let numbers = [Vec3::NAN].iter().chain(corners).flat_map(Vec3::to_array);
        bytes.extend(numbers.flat_map(f32::to_le_bytes).chain([0, 0]));
    }
    bytes
}

/// The corners of all triangles, in order.
fn corners(mesh: &Mesh) -> Vec<[Vec3; 3]> {
    let place = |i: u32| mesh.positions()[i as usize];
    mesh.triangles().iter().map(|t| t.map(place)).collect()
}

#[test]
fn corners_at_the_same_place_become_one_vertex() {
    let mesh = parse(&text(&FOLDED)).unwrap_or_else(|wrong| panic!("{wrong}"));
    assert_eq!(
        mesh.triangles(),
        [[0, 1, 2], [1, 3, 2]],
        "six corners, four vertices"
    );
    let (flat, folded) = (Vec3::Z, vec3(-1.0, -1.0, 1.0)); // twice the areas: 1 and √3
    let edge = (flat + folded).normalize();
    assert!(
        mesh.normals()[1].abs_diff_eq(edge, 1e-6),
        "averaged on the edge: {:?}",
        mesh.normals()[1]
    );
    assert_eq!(
        mesh.normals()[0],
        Dir3::Z,
        "the triangle's own where it is alone; the file's NaN is passed over"
    );
    let minus_zero =
        FOLDED.map(|corners| corners.map(|p| if p.z == 0.0 { p.with_z(-0.0) } else { p }));
    let mixed = [FOLDED[0], minus_zero[1]];
    assert_eq!(
        parse(&text(&mixed)).map(|m| m.positions().len()),
        Ok(4),
        "−0 is where 0 is"
    );
}

#[test]
fn a_binary_file_may_begin_with_solid() {
    for header in ["", "solid made by a program that does not know better"] {
        let bytes = binary(header, &FOLDED);
        assert!(is_binary(&bytes), "its size tells, not {header:?}");
        assert_eq!(
            parse_binary(&bytes).map(|m| corners(&m)),
            Ok(FOLDED.to_vec()),
            "and it is read"
        );
    }
    assert!(!is_binary(text(&FOLDED).as_bytes()), "text is text");
}

#[test]
fn keywords_may_be_large_and_solids_several() {
    let twice = text(&FOLDED[..1]) + &text(&FOLDED[1..]).to_uppercase();
    let mesh = parse(&twice).unwrap_or_else(|wrong| panic!("{wrong}"));
    assert_eq!(corners(&mesh), FOLDED, "two solids make one mesh");
}

proptest! {
    #[test]
    fn text_and_binary_say_the_same(
        numbers in prop::collection::vec(prop::array::uniform9(-1e6_f32..1e6), 0..20),
    ) {
        let triangles: Vec<_> = numbers
            .iter()
            .map(|n| [0, 3, 6].map(|i| vec3(n[i], n[i + 1], n[i + 2])))
            .collect();
        let (a, b) = (parse(&text(&triangles)), parse_binary(&binary("", &triangles)));
        prop_assert_eq!(a.as_ref().ok(), b.as_ref().ok(), "{:?} {:?}", &a, &b);
        prop_assert_eq!(corners(&b.expect("it is sound")), triangles, "what was written comes back");
    }

    #[test]
    fn nothing_makes_the_reader_panic(
        lines in prop::collection::vec("(facet|facet normal|outer loop|vertex( 1| nan| x){0,4}|endloop|endfacet|endsolid|solid)", 0..12),
        bytes in prop::collection::vec(any::<u8>(), 0..200),
        triangles in 0_u32..4,
    ) {
        let _ = parse(&format!("solid\n{}", lines.join("\n")));
        let _ = parse(&String::from_utf8_lossy(&bytes));
        let mut bytes = bytes;
        if let Some(count) = bytes.get_mut(80..84) {
            count.copy_from_slice(&triangles.to_le_bytes());
        }
        if let Ok(mesh) = parse_binary(&bytes) {
            prop_assert!(mesh.positions().iter().all(|p| p.is_finite()), "only sound meshes get through");
        }
    }
}
