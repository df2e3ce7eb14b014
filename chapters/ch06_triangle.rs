//! # Triangle
//!
//! A triangle is a plane with an inside. Three equations tell where a ray meets it: at which distance, and at which
//! barycentric coordinates. Three ways to solve them give the same hits, and the way of Möller and Trumbore is the cheapest.
//!
//! New: shape/triangle.rs shape/triangle_by_plane.rs shape/triangle_by_determinants.rs

use glam::{Vec2, Vec3, vec3};
use raybook::camera::{Camera, pinhole::Pinhole};
use raybook::image::{Image, rgb::Rgb};
use raybook::lab::palette::{BLUE, ORANGE, linear, viridis};
use raybook::lab::platonic::{icosahedron, octahedron, tetrahedron};
use raybook::lab::stage::{Drawn, Stage};
use raybook::lab::{barycentrics, chapter, sheet::sheet, triangle_race};
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};
use raybook::render::film::Film;
use raybook::shape::{Hit, Shape, Surface, plane::Plane, triangle::Triangle};
use std::error::Error;
use std::process::ExitCode;

/// Draws the chapter's pictures.
pub(crate) fn draw(stage: &Stage) -> Drawn {
    let picture = photograph(&stage.film(16.0 / 9.0), |b, _, _| b)?;
    let caption = "Barycentric coordinates as colours: b0 red, b1 green, b2 blue.";
    stage.picture("picture", caption, &picture)?;

    let whole = stage.film(16.0 / 9.0);
    let (width, height) = (whole.width / 2, whole.height / 2);
    let quarter = Film {
        width,
        height,
        ..whole
    };
    let far = |at: &Surface, ray: &Ray| viridis((8.5 - at.position.distance(ray.origin)) / 4.0);
    let facing = |at: &Surface, ray: &Ray| {
        linear(if at.normal.dot(*ray.direction) < 0.0 {
            BLUE
        } else {
            ORANGE
        })
    };
    let tiles = [
        (
            "distance t: near is yellow",
            photograph(&quarter, |_, at, ray| far(at, ray))?,
        ),
        (
            "lines of equal b₀, b₁, b₂",
            photograph(&quarter, |b, _, _| lines(b))?,
        ),
        (
            "geometric normals",
            photograph(&quarter, |_, at, _| signed(*at.normal))?,
        ),
        (
            "front side blue, back side orange",
            photograph(&quarter, |_, at, ray| facing(at, ray))?,
        ),
    ];
    let caption = "What a ray learns from the triangle it hits: how far it is, where on it, how it lies, and from which side.";
    stage.figure("sheet", caption, &sheet(2, &tiles)?)?;
    let caption = "b1 grows from the side p0p2 towards p1, b2 from the side p0p1 towards p2; inside, neither is negative and b1 + b2 is at most 1.";
    stage.figure("barycentrics", caption, &barycentrics::figure()?)?;
    let caption =
        "Three ways to the same hits, timed on the same rays in the run that drew this figure.";
    stage.figure("cost", caption, &triangle_race::figure()?)
}

/// A picture of three regular solids; `colour` is told the barycentric coordinates, the surface, and the ray.
fn photograph(
    film: &Film,
    colour: impl Fn(Rgb, &Surface, &Ray) -> Rgb + Sync,
) -> Result<Image, Box<dyn Error>> {
    let (from, to) = (vec3(0.0, 2.7, 6.0), vec3(0.0, 0.86, 0.0));
    let camera = Pinhole::look_at(from, to, Vec3::Y, 0.043, film.aspect())?;
    let mut solids = icosahedron(1.05, vec3(0.0, 1.02, 0.0), 0.32);
    // Without the face that looks at the camera, one sees the others' back sides.
    solids.retain(|face| {
        face.normal()
            .is_some_and(|n| n.dot(vec3(0.0, 0.5, 0.86)) < 0.9)
    });
    solids.extend(tetrahedron(1.0, vec3(-2.1, 0.36, 0.2), 1.0));
    solids.extend(octahedron(0.85, vec3(2.1, 0.9, 0.2), 0.35));
    let floor = Plane::through(Vec3::ZERO, Dir3::Y);
    let sun = Dir3::new_or(vec3(-0.5, 1.4, 0.7), Dir3::Y);
    Ok(film.render(|place, _| {
        let ray = camera.ray(place, Vec2::ZERO);
        if let Some((triangle, hit)) = nearest(&solids, &ray) {
            let at = triangle.surface(&ray, &hit);
            let b = Rgb::new(1.0 - hit.uv.x - hit.uv.y, hit.uv.x, hit.uv.y);
            return colour(b, &at, &ray) * (0.7 + 0.3 * at.normal.dot(*sun).abs());
        }
        let background = Rgb::new(0.5, 0.62, 0.78).lerp(Rgb::new(0.82, 0.86, 0.9), place.y);
        let Some(hit) = floor.hit(&ray, Interval::AHEAD) else {
            return background;
        };
        let toward_sun = floor.surface(&ray, &hit).leave(sun);
        let lit = nearest(&solids, &toward_sun).is_none();
        background * if lit { 1.0 } else { 0.7 }
    }))
}

/// The nearest triangle that the ray hits: each is asked, and a hit shortens what is left of the ray.
fn nearest<'a>(triangles: &'a [Triangle], ray: &Ray) -> Option<(&'a Triangle, Hit)> {
    let mut within = Interval::AHEAD;
    let mut found = None;
    for triangle in triangles {
        if let Some(hit) = triangle.hit(ray, within) {
            within = within.before(hit.t);
            found = Some((triangle, hit));
        }
    }
    found
}

fn signed(n: Vec3) -> Rgb {
    Rgb::new(n.x, n.y, n.z).map(|v| 0.5 + 0.5 * v)
}
/// Dark where a coordinate is a multiple of a quarter.
fn lines(b: Rgb) -> Rgb {
    let on_a_line = b
        .channels()
        .iter()
        .any(|v| (4.0 * v - (4.0 * v).round()).abs() < 0.06);
    if on_a_line {
        Rgb::gray(0.03)
    } else {
        Rgb::WHITE.lerp(b, 0.6)
    }
}

fn main() -> ExitCode {
    chapter::run("ch06_triangle", draw)
}
