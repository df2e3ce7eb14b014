//! What questions are made of.

use glam::{Vec2, Vec3, vec3};
use rand::RngExt;
use raybook::math::{dir3::Dir3, interval::Interval, pcg::Pcg, ray::Ray};
use raybook_workbook::exercises::ch07_mesh::Corners;
use raybook_workbook::tree_rows::BoxRow;

/// All of a line, ahead and behind.
pub const LINE: Interval = Interval::new(f32::NEG_INFINITY, f32::INFINITY);

/// What moves a scene by a metre along each axis.
pub const METRE: Vec3 = Vec3::ONE;

/// A ray in a scene that is moved by a metre along each axis.
pub fn moved(ray: &Ray) -> Ray {
    Ray::new(ray.origin + METRE, ray.direction)
}

/// A triangle in such a scene.
pub fn moved_triangle(Corners { p0, p1, p2 }: &Corners) -> Corners {
    let [p0, p1, p2] = [p0, p1, p2].map(|p| *p + METRE);
    Corners { p0, p1, p2 }
}

/// A box in such a scene.
pub fn moved_box(BoxRow { min, max }: &BoxRow) -> BoxRow {
    let [min, max] = [min, max].map(|corner| *corner + METRE);
    BoxRow { min, max }
}

/// The ray from a point in the direction of a vector of any length but 0.
pub fn ray(origin: Vec3, toward: Vec3) -> Ray {
    Ray::new(origin, Dir3::new_or(toward, Dir3::Z))
}

/// Where pixel (x, y) of a picture of 96 × 54 lies, seen along −z from 1 m away; the picture is 1 m high.
pub fn pixel(x: u32, y: u32) -> Vec3 {
    vec3((x as f32 - 47.5) / 54.0, (26.5 - y as f32) / 54.0, -1.0)
}

/// A number between two others.
pub fn number(rng: &mut Pcg, min: f32, max: f32) -> f32 {
    rng.random_range(min..max)
}

/// Where an interval ends: between two numbers, or nowhere.
pub fn end(rng: &mut Pcg, chance: f64, min: f32, max: f32) -> f32 {
    if rng.random_bool(chance) {
        number(rng, min, max)
    } else {
        f32::INFINITY
    }
}

/// How much of its size a ray passes beside a rim, an edge, or a tangent, above 0 inside and below 0 outside: where a tolerance of a thousandth tells.
pub fn beside(rng: &mut Pcg) -> f32 {
    let gap = number(rng, 2e-4, 2e-3);
    if rng.random_bool(0.5) { gap } else { -gap }
}

/// A point of the cube [−half, half]³.
pub fn point(rng: &mut Pcg, half: f32) -> Vec3 {
    vec3(
        number(rng, -half, half),
        number(rng, -half, half),
        number(rng, -half, half),
    )
}

/// A direction, all equally likely: a point of the cube, thrown again until it is inside the sphere.
pub fn direction(rng: &mut Pcg) -> Dir3 {
    loop {
        let p = point(rng, 1.0);
        if p.length_squared() <= 1.0
            && let Some(direction) = Dir3::new(p)
        {
            return direction;
        }
    }
}

/// Whether a box has a volume.
pub fn is_box(min: Vec3, max: Vec3) -> bool {
    min.cmplt(max).all()
}

/// Whether a box is a cube, but for rounding.
pub fn is_cube(min: Vec3, max: Vec3) -> bool {
    let extents = max - min;
    is_box(min, max) && extents.max_element() < 1.0001 * extents.min_element()
}

/// Whether three points are the corners of a triangle with an area that is no splinter.
pub fn is_triangle([p0, p1, p2]: [Vec3; 3]) -> bool {
    let (a, b) = (p1 - p0, p2 - p0);
    a.cross(b).length() > 0.1 * a.length() * b.length()
}

/// Whether directions are perpendicular to each other.
pub fn are_axes(axes: [Dir3; 3]) -> bool {
    let [a, b, c] = axes.map(|axis| *axis);
    [a.dot(b), b.dot(c), c.dot(a)]
        .iter()
        .all(|cosine| cosine.abs() < 1e-4)
}

/// Whether these are the weights of the second and the third corner of a triangle, for a point in it.
pub fn are_weights(b: Vec2) -> bool {
    b.min_element() >= 0.0 && b.x + b.y <= 1.0
}
