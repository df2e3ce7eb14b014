//! A dark room with a bright window: radiances over more than six orders of magnitude.
//!
//! The window is in the wall z = 0, and the room is where z > 0. The light that the room receives is estimated
//! in one step: from each pane, from the sun, and from the floor that the sun lights.

use super::evening;
use glam::{Vec2, Vec3, vec2, vec3};
use raybook::image::rgb::Rgb;
use raybook::math::{dir3::Dir3, ray::Ray};
use raybook::scene::noise::{hash, layers, rise};
use std::f32::consts::PI;

/// The corners of the room, in metres; the wall behind the viewer is never seen.
const ROOM: [Vec3; 2] = [vec3(-2.6, 0.0, 0.0), vec3(2.6, 2.9, 9.0)];
/// The lower left and the upper right corner of the window, in metres.
const OPENING: [Vec2; 2] = [vec2(-1.65, 0.06), vec2(1.65, 2.45)];
/// Thickness of the wall, in metres; the bars stand in the middle of the wall.
const THICKNESS: f32 = 0.36;
/// The edges of the panes, in metres: left and right, bottom and top.
const COLUMNS: [[f32; 2]; 3] = [[-1.60, -0.585], [-0.515, 0.515], [0.585, 1.60]];
const ROWS: [[f32; 2]; 3] = [[0.12, 0.80], [0.87, 1.60], [1.67, 2.40]];

/// The fraction of the light that each surface reflects.
const BARS: Rgb = Rgb::new(0.62, 0.60, 0.55);
const PLASTER: Rgb = Rgb::new(0.72, 0.70, 0.66);
const PAPER: Rgb = Rgb::new(0.20, 0.31, 0.30);
const WOOD: Rgb = Rgb::new(0.42, 0.24, 0.12);

/// The mean radiance of the panes, and the radiance of the floor where the sun lights it.
const SKY: Rgb = Rgb::new(7.0, 5.2, 4.6);
const LIT_FLOOR: Rgb = Rgb::new(2.2, 1.15, 0.45);
/// Radiance after many reflections: the same from all sides.
const AMBIENT: Rgb = Rgb::new(0.075, 0.06, 0.05);
/// Radiance that the open air sends into the opening of the wall.
const OPEN_AIR: Rgb = Rgb::new(0.9, 0.75, 0.8);

/// The viewpoint, in metres; from here the sun is in an upper pane.
pub const EYE: Vec3 = vec3(0.95, 1.42, 4.7);
/// The point that the camera looks at, in metres.
pub const MIDDLE: Vec3 = vec3(0.12, 1.27, 0.0);

/// The radiance that arrives along a ray from inside the room.
pub fn radiance(ray: &Ray) -> Rgb {
    let (p, n) = inside_of_box(ray, ROOM[0], ROOM[1]);
    if n != Vec3::Z || !is_open(p) {
        return wall(ray, p, n);
    }
    let (bars, outside) = (at_depth(ray, 0.5 * THICKNESS), at_depth(ray, THICKNESS));
    if is_open(bars) && panes(bars, 0.0) == 0.0 {
        light_on(bars, Vec3::Z) * BARS
    } else if is_open(outside) {
        evening::radiance(ray.direction)
    } else {
        let deep = vec3(0.0, 0.0, -2.0 * THICKNESS);
        let (p, n) = inside_of_box(ray, OPENING[0].extend(0.0) + deep, OPENING[1].extend(9.0));
        light_on(p, n) * PLASTER
    }
}

/// Where a ray from inside a box leaves it, and the normal there, which points inside.
fn inside_of_box(ray: &Ray, min: Vec3, max: Vec3) -> (Vec3, Vec3) {
    let d = *ray.direction;
    let ahead = Vec3::select(d.cmplt(Vec3::ZERO), min, max);
    let t = ((ahead - ray.origin) / d).abs(); // a direction of −0 would make −∞ of what never comes
    let nearest = t.min_element();
    let axis = if t.x == nearest {
        Vec3::X
    } else if t.y == nearest {
        Vec3::Y
    } else {
        Vec3::Z
    };
    (ray.at(nearest), -axis * d.signum())
}

/// The point of a ray at this depth in the wall with the window, in metres.
fn at_depth(ray: &Ray, depth: f32) -> Vec3 {
    ray.at((-depth - ray.origin.z) / ray.direction.z)
}

fn is_open(p: Vec3) -> bool {
    p.truncate().cmpge(OPENING[0]).all() && p.truncate().cmple(OPENING[1]).all()
}

/// The fraction of glass in a spot of this radius, in metres, around a point in the plane of the bars.
fn panes(p: Vec3, radius: f32) -> f32 {
    let covered = |x: f32, edges: [[f32; 2]; 3]| -> f32 {
        let r = radius.max(1e-6);
        edges
            .iter()
            .map(|[from, to]| rise(from - r, from + r, x) - rise(to - r, to + r, x))
            .sum()
    };
    covered(p.x, COLUMNS) * covered(p.y, ROWS)
}

/// The radiance of white paper at a point with this normal: irradiance over π.
fn light_on(p: Vec3, n: Vec3) -> Rgb {
    let sky = panes_from(p, n);
    let from_floor = patch(vec3(0.9, 0.0, 2.2) - p, n, Vec3::Y, 6.0);
    let ambient = AMBIENT * corner_shade(p);
    sky + LIT_FLOOR * from_floor + ambient + sun_on(p, n)
}

/// View factor of a patch: the fraction of the hemisphere that the patch fills, weighted by the cosine:
/// cos θ cos θ′ A/(π r² + A).
fn patch(toward: Vec3, n: Vec3, its_normal: Vec3, area: f32) -> f32 {
    let r2 = toward.length_squared();
    n.dot(toward).max(0.0) * (-its_normal.dot(toward)).max(0.0) * area / (r2 * (PI * r2 + area))
}

/// Light of the panes: the upper panes show the sky, the lower panes show the darker sea.
fn panes_from(p: Vec3, n: Vec3) -> Rgb {
    let mut sum = Rgb::BLACK;
    for [left, right] in COLUMNS {
        for (row, [bottom, top]) in ROWS.into_iter().enumerate() {
            let middle = vec3(0.5 * (left + right), 0.5 * (bottom + top), -0.5 * THICKNESS);
            let seen = patch(middle - p, n, Vec3::Z, (right - left) * (top - bottom));
            sum += SKY * (seen * [0.6, 1.0, 1.1][row]);
        }
    }
    if p.z < 0.0 { sum + OPEN_AIR } else { sum }
}

/// The sun on a point, through the panes; its disc blurs the shadows of the bars with distance.
fn sun_on(p: Vec3, n: Vec3) -> Rgb {
    let s = evening::toward_sun();
    let far = (-0.5 * THICKNESS - p.z) / s.z;
    let facing = n.dot(*s);
    if facing <= 0.0 || far <= 0.0 {
        return Rgb::BLACK;
    }
    evening::sunlight() * (facing / PI * panes(p + far * *s, far * evening::SUN_RADIUS))
}

/// Corners receive less: the other wall stands in the light.
fn corner_shade(p: Vec3) -> f32 {
    let to_walls = (p - ROOM[0]).min(ROOM[1] - p).max(Vec3::ZERO);
    let shade = |away: f32| 1.0 - 0.4 * (-away / 0.25).exp();
    shade(to_walls.x) * shade(to_walls.y) * shade(to_walls.z) / 0.6
}

/// Floor boards, papered walls, a white ceiling, and white boards along the floor and around the window.
fn wall(ray: &Ray, p: Vec3, n: Vec3) -> Rgb {
    if n == Vec3::Y {
        return floor(ray, p);
    }
    let from_window = (p.truncate() - p.truncate().clamp(OPENING[0], OPENING[1])).length();
    let framed = n == Vec3::Z && from_window < 0.11;
    let colour = if n == Vec3::NEG_Y || p.y < 0.13 || framed {
        PLASTER
    } else {
        paper(if n == Vec3::Z { p.x } else { p.z }, p.y)
    };
    light_on(p, n) * colour
}

/// Wallpaper: stripes, with a chain of lozenges on every second one.
fn paper(along: f32, y: f32) -> Rgb {
    /// Width of a stripe, and height of a lozenge, in metres.
    const TILE: Vec2 = vec2(0.16, 0.24);
    let tile = vec2(along, y) / TILE;
    let from_middle = ((tile - tile.floor()) - 0.5).abs();
    let lozenge = 2.2 * from_middle.x + from_middle.y < 0.42;
    let plain = tile.x.floor().rem_euclid(2.0) == 1.0;
    PAPER
        * if plain {
            1.25
        } else if lozenge {
            1.45
        } else {
            1.0
        }
}

/// Varnished boards: each has its own tone and grain, and mirrors the window at grazing angles.
fn floor(ray: &Ray, p: Vec3) -> Rgb {
    /// Width and length of a board, in metres.
    const BOARD: Vec2 = vec2(0.17, 1.6);
    let column = (p.x / BOARD.x).floor();
    let row = (p.z / BOARD.y + hash(column as i32, 7)).floor();
    let tone = hash(column as i32, row as i32);
    let grain = layers(vec2(55.0 * p.x, 2.5 * p.z) + 40.0 * tone, 3);
    let across = p.x / BOARD.x - column;
    let joint = rise(0.0, 0.012, across.min(1.0 - across));
    let wood = WOOD * ((0.6 + 0.5 * tone) * (0.7 + 0.6 * grain) * (0.3 + 0.7 * joint));

    let d = *ray.direction;
    let tilt = 0.012 * (tone - 0.5) * Vec3::X;
    let mirrored = Ray::new(p, Dir3::new_or(vec3(d.x, -d.y, d.z) + tilt, Dir3::Y));
    let fresnel = 0.04 + 0.96 * (1.0 + d.y).powi(5); // Schlick 1994
    let glass = if d.z < 0.0 {
        panes(at_depth(&mirrored, 0.5 * THICKNESS), 0.04 * p.z)
    } else {
        0.0
    };
    let gloss = 0.8 * fresnel * glass * joint;
    light_on(p, Vec3::Y) * wood + evening::radiance(mirrored.direction) * gloss
}
