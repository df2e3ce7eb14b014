//! Shapes, and where they are placed.

use crate::fields::Fields;
use crate::lights::square;
use crate::materials::Materials;
use crate::wrong::TextError;
use glam::{EulerRot, Mat3, Vec2, Vec3};
use raybook::accel::{Meshed, wide_bvh::WideBvh};
use raybook::image::tone;
use raybook::math::dir3::Dir3;
use raybook::math::domain::LARGEST;
use raybook::scene::{model, world::Thing};
use raybook::shape::cuboid::Cuboid;
use raybook::shape::mesh::Mesh;
use raybook::shape::normal_map::NormalMap;
use raybook::shape::{Shape, instance::Instance, mesh_file, plane::Plane, sphere::Sphere, teapot};
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

/// The things of a table, before they are placed.
fn made(mut fields: Fields, materials: &Materials) -> Result<(Vec<Thing>, Placing), TextError> {
    let kinds = ["sphere", "plane", "box", "rectangle", "teapot", "mesh"];
    let kind = fields.choice("kind", &kinds)?;
    let kind = fields.need("kind", kind)?;
    fields.named(format!("a shape of the kind `{kind}`"));
    let material = materials.get(&fields)?;
    let things = if kind == "mesh" && material.is_none() {
        let name = fields.text("file")?;
        let path = fields.source().beside(fields.need("file", name)?);
        model::load(&path).map_err(|error| fields.wrong("file", error.to_string()))?
    } else {
        let shape = shape(&fields, kind)?;
        let material = fields.need("material", material)?;
        vec![Thing { shape, material }]
    };
    let placing = Placing::of(&fields)?;
    fields.finish()?;
    Ok((things, placing))
}

fn shape(fields: &Fields, kind: &str) -> Result<Arc<dyn Shape>, TextError> {
    let place = |key: &'static str| fields.need(key, fields.place(key)?);
    Ok(match kind {
        "sphere" => {
            let radius = fields.number("radius_m", 1e-9..=LARGEST)?;
            let sphere = Sphere::checked(place("center_m")?, fields.need("radius_m", radius)?);
            Arc::new(sphere.map_err(|error| fields.wrong("center_m", error.to_string()))?)
        }
        "plane" => {
            let normal = fields.direction("normal")?.unwrap_or(Dir3::Y);
            Arc::new(Plane::through(place("point_m")?, normal))
        }
        "box" => Arc::new(Cuboid::between(place("corner_m")?, place("opposite_m")?)),
        "rectangle" => {
            let (corner, a, b) = (place("corner_m")?, place("a_m")?, place("b_m")?);
            square(fields, a, b)?;
            meshed(rectangle(fields, corner, a, b)?)
        }
        "teapot" => meshed(look(fields, teapot::mesh(16))?),
        _ => {
            let name = fields.text("file")?;
            let path = fields.source().beside(fields.need("file", name)?);
            let mesh = mesh_file::load(&path);
            let mesh = mesh.map_err(|error| fields.wrong("file", error.to_string()))?;
            meshed(look(fields, mesh)?)
        }
    })
}

fn meshed(mesh: Mesh) -> Arc<dyn Shape> {
    Arc::new(Meshed::new(mesh, WideBvh::new))
}

/// Two triangles; texture coordinates go from 0 to 1 along both edges.
fn rectangle(fields: &Fields, corner: Vec3, a: Vec3, b: Vec3) -> Result<Mesh, TextError> {
    let corners = vec![corner, corner + a, corner + a + b, corner + b];
    let textures = vec![Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
    let mesh = Mesh::new(corners, vec![[0, 1, 2], [0, 2, 3]], None, Some(textures));
    let mesh = mesh.map_err(|error| fields.wrong("corner_m", error.to_string()))?;
    look(fields, mesh)
}

/// The mesh with flat or smooth facets, and with the bumps of a normal map.
fn look(fields: &Fields, mesh: Mesh) -> Result<Mesh, TextError> {
    let mesh = match fields.choice("facets", &["flat", "smooth", "as they are"])? {
        Some("flat") => mesh.flat(),
        Some("smooth") => mesh.smooth(),
        _ => mesh,
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
