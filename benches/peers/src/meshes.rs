//! What the rays are shot at, and from where it is looked at.

use crate::forest::Forest;
use crate::generated;
use glam::{Vec3, vec3};
use raybook::camera::pinhole::Pinhole;
use raybook::scene::{soup, stadium, terrain};
use raybook::shape::{
    mesh::{Mesh, MeshError},
    teapot,
};
use raybook_embree::scans;

/// A mesh by name.
pub(crate) struct Scene {
    /// The name in tables.
    pub name: &'static str,
    /// The triangles.
    pub mesh: Mesh,
    /// The same as one tree in many places, if the scene is a forest.
    pub forest: Option<Forest>,
    /// Who looks at them.
    pub camera: Pinhole,
}

/// The names of all.
pub(crate) const NAMES: [&str; 9] = [
    "teapot", "bunny", "dragon", "stadium", "terrain", "soup", "interior", "hair", "forest",
];

/// The mesh of a name.
///
/// # Errors
/// If it cannot be fetched, or there is no such name.
pub(crate) fn scene(name: &str) -> Result<Scene, String> {
    let name = NAMES.into_iter().find(|known| *known == name);
    let name =
        name.ok_or_else(|| format!("there is no mesh of this name, only {}", NAMES.join(", ")))?;
    let (mesh, forest) = if name == "forest" {
        let told = |error: MeshError| error.to_string();
        let forest = Forest::new(1).map_err(told)?;
        (forest.flat().map_err(told)?, Some(forest))
    } else {
        (mesh(name)?, None)
    };
    let (center, radius) = ball(&mesh);
    let (from, to) = match name {
        "terrain" => (vec3(-4.9, 2.5, -4.9), vec3(0.0, 0.5, 0.0)), // from a corner, above the peaks
        "stadium" => (vec3(0.45, 0.35, 0.6), vec3(0.0, 0.15, 0.0)), // the teapot, and the seats behind it
        "interior" => (vec3(0.6, 1.7, 5.0), vec3(12.0, 2.2, 6.5)),  // from one end to the other
        "forest" => (vec3(-9.0, 4.0, -9.0), vec3(42.0, 1.0, 42.0)), // from a corner, at the height of the crowns
        _ => (center + 2.2 * radius * vec3(0.4, 0.35, 0.85), center),
    };
    let camera =
        Pinhole::look_at(from, to, Vec3::Y, 0.024, 1.0).map_err(|error| error.to_string())?;
    Ok(Scene {
        name,
        mesh,
        forest,
        camera,
    })
}

fn mesh(name: &str) -> Result<Mesh, String> {
    Ok(match name {
        "bunny" => scans::bunny()?,
        "dragon" => scans::dragon()?,
        "terrain" => terrain::terrain(707), // 999,698 triangles
        "stadium" => stadium::stadium(14).mesh, // 124,124 triangles
        "soup" => soup::soup(1_000_000, 1),
        "interior" => generated::interior(1).map_err(|error| error.to_string())?,
        "hair" => generated::hair_ball(1).map_err(|error| error.to_string())?,
        _ => teapot::mesh(10),
    })
}

/// A ball around the mesh: the middle of its box, and half of the box's diagonal.
pub(crate) fn ball(mesh: &Mesh) -> (Vec3, f32) {
    let bounds = mesh.bounds();
    (bounds.center(), 0.5 * bounds.size().length())
}
