//! The pin-hole camera as a drawing: one camera of the library looks at another.

use crate::kit::figure::{Figure, figure};
use crate::kit::palette::{BLUE, GREEN, INK, ORANGE, SKY, VERMILION};
use crate::kit::{sketch::Sketch, stage::Drawn};
use glam::{Vec2, Vec3, vec2, vec3};
use plotters::prelude::{RGBColor, WHITE};
use raybook::camera::Camera;
use raybook::camera::pinhole::Pinhole;
use raybook::math::ray::Ray;

/// Columns and rows of the small picture that the drawn camera takes.
const PIXELS: [usize; 2] = [7, 5];

/// The pixels whose rays are drawn: column and row.
const RAYS: [(usize, usize); 4] = [(3, 0), (3, 1), (4, 2), (6, 4)];

/// The front of the house, from the ground at the left, clockwise.
const FRONT: [Vec3; 5] = [
    vec3(-1.6, 0.0, -8.0),
    vec3(-1.6, 2.5, -8.0),
    vec3(0.0, 4.0, -8.0),
    vec3(1.6, 2.5, -8.0),
    vec3(1.6, 0.0, -8.0),
];

/// Draws a pin-hole camera before a house: its focal point, its image plane with the pixels, and some of their rays.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let (o, focal_length) = (vec3(0.0, 2.0, 0.0), 3.0);
    let camera = Pinhole {
        plane: vec2(3.36, 2.4),
        ..Pinhole::look_at(o, o - Vec3::Z, Vec3::Y, focal_length, 1.4)?
    };
    let (eye, middle) = (vec3(8.6, 5.0, 4.2), vec3(0.15, 1.2, -3.95));
    let viewer = Pinhole::look_at(eye, middle, Vec3::Y, 0.035, 16.0 / 9.0)?;
    figure(960, 540, |canvas| {
        let sketch = Sketch { canvas, viewer };
        world(&sketch)?;
        beyond_the_plane(&sketch, &camera)?;
        image_plane(&sketch, &camera)?;
        before_the_plane(&sketch, &camera)
    })
}

/// The film place of a pixel's centre.
fn pixel_centre((column, row): (usize, usize)) -> Vec2 {
    vec2(column as f32 + 0.5, row as f32 + 0.5) / vec2(PIXELS[0] as f32, PIXELS[1] as f32)
}

/// The point of the image plane at a film place: where its ray has gone the focal length forward.
fn on_plane(camera: &Pinhole, film: Vec2) -> Vec3 {
    let ray = camera.central_ray(film);
    ray.at(camera.focal_length / ray.direction.dot(*camera.forward))
}

/// Where a ray ends in the drawn world, and the colour it finds there.
fn meets(ray: &Ray) -> (Vec3, RGBColor) {
    let wall = ray.at((FRONT[0].z - ray.origin.z) / ray.direction.z);
    let under_roof = FRONT[2].y - wall.x.abs() * (FRONT[2].y - FRONT[3].y) / FRONT[3].x;
    if wall.x.abs() < FRONT[3].x && (0.0..under_roof).contains(&wall.y) {
        let gable = wall.y > FRONT[3].y;
        (wall, if gable { BLUE } else { ORANGE })
    } else if ray.direction.y < 0.0 {
        (ray.at(-ray.origin.y / ray.direction.y), GREEN)
    } else {
        (ray.at(7.4), SKY)
    }
}

/// Ground and house.
fn world(sketch: &Sketch) -> Drawn {
    let ground = |x, z| vec3(x, 0.0, z);
    let meadow = [
        ground(-2.9, 0.1),
        ground(3.2, 0.1),
        ground(3.2, -10.4),
        ground(-2.9, -10.4),
    ];
    sketch.area(&meadow, GREEN, 0.2)?;
    let back = FRONT.map(|p| p - 2.0 * Vec3::Z);
    let side = [FRONT[3], FRONT[4], back[4], back[3]];
    let slope = [FRONT[2], FRONT[3], back[3], back[2]];
    sketch.area(&FRONT, ORANGE, 1.0)?;
    sketch.area(&FRONT[1..4], BLUE, 1.0)?;
    sketch.area(&side, RGBColor(186, 128, 0), 1.0)?;
    sketch.area(&slope, RGBColor(0, 84, 132), 1.0)
}

/// The rays on their way from the image plane to what they meet, and the focal length on the ground below them.
fn beyond_the_plane(sketch: &Sketch, camera: &Pinhole) -> Drawn {
    let (o, ahead) = (camera.focal_point, camera.focal_length * *camera.forward);
    let foot = o.with_y(0.0);
    sketch.dashes(o, foot, INK, 2)?;
    sketch.dashes(o + ahead, foot + ahead, INK, 2)?;
    sketch.arrow(foot + 0.5 * ahead, foot, INK, 3)?;
    sketch.arrow(foot + 0.5 * ahead, foot + ahead, INK, 3)?;
    sketch.label(foot + 0.5 * ahead, vec2(96.0, 34.0), "focal length f", INK)?;
    for pixel in RAYS {
        let ray = camera.central_ray(pixel_centre(pixel));
        let (end, colour) = meets(&ray);
        if colour == SKY {
            sketch.arrow(on_plane(camera, pixel_centre(pixel)), end, VERMILION, 4)?;
            sketch.label(end, vec2(-40.0, -34.0), "ray o + t·d", VERMILION)?;
        } else {
            sketch.line(&[ray.origin, end], VERMILION, 4)?;
            sketch.dot(end, 9, VERMILION)?;
        }
    }
    Ok(())
}

/// The grid of pixels, each in the colour that its ray finds, with a dot at its centre.
fn image_plane(sketch: &Sketch, camera: &Pinhole) -> Drawn {
    let half = 0.5 / vec2(PIXELS[0] as f32, PIXELS[1] as f32);
    for pixel in (0..PIXELS[1]).flat_map(|row| (0..PIXELS[0]).map(move |column| (column, row))) {
        let centre = pixel_centre(pixel);
        let [a, b, c, d] = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(x, y)| on_plane(camera, centre + half * vec2(x, y)));
        let (_, colour) = meets(&camera.central_ray(centre));
        sketch.area(&[a, b, c, d], colour, 0.75)?;
        sketch.line(&[a, b, c, d, a], WHITE, 3)?;
        sketch.dot(on_plane(camera, centre), 4, INK)?;
    }
    let nearest = on_plane(camera, pixel_centre(RAYS[3]));
    sketch.label(nearest, vec2(84.0, 70.0), "pixel centre", INK)?;
    let top_left = on_plane(camera, Vec2::ZERO);
    sketch.label(top_left, vec2(-20.0, -40.0), "image plane", INK)
}

/// The focal point, the axes, and the rays on their way to the image plane.
fn before_the_plane(sketch: &Sketch, camera: &Pinhole) -> Drawn {
    let o = camera.focal_point;
    for pixel in RAYS {
        let centre = on_plane(camera, pixel_centre(pixel));
        sketch.line(&[o, centre], VERMILION, 4)?;
        sketch.dot(centre, 7, VERMILION)?;
    }
    for (axis, name, place) in [
        (camera.right, "right", vec2(20.0, 32.0)),
        (camera.up, "up", vec2(0.0, -26.0)),
        (camera.forward, "forward", vec2(58.0, 32.0)),
    ] {
        sketch.arrow(o, o + 0.9 * *axis, INK, 5)?;
        sketch.label(o + 0.9 * *axis, place, name, INK)?;
    }
    sketch.dot(o, 12, INK)?;
    sketch.label(o, vec2(-150.0, 0.0), "focal point o", INK)
}
