//! Mountains: a height field of two triangles per square.
//!
//! ```
//! use raybook::scene::terrain::terrain;
//!
//! let mesh = terrain(8);
//! assert_eq!(mesh.triangles().len(), 2 * 8 * 8);
//! assert!((mesh.bounds().size().x - 10.0).abs() < 1e-4 && mesh.bounds().size().y < 2.0);
//! ```

use crate::scene::noise;
use crate::shape::mesh::Mesh;
use glam::{Vec2, Vec3, vec2};

/// A square of mountains, 10 m by 10 m and up to 2 m high, of 2n² triangles; n = 0 counts as 1.
pub fn terrain(n: u32) -> Mesh {
    let n = n.max(1);
    let place = |i: u32, j: u32| 10.0 * vec2(i as f32, j as f32) / n as f32;
    let positions = (0..=n)
        .flat_map(|j| (0..=n).map(move |i| place(i, j)))
        .map(|p| Vec3::new(p.x - 5.0, height(p), p.y - 5.0))
        .collect();
    let vertex = |i, j| j * (n + 1) + i;
    let triangles = (0..n)
        .flat_map(|j| (0..n).map(move |i| (i, j)))
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(x, y)| vertex(i + x, j + y));
            [[a, d, c], [a, c, b]]
        })
        .collect();
    Mesh::new(positions, triangles, None, None)
        .unwrap_or_else(|error| unreachable!("a terrain is finite: {error}"))
}

/// The height at p, in metres: noise squared, so that valleys are smoother than peaks.
fn height(p: Vec2) -> f32 {
    2.0 * noise::layers(0.7 * p, 7).powi(2)
}
