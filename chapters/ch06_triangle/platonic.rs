//! The regular solids whose faces are triangles.

use glam::{Mat3, Vec3, vec3};
use raybook::shape::triangle::Triangle;

/// A regular solid around a centre, turned about the vertical by `turn` radians; `vertices` are its directions.
fn solid(vertices: &[Vec3], radius: f32, center: Vec3, turn: f32) -> Vec<Triangle> {
    let place = |v: Vec3| center + radius * (Mat3::from_rotation_y(turn) * v.normalize());
    let from_first = vertices[1..].iter().map(|v| v.distance(vertices[0]));
    let edge = from_first.fold(f32::INFINITY, f32::min);
    // Three vertices are a face if all of them are neighbours: no vertex is closer to another than an edge.
    let joined = |a: Vec3, b: Vec3| (a.distance(b) - edge).abs() < 0.01 * edge;
    let mut faces = Vec::new();
    for (i, &a) in vertices.iter().enumerate() {
        for (j, &b) in vertices.iter().enumerate().skip(i + 1) {
            for &c in &vertices[j + 1..] {
                if joined(a, b) && joined(b, c) && joined(c, a) {
                    let outside = (b - a).cross(c - a).dot(a + b + c) > 0.0;
                    let [b, c] = if outside { [b, c] } else { [c, b] };
                    faces.push(Triangle::new(place(a), place(b), place(c)));
                }
            }
        }
    }
    faces
}

/// 4 triangles, counter-clockwise seen from outside; it stands on one of them.
pub fn tetrahedron(radius: f32, center: Vec3, turn: f32) -> Vec<Triangle> {
    let (side, back) = (8.0_f32.sqrt(), 6.0_f32.sqrt());
    let vertices = [
        vec3(0.0, 3.0, 0.0),
        vec3(side, -1.0, 0.0),
        vec3(-0.5 * side, -1.0, back),
        vec3(-0.5 * side, -1.0, -back),
    ];
    solid(&vertices, radius, center, turn)
}

/// 8 triangles, counter-clockwise seen from outside; it stands on a vertex.
pub fn octahedron(radius: f32, center: Vec3, turn: f32) -> Vec<Triangle> {
    let vertices = Vec3::AXES.map(|axis| [axis, -axis]);
    solid(vertices.as_flattened(), radius, center, turn)
}

/// 20 triangles, counter-clockwise seen from outside; it stands on an edge.
pub fn icosahedron(radius: f32, center: Vec3, turn: f32) -> Vec<Triangle> {
    /// The golden ratio: the vertices are the corners of three rectangles of these proportions.
    const RATIO: f32 = 1.618_034;
    let rectangles = [0, 1, 2].map(|i| {
        let (a, b) = (Vec3::AXES[i], RATIO * Vec3::AXES[(i + 1) % 3]);
        [a + b, a - b, b - a, -a - b]
    });
    solid(rectangles.as_flattened(), radius, center, turn)
}

/// A still life of the three, on the plane y = 0, for a camera that looks along −z from a little above.
///
/// The icosahedron lacks a face: through the hole, the back sides of other faces are seen.
pub fn still_life() -> Vec<Triangle> {
    let mut all = icosahedron(1.05, vec3(0.0, 1.02, 0.0), 0.32);
    let at_viewer = vec3(0.0, 0.5, 0.86);
    all.retain(|face| face.normal().is_some_and(|n| n.dot(at_viewer) < 0.9));
    all.extend(tetrahedron(1.0, vec3(-2.1, 0.34, 0.2), 0.5));
    all.extend(octahedron(0.85, vec3(2.1, 0.9, 0.2), 0.35));
    all
}
