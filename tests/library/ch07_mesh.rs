//! Chapter 7: meshes. The list, averaged normals, files and the teapot have tests of their own.

use glam::{Vec2, Vec3, vec2, vec3};
use raybook::accel::{Accel, Meshed, list::List};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::Shape;
use raybook::shape::attributes::{interpolate_normal, interpolate_texture};
use raybook::shape::mesh::{Mesh, MeshError};

/// An f32 is right to 6e-8; the sums here are of a few terms of size 1.
const ROUNDED: f32 = 1e-6;

/// Two triangles that share an edge: a roof over the square from 0 to 2, with its ridge along x = 1, at a height of 1.
fn roof() -> Mesh {
    let positions = vec![
        vec3(0.0, 0.0, 0.0),
        vec3(1.0, 1.0, 0.0),
        vec3(1.0, 1.0, -2.0),
        vec3(2.0, 0.0, 0.0),
    ];
    let textures = vec![
        vec2(0.0, 0.0),
        vec2(1.0, 0.0),
        vec2(1.0, 1.0),
        vec2(2.0, 0.0),
    ];
    Mesh::new(positions, vec![[0, 1, 2], [1, 3, 2]], None, Some(textures)).expect("a sound mesh")
}

fn down(x: f32, z: f32) -> Ray {
    Ray::new(vec3(x, 5.0, z), -Dir3::Y)
}

#[test]
fn what_does_not_make_a_mesh_is_refused_with_the_place() {
    let triangle = vec![Vec3::ZERO, Vec3::X, Vec3::Y];
    let message = |mesh: Result<Mesh, MeshError>| mesh.expect_err("it is refused").to_string();
    let infinite = vec![Vec3::ZERO, Vec3::X * f32::INFINITY, Vec3::Y];
    let table = [
        message(Mesh::new(
            triangle.clone(),
            vec![[0, 1, 2], [0, 1, 3]],
            None,
            None,
        )),
        message(Mesh::new(infinite, vec![[0, 1, 2]], None, None)),
        message(Mesh::new(vec![Vec3::NAN], vec![], None, None)),
        message(Mesh::new(
            triangle.clone(),
            vec![],
            Some(vec![Dir3::X; 2]),
            None,
        )),
        message(Mesh::new(triangle, vec![], None, Some(vec![Vec2::ZERO; 4]))),
    ];
    raybook_common::snapshot("ch07_mesh_refused", &table.join("\n"));
}

#[test]
fn a_mesh_of_nothing_is_a_mesh() {
    let mesh = Mesh::new(vec![], vec![], None, None).expect("nothing is wrong with it");
    assert_eq!(mesh.bounds(), Aabb::EMPTY, "it is nowhere");
    let shape = Meshed::new(mesh, List::new);
    assert_eq!(
        shape.hit(&down(0.0, 0.0), Interval::AHEAD),
        None,
        "and nothing hits it"
    );
    assert!(
        !shape.blocks(&down(0.0, 0.0), Interval::AHEAD),
        "nor is stopped by it"
    );
}

#[test]
fn attributes_that_are_not_given_are_made_up() {
    let mesh = Mesh::new(
        vec![Vec3::ZERO, Vec3::X, Vec3::Y],
        vec![[0, 1, 2]],
        None,
        None,
    )
    .expect("sound");
    assert_eq!(mesh.normals(), [Dir3::Z; 3], "normals from the triangle");
    assert_eq!(mesh.textures(), [Vec2::ZERO; 3], "texture coordinates of 0");
    assert_eq!(
        mesh.bounds(),
        Aabb::of([Vec3::ZERO, vec3(1.0, 1.0, 0.0)]),
        "bounds of the vertices"
    );
}

#[test]
fn the_hit_says_which_triangle_and_the_surface_is_interpolated_on_it() {
    let shape = Meshed::new(roof(), List::new);
    for (x, id) in [(0.5, 0), (1.5, 1)] {
        let ray = down(x, -0.5);
        let hit = shape.hit(&ray, Interval::AHEAD).expect("it hits the roof");
        assert_eq!(hit.id, id, "x = {x} is on triangle {id}");
        assert_eq!(
            shape
                .facets()
                .closest(&ray, Interval::AHEAD)
                .map(|(f, _)| f.id),
            Some(id),
            "the facet knows it too"
        );
        let at = shape.surface(&ray, &hit);
        let flat = vec3(if id == 0 { -1.0 } else { 1.0 }, 1.0, 0.0).normalize();
        assert!(
            at.normal.abs_diff_eq(flat, ROUNDED),
            "the geometric normal is the triangle's: {:?}",
            at.normal
        );
        assert!(
            at.position.abs_diff_eq(vec3(x, 0.5, -0.5), ROUNDED),
            "at half the height: {}",
            at.position
        );
        // Texture x is the world's x on this mesh, and texture y is −z/2.
        assert!(
            at.texture.abs_diff_eq(vec2(x, 0.25), ROUNDED),
            "texture {}",
            at.texture
        );
        assert!(
            at.shading_normal.y > at.normal.y,
            "towards the ridge the shading normal turns up: {:?}",
            at.shading_normal
        );
    }
}

#[test]
fn hits_on_the_roof_stay_as_they_are() {
    let rays = [
        ("left side", down(0.5, -0.5)),
        ("right side", down(1.5, -0.5)),
        (
            "left side from below",
            Ray::new(vec3(0.5, -5.0, -0.5), Dir3::Y),
        ),
        ("ridge: the first triangle", down(1.0, -1.0)),
        ("corner", down(0.0, 0.0)),
        ("beside it", down(-0.5, -0.5)),
        ("away from it", Ray::new(vec3(0.5, 5.0, -0.5), Dir3::Y)),
    ];
    raybook_common::snapshot(
        "ch07_mesh_hits",
        &raybook_common::hit_table(&Meshed::new(roof(), List::new), &rays),
    );
}

#[test]
fn interpolation_gives_back_the_corners_and_the_mean_between_them() {
    let normals = [Dir3::X, Dir3::Y, Dir3::Z];
    let textures = [vec2(0.0, 0.0), vec2(1.0, 0.0), vec2(0.0, 4.0)];
    let corners = [vec2(0.0, 0.0), vec2(1.0, 0.0), vec2(0.0, 1.0)];
    for (i, b) in corners.into_iter().enumerate() {
        assert_eq!(
            interpolate_normal(normals, b),
            normals[i],
            "corner {i} keeps its normal"
        );
        assert_eq!(
            interpolate_texture(textures, b),
            textures[i],
            "corner {i} keeps its texture"
        );
    }
    let centroid = Vec2::splat(1.0 / 3.0);
    let n = interpolate_normal(normals, centroid);
    assert!(
        n.abs_diff_eq(Vec3::splat(1.0 / 3.0_f32.sqrt()), ROUNDED),
        "the mean of three axes is the diagonal, not {n:?}"
    );
    assert!(
        (n.length() - 1.0).abs() < ROUNDED,
        "and it is normalised again"
    );
    let t = interpolate_texture(textures, centroid);
    assert!(
        t.abs_diff_eq(vec2(1.0 / 3.0, 4.0 / 3.0), ROUNDED),
        "the mean of the textures, not {t}"
    );
}

#[test]
fn weights_belong_to_their_corners() {
    let b = vec2(0.2, 0.3);
    let t = interpolate_texture([Vec2::ZERO, vec2(1.0, 0.0), vec2(0.0, 1.0)], b);
    assert!(
        t.abs_diff_eq(b, ROUNDED),
        "b₁ weighs corner 1 and b₂ corner 2, which {t} confuses"
    );
}
