//! Embree as a student: it answers the workbook's questions about hits, by lines.

use crate::embree::{Embree, Mode};
use glam::Vec3;
use raybook::math::{aabb::Aabb, basis::Basis, interval::Interval, ray::Ray};
use raybook::shape::{mesh::Mesh, sphere::Sphere};
use raybook_common::oracle::judge::Answer;
use raybook_common::oracle::meshes;
use raybook_common::oracle::target::Solid;
use raybook_workbook::exercise::Exercise;
use raybook_workbook::exercises::ch03_sphere::SphereHit;
use raybook_workbook::exercises::ch04_plane::PlaneHit;
use raybook_workbook::exercises::ch05_box::BoxClip;
use raybook_workbook::exercises::ch06_triangle::{TriangleHit, TriangleHitAnswer};
use raybook_workbook::exercises::ch07_mesh::{MeshHit, MeshHitAnswer};
use raybook_workbook::exercises::ch11_bvh::{BvhClosest, BvhClosestAnswer};
use raybook_workbook::exercises::ch24_wide_bvh::{WideClosest, WideClosestAnswer};
use raybook_workbook::row::{Row, RowError, read};

/// What Embree answers to a question's line; an error if it cannot be asked.
pub type Student = fn(&Embree, &str) -> Result<String, String>;

/// The exercises, and how Embree does them.
pub const STUDENTS: [(&str, Student); 7] = [
    ("sphere_hit", sphere_hit),
    ("plane_hit", plane_hit),
    ("box_clip", box_clip),
    ("triangle_hit", triangle_hit),
    ("mesh_hit", mesh_hit),
    ("bvh_closest", bvh_closest),
    ("wide_closest", wide_closest),
];

fn question<Q: Row>(line: &str) -> Result<Q, String> {
    read(line, "question").map_err(|error: RowError| error.to_string())
}

fn ask(
    embree: &Embree,
    solid: &Solid,
    ray: &Ray,
    within: Interval,
) -> Result<Option<Answer>, String> {
    // Embree's intervals begin at 0 or later: the ray then begins where the interval does.
    let before = within.min.clamp(f32::MIN, 0.0);
    let ray = Ray::new(ray.at(before), ray.direction);
    let within = Interval::new(within.min - before, within.max - before);
    // Robust: no ray slips through the edge between two triangles of a face.
    let hit = embree.scene(solid, Mode::Robust)?.closest(&ray, within);
    Ok(hit.map(|hit| Answer {
        t: before + hit.t,
        ..hit
    }))
}

/// Triangles, each with corners of its own.
fn triangles(corners: &[[Vec3; 3]]) -> Result<Solid, String> {
    let indices = (0..corners.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
    let mesh = Mesh::new(corners.concat(), indices.collect(), None, None);
    mesh.map(Solid::Triangles)
        .map_err(|error| error.to_string())
}

fn sphere_hit(embree: &Embree, line: &str) -> Result<String, String> {
    let SphereHit {
        ray,
        within,
        center,
        radius,
    } = question(line)?;
    let solid = Solid::Sphere(Sphere::new(center, radius));
    Ok(ask(embree, &solid, &ray, within)?.map(|hit| hit.t).write())
}

/// The plane is two triangles, a square around the ray's foot; it reaches farther than all but parallel rays.
fn plane_hit(embree: &Embree, line: &str) -> Result<String, String> {
    let PlaneHit {
        ray,
        within,
        normal,
        offset,
    } = question(line)?;
    let height = normal.dot(ray.origin) - offset;
    let reach = (height / normal.dot(*ray.direction)).abs();
    let half = (2.0 + 2.0 * reach).min(1e6); // where this is NaN, the ray is in the plane
    let Basis { x, y, z } = Basis::around(normal);
    let corner = |(i, j): (f32, f32)| ray.origin - height * *z + half * (i * *x + j * *y);
    let [a, b, c, d] = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(corner);
    let hit = ask(embree, &triangles(&[[a, b, c], [a, c, d]])?, &ray, within)?;
    Ok(hit.map(|hit| hit.t).write())
}

/// The box is twelve triangles, asked from both ends of a long stretch of the line: where it enters, and where it leaves.
fn box_clip(embree: &Embree, line: &str) -> Result<String, String> {
    const AWAY: f32 = 32.0;
    let BoxClip {
        ray,
        within,
        min,
        max,
    } = question(line)?;
    let solid =
        Solid::Triangles(meshes::around(Aabb { min, max }).map_err(|error| error.to_string())?);
    let first = |from: f32, direction| {
        let hit = ask(
            embree,
            &solid,
            &Ray::new(ray.at(from), direction),
            Interval::AHEAD,
        );
        hit.map(|hit| hit.map(|hit| hit.t - AWAY))
    };
    let ends = first(-AWAY, ray.direction)?.zip(first(AWAY, -ray.direction)?);
    let inside =
        ends.map(|(enter, leave)| Interval::new(enter.max(within.min), within.max.min(-leave)));
    Ok(inside.filter(|inside| inside.min <= inside.max).write())
}

fn triangle_hit(embree: &Embree, line: &str) -> Result<String, String> {
    let TriangleHit {
        ray,
        within,
        p0,
        p1,
        p2,
    } = question(line)?;
    let hit = ask(embree, &triangles(&[[p0, p1, p2]])?, &ray, within)?;
    Ok(hit
        .map(|hit| TriangleHitAnswer {
            t: hit.t,
            b1: hit.uv.x,
            b2: hit.uv.y,
        })
        .write())
}

fn mesh_hit(embree: &Embree, line: &str) -> Result<String, String> {
    let MeshHit {
        ray,
        within,
        triangles: list,
    } = question(line)?;
    let corners: Vec<_> = list.iter().map(|t| [t.p0, t.p1, t.p2]).collect();
    let hit = ask(embree, &triangles(&corners)?, &ray, within)?;
    Ok(hit
        .map(|hit| MeshHitAnswer {
            t: hit.t,
            id: hit.id,
        })
        .write())
}

/// Embree searches a tree of its own and does not count: it is given the counts of the reference.
fn bvh_closest(embree: &Embree, line: &str) -> Result<String, String> {
    let q: BvhClosest = question(line)?;
    let corners: Vec<_> = q.triangles.iter().map(|t| [t.p0, t.p1, t.p2]).collect();
    let hit = ask(embree, &triangles(&corners)?, &q.ray, q.within)?;
    let BvhClosestAnswer { boxes, tests, .. } = BvhClosest::answer(&q);
    let answer = BvhClosestAnswer {
        boxes,
        tests,
        hit: hit.map(|hit| MeshHitAnswer {
            t: hit.t,
            id: hit.id,
        }),
    };
    Ok(answer.write())
}

/// As for `bvh_closest`.
fn wide_closest(embree: &Embree, line: &str) -> Result<String, String> {
    let q: WideClosest = question(line)?;
    let corners: Vec<_> = q.triangles.iter().map(|t| [t.p0, t.p1, t.p2]).collect();
    let hit = ask(embree, &triangles(&corners)?, &q.ray, q.within)?;
    let WideClosestAnswer { nodes, tests, .. } = WideClosest::answer(&q);
    let answer = WideClosestAnswer {
        nodes,
        tests,
        hit: hit.map(|hit| MeshHitAnswer {
            t: hit.t,
            id: hit.id,
        }),
    };
    Ok(answer.write())
}
