//! Chapter 7: `interpolate_normal`, `interpolate_texture`, `vertex_normals`, `mesh_hit`.

use crate::exercise::exercises;
use crate::record::row;
use glam::{Vec2, Vec3};
use raybook::accel::{Accel, list::List};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::{attributes, mesh::Facet};

exercises! { ($) ch07_mesh
    /// Return the unit normal inside a triangle: the sum of the normals at its corners, with the weights 1 − b1 − b2, b1
    /// and b2, brought to length 1.
    InterpolateNormal: interpolate_normal(
        /// The normal at the first corner.
        n0: Dir3,
        /// The normal at the second corner.
        n1: Dir3,
        /// The normal at the third corner.
        n2: Dir3,
        /// The weights (b1, b2) of the second and third corner,
        b: Vec2 [from 0 to 1],
    ) -> (
        /// The normal in between, of length 1.
        normal: Vec3,
    ) {
        *attributes::interpolate_normal([n0, n1, n2], b)
    }

    /// Return the texture coordinates inside a triangle, from those at its corners and the weights b1 and b2 of the
    /// second and third corner.
    InterpolateTexture: interpolate_texture(
        /// The texture coordinates at the first corner, without a unit.
        t0: Vec2,
        /// The texture coordinates at the second corner, without a unit.
        t1: Vec2,
        /// The texture coordinates at the third corner, without a unit.
        t2: Vec2,
        /// The weights (b1, b2) of the second and third corner,
        b: Vec2 [from 0 to 1],
    ) -> (
        /// The texture coordinates in between, without a unit.
        texture: Vec2,
    ) {
        attributes::interpolate_texture([t0, t1, t2], b)
    }

    /// Return a unit normal per vertex: the average of the normals of its triangles, weighted by their areas; +y where
    /// that average is zero.
    VertexNormals: vertex_normals(
        /// The vertices, in metres.
        positions: Vec<Vec3>,
        /// The triangles, counter-clockwise seen from outside.
        triangles: Vec<Indices>,
    ) -> (
        /// The normals of length 1, one per vertex, in their order.
        normal: Vec<Vec3>,
    ) {
        let triangles: Vec<_> = triangles.iter().map(|t| [t.a, t.b, t.c]).collect();
        attributes::vertex_normals(&positions, &triangles)
            .into_iter()
            .map(|n| *n)
            .collect()
    }

    /// Return the nearest triangle of the list that the ray hits with min < t < max: its distance and its number. There
    /// is no answer if the ray hits none. Of two triangles at the same distance, either is right.
    ///
    /// In Rust: the shape and its `Hit`; `count.tested_shape()` before each test, so that the work can be compared.
    MeshHit: mesh_hit(
        /// The ray.
        ray: Ray,
        /// The distances that count: min < t < max, in metres.
        within: Interval,
        /// The triangles; their ids count from 0.
        triangles: Vec<Corners>,
    ) -> (
        /// The nearest hit; none for a miss.
        answer: Option<MeshHitAnswer>,
    ) {
        let facets = triangles.iter().zip(0..).map(|(t, id)| Facet {
            corners: [t.p0, t.p1, t.p2],
            id,
        });
        let list = List::new(facets.collect());
        let (_, hit) = list.closest(&ray, within)?;
        Some(MeshHitAnswer {
            t: hit.t,
            id: hit.id,
        })
    }
}

row! {
    /// A triangle by the indices of its vertices.
    pub struct Indices {
        /// The number of the first vertex, from 0.
        pub a: u32,
        /// The number of the second vertex, from 0.
        pub b: u32,
        /// The number of the third vertex, from 0.
        pub c: u32,
    }
}

row! {
    /// A triangle by its corners.
    pub struct Corners {
        /// The first corner, in metres.
        pub p0: Vec3,
        /// The second corner, in metres.
        pub p1: Vec3,
        /// The third corner, in metres.
        pub p2: Vec3,
    }
}

row! {
    /// The nearest triangle.
    pub struct MeshHitAnswer {
        /// The distance along the ray, in metres.
        pub t: f32,
        /// The triangle's number, from 0.
        pub id: u32,
    }
}
