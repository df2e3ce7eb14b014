//! The meshes, and the rays that are shot at them.

use glam::{Vec2, Vec3, vec2, vec3};
use rand::RngExt;
use raybook::camera::{Camera, pinhole::Pinhole};
use raybook::math::{dir3::Dir3, pcg, ray::Ray};
use raybook::scene::{soup, stadium};
use raybook::shape::{mesh::Mesh, teapot};
use std::error::Error;

/// A mesh, and who looks at it.
pub(crate) struct Scene {
    /// The name in the table.
    pub name: &'static str,
    /// The triangles.
    pub mesh: Mesh,
    camera: Pinhole,
}

/// All meshes: some six thousand triangles, and some hundred thousand, evenly and unevenly.
pub(crate) fn scenes() -> Result<Vec<Scene>, Box<dyn Error>> {
    let around = |mesh: &Mesh| {
        let bounds = mesh.bounds();
        let from = bounds.center() + 1.1 * bounds.size().length() * vec3(0.4, 0.35, 0.85);
        (from, bounds.center())
    };
    let (teapot, soup) = (teapot::mesh(10), soup::soup(100_000, 1));
    let near = (vec3(0.45, 0.35, 0.6), vec3(0.0, 0.15, 0.0)); // the teapot, and the seats behind it
    let all = [
        ("teapot", around(&teapot), teapot),
        ("soup", around(&soup), soup),
        ("stadium", near, stadium::stadium(14).mesh),
    ];
    let scene = |(name, (from, to), mesh)| {
        let camera = Pinhole::look_at(from, to, Vec3::Y, 0.024, 1.0)?;
        Ok(Scene { name, mesh, camera })
    };
    all.into_iter().map(scene).collect()
}

impl Scene {
    /// The sets of rays, each of side²: through the pixels of a picture, and from a point of the ball around the mesh to another.
    pub(crate) fn sets(&self, side: usize) -> [(&'static str, Vec<Ray>); 2] {
        let primary = (0..side * side).map(|i| {
            let [x, y] = [i % side, i / side].map(|i| (i as f32 + 0.5) / side as f32);
            self.camera.ray(vec2(x, y), Vec2::ZERO)
        });
        let bounds = self.mesh.bounds();
        let radius = 0.5 * bounds.size().length();
        let mut rng = pcg::stream(3, 0);
        let mut at = || {
            let p = loop {
                let p = Vec3::from_array(std::array::from_fn(|_| 2.0 * rng.random::<f32>() - 1.0));
                if let Some(p) = Dir3::new(p).filter(|_| p.length() < 1.0) {
                    break p;
                }
            };
            bounds.center() + radius * *p
        };
        let random = (0..side * side).map(|_| {
            let (from, to) = (at(), at());
            Ray::new(from, Dir3::new_or(to - from, Dir3::X))
        });
        [("random", random.collect()), ("primary", primary.collect())]
    }
}
