//! Chapter 7: `interpolate_normal`, `interpolate_texture`, `vertex_normals`, `mesh_hit`.

use raybook::accel::{Accel, list::List};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::shape::{attributes, mesh::Facet};
use crate::exercise::{Asked, Exercise};
use crate::row::row;
use glam::{Vec2, Vec3};

/// This chapter's exercises, in order.
pub const EXERCISES: &[&dyn Asked] = &[
    &InterpolateNormal,
    &InterpolateTexture,
    &VertexNormals,
    &MeshHit,
];

/// See [`Exercise::TASK`].
pub struct InterpolateNormal;

row! {
    /// The normals at three corners, and a place in between.
    pub struct InterpolateNormalQuestion {
        /// At the first corner.
        pub n0: Dir3,
        /// At the second corner.
        pub n1: Dir3,
        /// At the third corner.
        pub n2: Dir3,
        /// (b1, b2).
        pub b: Vec2,
    }
}

impl Exercise for InterpolateNormal {
    type Question = InterpolateNormalQuestion;
    type Answer = Vec3;
    const NAME: &'static str = "interpolate_normal";
    const ANSWER: &'static str = "normal";
    const TASK: &'static str = "Return the unit normal inside a triangle, from the normals at its corners and the weights b1 and b2 of the second and third corner.";

    fn answer(q: &Self::Question) -> Self::Answer {
        *attributes::interpolate_normal([q.n0, q.n1, q.n2], q.b)
    }
}

/// See [`Exercise::TASK`].
pub struct InterpolateTexture;

row! {
    /// The texture coordinates at three corners, and a place in between.
    pub struct InterpolateTextureQuestion {
        /// At the first corner.
        pub t0: Vec2,
        /// At the second corner.
        pub t1: Vec2,
        /// At the third corner.
        pub t2: Vec2,
        /// (b1, b2).
        pub b: Vec2,
    }
}

impl Exercise for InterpolateTexture {
    type Question = InterpolateTextureQuestion;
    type Answer = Vec2;
    const NAME: &'static str = "interpolate_texture";
    const ANSWER: &'static str = "texture";
    const TASK: &'static str = "Return the texture coordinates inside a triangle, from those at its corners and the weights b1 and b2 of the second and third corner.";

    fn answer(q: &Self::Question) -> Self::Answer {
        attributes::interpolate_texture([q.t0, q.t1, q.t2], q.b)
    }
}

/// See [`Exercise::TASK`].
pub struct VertexNormals;

row! {
    /// A triangle by the indices of its vertices.
    pub struct Indices {
        /// The first.
        pub a: u32,
        /// The second.
        pub b: u32,
        /// The third.
        pub c: u32,
    }
}

row! {
    /// Vertices, and triangles of their indices.
    pub struct MeshQuestion {
        /// The vertices.
        pub positions: Vec<Vec3>,
        /// Three indices of vertices per triangle, counter-clockwise.
        pub triangles: Vec<Indices>,
    }
}

impl Exercise for VertexNormals {
    type Question = MeshQuestion;
    type Answer = Vec<Vec3>;
    const NAME: &'static str = "vertex_normals";
    const ANSWER: &'static str = "normal";
    const TASK: &'static str = "Return a unit normal per vertex: the average of the normals of its triangles, weighted by their areas; +y where that is zero.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let triangles: Vec<_> = q.triangles.iter().map(|t| [t.a, t.b, t.c]).collect();
        attributes::vertex_normals(&q.positions, &triangles)
            .into_iter()
            .map(|n| *n)
            .collect()
    }
}

/// See [`Exercise::TASK`].
pub struct MeshHit;

row! {
    /// A triangle by its corners.
    pub struct Corners {
        /// The first corner.
        pub p0: Vec3,
        /// The second corner.
        pub p1: Vec3,
        /// The third corner.
        pub p2: Vec3,
    }
}

row! {
    /// A ray, the distances that count, and triangles.
    pub struct MeshHitQuestion {
        /// The ray.
        pub ray: Ray,
        /// Only t with min < t < max counts.
        pub within: Interval,
        /// The triangles; their ids count from 0.
        pub triangles: Vec<Corners>,
    }
}

row! {
    /// The nearest triangle.
    pub struct MeshHitAnswer {
        /// The distance along the ray.
        pub t: f32,
        /// Which triangle.
        pub id: u32,
    }
}

impl Exercise for MeshHit {
    type Question = MeshHitQuestion;
    type Answer = Option<MeshHitAnswer>;
    const NAME: &'static str = "mesh_hit";
    const TASK: &'static str = "Return the nearest shape of the list that the ray hits with min < t < max, and that hit, or None.";

    fn answer(q: &Self::Question) -> Self::Answer {
        let facets = q.triangles.iter().zip(0..).map(|(t, id)| Facet {
            corners: [t.p0, t.p1, t.p2],
            id,
        });
        let list = List::new(facets.collect());
        let (_, hit) = list.closest(&q.ray, q.within)?;
        Some(MeshHitAnswer {
            t: hit.t,
            id: hit.id,
        })
    }
}
