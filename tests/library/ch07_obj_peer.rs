//! Chapter 7: the OBJ reader against another one, the crate `tobj`, on sound files.

use glam::{Vec2, Vec3, vec2, vec3};
use proptest::prelude::*;
use raybook::shape::obj;
use std::fmt::Write;

/// The corners of all triangles: position, normal, texture point.
type Corners = Vec<(Vec3, Vec3, Vec2)>;

fn ours(text: &str) -> Corners {
    let mesh = obj::parse(text).unwrap_or_else(|wrong| panic!("{wrong}\n{text}"));
    let corner = |&i: &u32| {
        let i = i as usize;
        (mesh.positions()[i], *mesh.normals()[i], mesh.textures()[i])
    };
    mesh.triangles().iter().flatten().map(corner).collect()
}

fn theirs(text: &str) -> Corners {
    let options = tobj::LoadOptions {
        triangulate: true,
        single_index: true,
        ..Default::default()
    };
    let (models, _) = tobj::load_obj_buf(&mut text.as_bytes(), &options, |_| Ok(<_>::default()))
        .expect("a sound file");
    let mesh = &models[0].mesh;
    let corner = |&i: &u32| {
        let (i, p, n, t) = (i as usize, &mesh.positions, &mesh.normals, &mesh.texcoords);
        (
            vec3(p[3 * i], p[3 * i + 1], p[3 * i + 2]),
            vec3(n[3 * i], n[3 * i + 1], n[3 * i + 2]),
            vec2(t[2 * i], t[2 * i + 1]),
        )
    };
    mesh.indices.iter().map(corner).collect()
}

proptest! {
    #[test]
    fn both_read_the_same_from_a_sound_file(
        points in prop::collection::vec(prop::array::uniform8(-9.0_f32..9.0), 3..12),
        faces in prop::collection::vec(prop::collection::vec(prop::array::uniform3(0_usize..1000), 3..7), 1..12),
        backwards in any::<bool>(),
    ) {
        let mut text = String::new();
        for [x, y, z, nx, ny, nz, u, v] in &points {
            // Away from 0: a normal needs a direction.
            let n = vec3(nx + 20.0, *ny, *nz).normalize();
            writeln!(text, "v {x} {y} {z}\nvn {} {} {}\nvt {u} {v}", n.x, n.y, n.z).expect("a string takes all");
        }
        let count = points.len();
        for face in &faces {
            text.push('f');
            for corner in face {
                let [v, t, n] = corner.map(|i| {
                    let index = (i % count) as i64;
                    if backwards { index - count as i64 } else { index + 1 }
                });
                write!(text, " {v}/{t}/{n}").expect("likewise");
            }
            text.push('\n');
        }
        let (ours, theirs) = (ours(&text), theirs(&text));
        prop_assert_eq!(ours.len(), theirs.len(), "as many corners");
        prop_assert!(ours.len() >= 3, "and there are some");
        for (a, b) in ours.iter().zip(&theirs) {
            prop_assert_eq!((a.0, a.2), (b.0, b.2), "numbers are read exactly");
            // Ours is normalised once more.
            prop_assert!(a.1.abs_diff_eq(b.1, 1e-6), "{} and {}", a.1, b.1);
        }
    }
}

#[test]
fn the_other_reader_takes_what_ours_refuses() {
    // Why there is a reader of our own: these are facts about tobj 4, and if they change, the reason is gone.
    let read = |text: &str| {
        let options = tobj::LoadOptions {
            triangulate: true,
            single_index: true,
            ..Default::default()
        };
        tobj::load_obj_buf(&mut text.as_bytes(), &options, |_| Ok(<_>::default()))
            .map(|(models, _)| models)
    };
    for wrong in [
        "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/0 2/1 3/1",
    ] {
        assert!(read(wrong).is_ok(), "tobj reads {wrong:?}");
        assert!(obj::parse(wrong).is_err(), "we do not");
    }
    let some_normals = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 0 1 0\nf 1 2//1 3//2";
    let models = read(some_normals).expect("tobj reads it");
    assert_eq!(
        models[0].mesh.normals.len(),
        6,
        "two normals for three vertices: each goes to the vertex before its own"
    );
    assert_eq!(
        obj::parse(some_normals).expect("sound").normals()[2],
        raybook::math::dir3::Dir3::Y,
        "ours has it in place"
    );
}
