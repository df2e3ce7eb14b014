//! Shapes, and where they are placed.

use crate::fields::Fields;
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
use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::Arc;

/// The things of all tables, and remarks about what their files describe and the things do not have.
pub(crate) fn things(
    all: Vec<Fields>,
    materials: &Materials,
) -> Result<(Vec<Thing>, Vec<String>), TextError> {
    let (mut things, mut loaded) = (Vec::new(), Loaded::default());
    for fields in all {
        let (made, placing) = made(fields, materials, &mut loaded)?;
        let place = |thing: Thing| Thing {
            shape: placing.place(thing.shape),
            ..thing
        };
        things.extend(made.into_iter().map(place));
    }
    Ok((things, loaded.remarks))
}

/// What has been loaded for a shape, and is shared by all further shapes that need the same.
#[derive(Default)]
struct Loaded {
    meshes: HashMap<(Source, Look), Arc<dyn Shape>>,
    models: HashMap<PathBuf, Vec<Thing>>,
    normals: HashMap<String, Arc<NormalMap>>,
    remarks: Vec<String>,
}

/// Where a mesh comes from, if several shapes may share it.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Source {
    Teapot,
    File(PathBuf),
}

/// The look of a mesh: flat or smooth facets, and the name of a normal map.
#[derive(Clone, Default, PartialEq, Eq, Hash)]
struct Look {
    facets: Facets,
    normal_map: Option<String>,
}

#[derive(Clone, Copy, Default, PartialEq, Eq, Hash)]
enum Facets {
    Flat,
    Smooth,
    #[default]
    AsTheyAre,
}

/// Makes a shape of a table of its kind.
type Make = fn(&Fields, &mut Loaded) -> Result<Arc<dyn Shape>, TextError>;

/// The kinds by their words, of which a mesh may bring materials of its own.
const KINDS: [(&str, Make); 7] = [
    ("sphere", sphere),
    ("plane", plane),
    ("box", cuboid),
    ("rectangle", rectangle),
    ("polygon", polygon),
    ("teapot", teapot),
    ("mesh", mesh),
];

/// The things of a table, before they are placed.
fn made(
    mut fields: Fields,
    materials: &Materials,
    loaded: &mut Loaded,
) -> Result<(Vec<Thing>, Placing), TextError> {
    let shape = fields.kind("a shape", &KINDS)?;
    let material = materials.get(&fields)?;
    let things = if fields.text("kind")? == Some("mesh") && material.is_none() {
        loaded.model(&fields)?
    } else {
        let shape = shape(&fields, loaded)?;
        let material = fields.need("material", |_, _| Ok(material.clone()))?;
        vec![Thing { shape, material }]
    };
    let placing = Placing::of(&fields)?;
    fields.finish()?;
    Ok((things, placing))
}

fn sphere(fields: &Fields, _: &mut Loaded) -> Result<Arc<dyn Shape>, TextError> {
    let center = fields.need("center_m", Fields::place)?;
    let sphere = Sphere::checked(center, fields.need("radius_m", Fields::length)?);
    Ok(Arc::new(sphere.map_err(|error| {
        fields.wrong("center_m", error.to_string())
    })?))
}

fn plane(fields: &Fields, _: &mut Loaded) -> Result<Arc<dyn Shape>, TextError> {
    let normal = fields.direction("normal")?.unwrap_or(Dir3::Y);
    let point = fields.need("point_m", Fields::place)?;
    Ok(Arc::new(Plane::through(point, normal)))
}

fn cuboid(fields: &Fields, _: &mut Loaded) -> Result<Arc<dyn Shape>, TextError> {
    let corner = fields.need("corner_m", Fields::place)?;
    let opposite = fields.need("opposite_m", Fields::place)?;
    Ok(Arc::new(Cuboid::between(corner, opposite)))
}

/// Two triangles; texture coordinates go from 0 to 1 along both edges.
fn rectangle(fields: &Fields, loaded: &mut Loaded) -> Result<Arc<dyn Shape>, TextError> {
    let [corner, a, b] = corner_and_edges(fields)?;
    let corners = vec![corner, corner + a, corner + a + b, corner + b];
    let textures = vec![Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
    let mesh = Mesh::new(corners, vec![[0, 1, 2], [0, 2, 3]], None, Some(textures));
    let mesh = mesh.map_err(|error| fields.wrong("corner_m", error.to_string()))?;
    let look = Look::of(fields)?;
    loaded.meshed(fields, mesh, &look)
}

/// Triangles from the first corner to the edges that do not touch it.
fn polygon(fields: &Fields, loaded: &mut Loaded) -> Result<Arc<dyn Shape>, TextError> {
    let corners = fields.need("corners_m", Fields::places)?;
    let count = corners.len() as u32;
    if count < 3 {
        return Err(fields.wrong("corners_m", "a polygon has at least three corners"));
    }
    let fan = (1..count - 1).map(|i| [0, i, i + 1]).collect();
    let mesh = Mesh::new(corners, fan, None, None);
    let mesh = mesh.map_err(|error| fields.wrong("corners_m", error.to_string()))?;
    let look = Look::of(fields)?;
    loaded.meshed(fields, mesh, &look)
}

fn teapot(fields: &Fields, loaded: &mut Loaded) -> Result<Arc<dyn Shape>, TextError> {
    loaded.mesh(fields, Source::Teapot, |_| Ok(teapot::mesh(16)))
}

fn mesh(fields: &Fields, loaded: &mut Loaded) -> Result<Arc<dyn Shape>, TextError> {
    let path = file(fields)?;
    loaded.mesh(fields, Source::File(path.clone()), |fields| {
        mesh_file::load(&path).map_err(|error| fields.wrong("file", error.to_string()))
    })
}

/// The path of the mesh that the field `file` names.
fn file(fields: &Fields) -> Result<PathBuf, TextError> {
    let name = fields.need("file", Fields::text)?;
    Ok(fields.source().beside(name))
}

impl Look {
    fn of(fields: &Fields) -> Result<Self, TextError> {
        let facets = fields.choice("facets", &FACETS)?.unwrap_or_default();
        let normal_map = fields.text("normal_map")?;
        Ok(Self {
            facets,
            normal_map: normal_map.map(str::to_owned),
        })
    }
}

/// The same by its words.
const FACETS: [(&str, Facets); 3] = [
    ("flat", Facets::Flat),
    ("smooth", Facets::Smooth),
    ("as they are", Facets::AsTheyAre),
];

impl Loaded {
    /// The things of an OBJ file with its own materials.
    fn model(&mut self, fields: &Fields) -> Result<Vec<Thing>, TextError> {
        let path = file(fields)?;
        if let Some(things) = self.models.get(&path) {
            return Ok(things.clone());
        }
        let model = model::load(&path).map_err(|error| fields.wrong("file", error.to_string()))?;
        self.remarks.extend(model.remarks);
        Ok(self.models.entry(path).or_insert(model.things).clone())
    }

    /// The mesh with the look that the table gives it; `load` is called for the first of equal meshes.
    fn mesh(
        &mut self,
        fields: &Fields,
        source: Source,
        load: impl Fn(&Fields) -> Result<Mesh, TextError>,
    ) -> Result<Arc<dyn Shape>, TextError> {
        let key = (source, Look::of(fields)?);
        if let Some(shape) = self.meshes.get(&key) {
            return Ok(shape.clone());
        }
        let shape = self.meshed(fields, load(fields)?, &key.1)?;
        Ok(self.meshes.entry(key).or_insert(shape).clone())
    }

    /// The mesh in a tree, with a look.
    fn meshed(
        &mut self,
        fields: &Fields,
        mesh: Mesh,
        look: &Look,
    ) -> Result<Arc<dyn Shape>, TextError> {
        let mesh = match look.facets {
            Facets::Flat => mesh.flat(),
            Facets::Smooth => mesh.smooth(),
            Facets::AsTheyAre => mesh,
        };
        let mesh = match &look.normal_map {
            Some(name) => mesh.with_bumps(self.normals(fields, name)?),
            None => mesh,
        };
        Ok(Arc::new(Meshed::new(mesh, WideBvh::new)))
    }

    /// The normal map of this name.
    fn normals(&mut self, fields: &Fields, name: &str) -> Result<Arc<NormalMap>, TextError> {
        if let Some(map) = self.normals.get(name) {
            return Ok(map.clone());
        }
        let picture = fields.picture("normal_map", name)?;
        let map = NormalMap::new(&picture.map(|pixel| pixel.map(tone::encode_srgb)));
        Ok(self
            .normals
            .entry(name.into())
            .or_insert(Arc::new(map))
            .clone())
    }
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
