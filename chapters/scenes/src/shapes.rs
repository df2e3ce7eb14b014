//! Shapes, and where they are placed.

use crate::fields::{Fields, Make};
use crate::lights::corner_and_edges;
use crate::materials::Materials;
use crate::wrong::TextError;
use glam::{EulerRot, Mat3, Vec2, Vec3};
use raybook::accel::{Meshed, wide_bvh::WideBvh};
use raybook::image::tone;
use raybook::math::dir3::Dir3;
use raybook::scene::{model, world::Thing};
use raybook::shape::cuboid::Cuboid;
use raybook::shape::mesh::Mesh;
use raybook::shape::normal_map::NormalMap;
use raybook::shape::{Shape, instance::Instance, mesh_file, plane::Plane, sphere::Sphere, teapot};
use std::path::PathBuf;
use std::sync::Arc;

pub(crate) fn things(all: Vec<Fields>, materials: &Materials) -> Result<Vec<Thing>, TextError> {
    let mut things = Vec::new();
    for fields in all {
        let (made, placing) = made(fields, materials)?;
        let place = |thing: Thing| Thing {
            shape: placing.place(thing.shape),
            ..thing
        };
        things.extend(made.into_iter().map(place));
    }
    Ok(things)
}

/// The kinds by their words, of which a mesh may bring materials of its own.
const KINDS: [(&str, Make<Arc<dyn Shape>>); 7] = [
    ("sphere", sphere),
    ("plane", plane),
    ("box", cuboid),
    ("rectangle", rectangle),
    ("polygon", polygon),
    ("teapot", teapot),
    ("mesh", mesh),
];

/// The things of a table, before they are placed.
fn made(mut fields: Fields, materials: &Materials) -> Result<(Vec<Thing>, Placing), TextError> {
    let shape = fields.kind("a shape", &KINDS)?;
    let material = materials.get(&fields)?;
    let things = if fields.text("kind")? == Some("mesh") && material.is_none() {
        let path = file(&fields)?;
        model::load(&path).map_err(|error| fields.wrong("file", error.to_string()))?
    } else {
        let shape = shape(&fields)?;
        let material = fields.need("material", |_, _| Ok(material.clone()))?;
        vec![Thing { shape, material }]
    };
    let placing = Placing::of(&fields)?;
    fields.finish()?;
    Ok((things, placing))
}

fn sphere(fields: &Fields) -> Result<Arc<dyn Shape>, TextError> {
    let center = fields.need("center_m", Fields::place)?;
    let sphere = Sphere::checked(center, fields.need("radius_m", Fields::length)?);
    Ok(Arc::new(sphere.map_err(|error| {
        fields.wrong("center_m", error.to_string())
    })?))
}

fn plane(fields: &Fields) -> Result<Arc<dyn Shape>, TextError> {
    let normal = fields.direction("normal")?.unwrap_or(Dir3::Y);
    let point = fields.need("point_m", Fields::place)?;
    Ok(Arc::new(Plane::through(point, normal)))
}

fn cuboid(fields: &Fields) -> Result<Arc<dyn Shape>, TextError> {
    let corner = fields.need("corner_m", Fields::place)?;
    let opposite = fields.need("opposite_m", Fields::place)?;
    Ok(Arc::new(Cuboid::between(corner, opposite)))
}

/// Two triangles; texture coordinates go from 0 to 1 along both edges.
fn rectangle(fields: &Fields) -> Result<Arc<dyn Shape>, TextError> {
    let [corner, a, b] = corner_and_edges(fields)?;
    let corners = vec![corner, corner + a, corner + a + b, corner + b];
    let textures = vec![Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
    let mesh = Mesh::new(corners, vec![[0, 1, 2], [0, 2, 3]], None, Some(textures));
    let mesh = mesh.map_err(|error| fields.wrong("corner_m", error.to_string()))?;
    meshed(fields, mesh)
}

/// Triangles from the first corner to the edges that do not touch it.
fn polygon(fields: &Fields) -> Result<Arc<dyn Shape>, TextError> {
    let corners = fields.need("corners_m", Fields::places)?;
    let count = corners.len() as u32;
    if count < 3 {
        return Err(fields.wrong("corners_m", "a polygon has at least three corners"));
    }
    let fan = (1..count - 1).map(|i| [0, i, i + 1]).collect();
    let mesh = Mesh::new(corners, fan, None, None);
    let mesh = mesh.map_err(|error| fields.wrong("corners_m", error.to_string()))?;
    meshed(fields, mesh)
}

fn teapot(fields: &Fields) -> Result<Arc<dyn Shape>, TextError> {
    meshed(fields, teapot::mesh(16))
}

fn mesh(fields: &Fields) -> Result<Arc<dyn Shape>, TextError> {
    let mesh = mesh_file::load(&file(fields)?);
    let mesh = mesh.map_err(|error| fields.wrong("file", error.to_string()))?;
    meshed(fields, mesh)
}

/// The path of the mesh that the field `file` names.
fn file(fields: &Fields) -> Result<PathBuf, TextError> {
    let name = fields.need("file", Fields::text)?;
    Ok(fields.source().beside(name))
}

/// The mesh in a tree, with the look that the table gives it.
fn meshed(fields: &Fields, mesh: Mesh) -> Result<Arc<dyn Shape>, TextError> {
    Ok(Arc::new(Meshed::new(look(fields, mesh)?, WideBvh::new)))
}

/// What is done to the facets of a mesh.
type Facets = fn(&Mesh) -> Mesh;

/// The same by its words.
const FACETS: [(&str, Facets); 3] = [
    ("flat", Mesh::flat),
    ("smooth", Mesh::smooth),
    ("as they are", Mesh::clone),
];

/// The mesh with flat or smooth facets, and with the bumps of a normal map.
fn look(fields: &Fields, mesh: Mesh) -> Result<Mesh, TextError> {
    let mesh = match fields.choice("facets", &FACETS)? {
        Some(facets) => facets(&mesh),
        None => mesh,
    };
    let Some(name) = fields.text("normal_map")? else {
        return Ok(mesh);
    };
    let path = fields.source().beside(name);
    let picture = raybook::image::file::load(&path)
        .map_err(|error| fields.wrong("normal_map", error.to_string()))?;
    let map = NormalMap::new(&picture.map(|pixel| pixel.map(tone::encode_srgb)));
    Ok(mesh.with_bumps(Arc::new(map)))
}

/// Where a shape is put: first scaled, then turned around x, y and z, then moved.
struct Placing {
    scale: f32,
    turn: Vec3,
    to: Vec3,
}

impl Placing {
    fn of(fields: &Fields) -> Result<Self, TextError> {
        Ok(Self {
            scale: fields.number("scale", 1e-6..=1e6)?.unwrap_or(1.0),
            turn: fields.place("turn_degrees")?.unwrap_or(Vec3::ZERO),
            to: fields.place("move_m")?.unwrap_or(Vec3::ZERO),
        })
    }

    fn place(&self, shape: Arc<dyn Shape>) -> Arc<dyn Shape> {
        if self.scale == 1.0 && self.turn == Vec3::ZERO && self.to == Vec3::ZERO {
            return shape;
        }
        let Vec3 { x, y, z } = self.turn * (std::f32::consts::PI / 180.0);
        Arc::new(Instance {
            shape,
            scale: self.scale,
            rotation: Mat3::from_euler(EulerRot::ZYX, z, y, x),
            translation: self.to,
        })
    }
}
