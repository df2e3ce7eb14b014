//! A triangle soup: random triangles that are not connected.
//!
//! ```
//! use raybook::scene::soup::soup;
//!
//! let mesh = soup(1000, 1);
//! assert_eq!((mesh.triangles().len(), mesh.positions().len()), (1000, 3000)); // no triangle shares a corner
//! assert_eq!(mesh, soup(1000, 1)); // the same seed, the same soup
//! ```

use crate::math::pcg;
use crate::shape::mesh::Mesh;
use glam::Vec3;
use rand::RngExt;

/// A cube of side 1 m, uniformly filled with n small random triangles, each in a cube of the volume 1/n.
///
/// On this scene, grids and trees can be compared with theory, because every place is like every other. The same `seed` gives the
/// same triangles.
pub fn soup(n: u32, seed: u64) -> Mesh {
    let mut rng = pcg::stream(seed, 0);
    let size = 0.5 / (n.max(1) as f32).cbrt();
    let mut vector = || Vec3::from_array(std::array::from_fn(|_| rng.random::<f32>()));
    let mut positions = Vec::with_capacity(3 * n as usize);
    for _ in 0..n {
        let center = vector();
        positions.extend([(); 3].map(|()| center + size * (2.0 * vector() - Vec3::ONE)));
    }
    let triangles = (0..n).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    Mesh::new(positions, triangles, None, None)
        .unwrap_or_else(|error| unreachable!("a soup is finite: {error}"))
}
