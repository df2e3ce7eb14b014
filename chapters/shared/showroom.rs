//! A place to look at a mesh before there is light: a camera that frames it, a ground, a backdrop, and clay.

use glam::{Vec2, Vec3, vec2, vec3};
use raybook::camera::Camera;
use raybook::camera::pinhole::Pinhole;
use raybook::image::{rgb::Rgb, tone};
use raybook::math::{aabb::Aabb, dir3::Dir3, interval::Interval, ray::Ray};
use raybook::render::film::{Film, SILENT};
use raybook::shape::{Hit, Shape, Surface, mesh::Mesh, plane::Plane};

/// How much of the picture's height or width a mesh fills, whichever is scarcer.
const FILL: f32 = 0.83;

/// A mesh's surroundings.
#[derive(Debug)]
pub struct Showroom {
    camera: Pinhole,
    bounds: Aabb,
}

impl Showroom {
    /// A room in which the camera looks at a mesh from above its front (+z), far enough away to see all of it.
    pub fn around(mesh: &Mesh, aspect: f32) -> Self {
        Self::before(mesh, mesh.positions().iter().copied(), FILL, aspect)
    }

    /// The same room from farther away: all of a box around the mesh is seen.
    pub fn around_box(mesh: &Mesh, shown: &Aabb, aspect: f32) -> Self {
        let corner = |i: u8| [1, 2, 4].map(|bit| f32::from(u8::from(i & bit > 0)));
        let corners = (0..8).map(|i| shown.min + shown.size() * Vec3::from_array(corner(i)));
        Self::before(mesh, corners, 0.95, aspect)
    }

    fn before(mesh: &Mesh, shown: impl Iterator<Item = Vec3>, fill: f32, aspect: f32) -> Self {
        let bounds = mesh.bounds();
        let from = vec3(0.35, 0.55, 1.3);
        let camera = Pinhole::look_at(from, Vec3::ZERO, Vec3::Y, 0.06, aspect)
            .unwrap_or_else(|error| unreachable!("the direction is fixed: {error}"));
        // A point at x across and z ahead of the centre is seen from the distance r if |x|/(r + z) is within the slope.
        let slope = fill * 0.5 * camera.plane / camera.focal_length;
        let distances = shown.map(|p| {
            let q = p - bounds.center();
            let across = vec2(q.dot(*camera.right), q.dot(*camera.up)).abs() / slope;
            across.max_element() - q.dot(*camera.forward)
        });
        let distance = distances.fold(0.0, f32::max);
        let focal_point = bounds.center() - distance * *camera.forward;
        Self {
            camera: Pinhole {
                focal_point,
                ..camera
            },
            bounds,
        }
    }

    /// The camera's ray through a place on the film.
    pub fn ray(&self, film: Vec2) -> Ray {
        self.camera.central_ray(film)
    }

    /// What a ray that misses the mesh sees: the ground, darker around the mesh, and the sky at its end.
    pub fn backdrop(&self, film: Vec2, ray: &Ray) -> Rgb {
        let sky =
            Rgb::new(0.60, 0.71, 0.80).lerp(Rgb::new(0.93, 0.92, 0.89), film.y.min(0.8) / 0.8);
        let ground = Plane::through(self.bounds.min, Dir3::Y);
        let Some(hit) = ground.hit(ray, Interval::AHEAD) else {
            return sky;
        };
        // Not a true shadow, but the mesh looks as if it stood on the ground; the dark side is away from the light of `clay`.
        let from_center = 2.0 * (ray.at(hit.t) - self.bounds.center()) / self.bounds.size();
        let squared = (from_center - vec3(0.15, 0.0, -0.2))
            .with_y(0.0)
            .length_squared();
        let (near, far) = ((-1.2 * squared).exp(), 1.0 - (-0.05 * squared).exp());
        Rgb::new(0.80, 0.76, 0.70).lerp(sky, far) * (1.0 - 0.6 * near)
    }
}

/// A film with two fifths of the width and height, for one of several pictures on a sheet.
pub fn small<'a>(film: &Film<'a>) -> Film<'a> {
    Film {
        width: film.width * 2 / 5,
        height: film.height * 2 / 5,
        progress: SILENT,
        ..*film
    }
}

/// The colour of a point of a mesh, from the ray that hit it, the hit and the surface.
pub type Look = fn(&Ray, &Hit, &Surface) -> Rgb;

/// With the interpolated normals of the vertices.
pub const SMOOTH: Look = |ray, _, at| clay(at, at.shading_normal, ray);

/// With the triangles' own normals, and with their edges.
pub const FLAT: Look = |ray, hit, at| {
    let to_edge = hit.uv.min_element().min(1.0 - hit.uv.element_sum());
    clay(at, at.normal, ray) * if to_edge < 0.03 { 0.3 } else { 1.0 }
};

/// The interpolated normal: x as red, y as green, z as blue, each from −1 to 1.
pub const NORMALS: Look = |_, _, at| {
    let n = *at.shading_normal;
    Rgb::new(n.x, n.y, n.z).map(|v| tone::decode_srgb(0.5 + 0.5 * v))
};

/// A checkerboard on the texture coordinates, six squares to the unit.
pub const TEXTURE: Look = |ray, _, at| {
    let square = (6.0 * at.texture).floor().element_sum();
    clay(at, at.shading_normal, ray) * if square % 2.0 == 0.0 { 1.0 } else { 0.4 }
};

/// Coloured clay: the lighter, the more the normal points to the upper left of the front.
///
/// The normal is turned to the side of the surface that is seen; shading proper begins in chapter 12.
fn clay(at: &Surface, normal: Dir3, ray: &Ray) -> Rgb {
    let side = -at.normal.dot(*ray.direction).signum();
    let light = Dir3::new_or(vec3(-0.6, 0.9, 0.7), Dir3::Y);
    let toward = 0.5 + 0.5 * side * normal.dot(*light);
    Rgb::new(0.01, 0.04, 0.10).lerp(Rgb::new(0.20, 0.68, 0.70), toward * toward)
}
