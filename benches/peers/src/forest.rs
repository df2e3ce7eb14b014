//! A forest of one tree: what instances are for.

use crate::generated::{Soup, bar, direction, mesh};
use glam::{Mat3, Vec3, vec3};
use rand::RngExt;
use raybook::math::pcg::{self, Pcg};
use raybook::shape::instance::Instance;
use raybook::shape::{Shape, mesh::Mesh, mesh::MeshError};
use std::f32::consts::TAU;
use std::sync::Arc;

/// A tree, and the places where it stands, each time turned and of another size.
pub(crate) struct Forest {
    /// The tree, whose foot is at the origin.
    pub tree: Mesh,
    /// Its places.
    pub places: Vec<Place>,
}

/// Where a tree stands: as in [`Instance`].
pub(crate) struct Place {
    /// The scale factor.
    pub scale: f32,
    /// The rotation, about the vertical.
    pub rotation: Mat3,
    /// The place of the foot.
    pub translation: Vec3,
}

/// Number of trees along either side of the forest.
const SIDE: usize = 15;

/// The distance of trees, in metres: the boxes of two trees never overlap, however they are turned.
const APART: f32 = 6.0;

/// The radius of the tree's crown, in metres. The box of a turned tree is up to √2 times as wide.
const CROWN: f32 = 1.9;

impl Forest {
    /// A forest of 225 trees of 9,372 triangles.
    ///
    /// # Errors
    /// None, for the numbers are within the domain.
    pub(crate) fn new(seed: u64) -> Result<Self, MeshError> {
        let mut rng = pcg::stream(seed, 0);
        let tree = tree(&mut rng)?;
        let places = (0..SIDE * SIDE).map(|i| Place {
            scale: 0.7 + 0.4 * rng.random::<f32>(),
            rotation: Mat3::from_rotation_y(TAU * rng.random::<f32>()),
            translation: APART * vec3((i % SIDE) as f32, 0.0, (i / SIDE) as f32),
        });
        let places = places.collect();
        Ok(Self { tree, places })
    }

    /// All trees as one mesh.
    ///
    /// # Errors
    /// None, for the numbers are within the domain.
    pub(crate) fn flat(&self) -> Result<Mesh, MeshError> {
        let mut all = Soup::new();
        for place in &self.places {
            let point = |&i: &u32| {
                let p = self.tree.positions()[i as usize];
                place.translation + place.scale * (place.rotation * p)
            };
            all.extend(self.tree.triangles().iter().flatten().map(point));
        }
        mesh(all)
    }

    /// Instances of a shape, which is the tree in a structure of its own.
    pub(crate) fn instances(&self, shape: &Arc<dyn Shape>) -> Vec<Instance> {
        let instance = |place: &Place| Instance {
            shape: Arc::clone(shape),
            scale: place.scale,
            rotation: place.rotation,
            translation: place.translation,
        };
        self.places.iter().map(instance).collect()
    }
}

/// A trunk, 180 twigs from it, and 20 leaves of two triangles around the end of each.
fn tree(rng: &mut Pcg) -> Result<Mesh, MeshError> {
    let mut all = Soup::new();
    bar(&mut all, Vec3::ZERO, 4.0 * Vec3::Y, 0.3);
    for _ in 0..180 {
        let toward = direction(rng);
        let from = vec3(0.0, 1.5 + 2.5 * rng.random::<f32>(), 0.0);
        let to = vec3(0.0, 3.0, 0.0) + (CROWN - 0.35) * toward * rng.random::<f32>().cbrt();
        bar(&mut all, from, to, 0.03);
        for _ in 0..20 {
            let at = to + 0.25 * direction(rng) * rng.random::<f32>();
            let (along, across) = (0.08 * direction(rng), 0.03 * direction(rng));
            let [p, q, r, s] = [at - along, at + across, at + along, at - across];
            all.extend([p, q, r, p, r, s]);
        }
    }
    mesh(all)
}
