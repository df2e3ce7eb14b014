//! A pavilion to stand in: there is something to see in every direction, above and below too.

use super::summer;
use glam::{Mat3, Vec3, vec3};
use raybook::accel::Meshed;
use raybook::accel::wide_bvh::WideBvh;
use raybook::image::rgb::Rgb;
use raybook::material::glass::{Glass, Medium};
use raybook::material::mirror::Mirror;
use raybook::material::phong::Phong;
use raybook::math::dir3::Dir3;
use raybook::scene::world::{Scene, Thing};
use raybook::shape::cuboid::Cuboid;
use raybook::shape::instance::Instance;
use raybook::shape::plane::Plane;
use raybook::shape::sphere::Sphere;
use raybook::shape::{Shape, teapot};
use std::f32::consts::{FRAC_1_PI, FRAC_PI_2};
use std::sync::Arc;

/// The viewpoint: in the middle, at a person's height.
pub const EYE: Vec3 = vec3(0.0, 1.6, 0.0);

/// Half the side of the square in which the posts stand, in metres.
const HALF: f32 = 3.7;

/// Heights of the lower and the upper side of the beams that the posts carry, in metres.
const BEAM: (f32, f32) = (2.9, 3.2);

/// The lower inner edges of the four beams, as seen from the viewpoint: a name, and where the edge begins and ends.
pub const BEAMS: [(&str, [Vec3; 2]); 4] = {
    const SIDE: f32 = HALF - THICK;
    const Y: f32 = BEAM.0;
    [
        ("ahead", [vec3(-HALF, Y, -SIDE), vec3(HALF, Y, -SIDE)]),
        ("right", [vec3(SIDE, Y, -HALF), vec3(SIDE, Y, HALF)]),
        ("behind", [vec3(HALF, Y, SIDE), vec3(-HALF, Y, SIDE)]),
        ("left", [vec3(-SIDE, Y, HALF), vec3(-SIDE, Y, -HALF)]),
    ]
};

/// Half the width of a beam, in metres.
const THICK: f32 = 0.1;

/// Half the side of the tiled floor, in metres; a tile has a side of 1 m.
const FLOOR: i16 = 4;

const CREAM: Rgb = Rgb::new(0.80, 0.73, 0.62);
const TEAL: Rgb = Rgb::new(0.09, 0.27, 0.32);
const WOOD: Rgb = Rgb::new(0.46, 0.26, 0.13);
const VERMILION: Rgb = Rgb::new(0.70, 0.16, 0.06);
const OCHRE: Rgb = Rgb::new(0.78, 0.50, 0.10);
const BLUE: Rgb = Rgb::new(0.07, 0.22, 0.50);
const GRASS: Rgb = Rgb::new(0.20, 0.30, 0.10);

/// The pavilion in the sun.
pub fn scene() -> Scene {
    let mut things = vec![matte(Plane::through(vec3(0.0, -0.2, 0.0), Dir3::Y), GRASS)];
    floor(&mut things);
    frame(&mut things);
    on_show(&mut things);
    Scene::new(things, vec![Box::new(summer::sun())])
        .surrounded_by(Rgb::new(0.34, 0.38, 0.44), summer::outdoors)
}

/// Tiles on a step, and four coloured ones below the viewer.
fn floor(things: &mut Vec<Thing>) {
    let half = f32::from(FLOOR);
    things.push(matte(
        block(Vec3::ZERO, half + 0.4, (-0.2, -0.1)),
        CREAM * 0.8,
    ));
    for (i, j) in (-FLOOR..FLOOR).flat_map(|j| (-FLOOR..FLOOR).map(move |i| (i, j))) {
        let (x, z) = (f32::from(i), f32::from(j));
        let colour = match (i, j) {
            (-1, -1) => VERMILION,
            (0, -1) => OCHRE,
            (0, 0) => BLUE,
            (-1, 0) => TEAL,
            _ if (i + j) % 2 == 0 => CREAM,
            _ => TEAL,
        };
        let tile = Cuboid::between(vec3(x, -0.1, z), vec3(x + 1.0, 0.0, z + 1.0));
        things.push(matte(tile, colour));
    }
}

/// Twelve posts, the beams that they carry, and slats over them through which the sun shines.
fn frame(things: &mut Vec<Thing>) {
    let third = HALF / 3.0;
    let places = [-HALF, -third, third, HALF];
    for (x, z) in places.into_iter().flat_map(|x| places.map(|z| (x, z))) {
        if x.abs().max(z.abs()) == HALF {
            let foot = vec3(x, 0.0, z);
            things.push(matte(block(foot, 0.13, (0.0, BEAM.0)), CREAM));
            things.push(matte(block(foot, 0.20, (0.0, 0.14)), CREAM));
            things.push(matte(block(foot, 0.20, (BEAM.0 - 0.12, BEAM.0)), CREAM));
        }
    }
    let (low, high) = BEAM;
    let beam = |a: Vec3, b: Vec3| matte(Cuboid::between(a, b), WOOD);
    for side in [-HALF, HALF] {
        let (far, near) = (side - THICK, side + THICK);
        things.push(beam(vec3(-HALF, low, far), vec3(HALF, high, near)));
        things.push(beam(vec3(far, low, -HALF), vec3(near, high, HALF)));
    }
    for i in -6..=6 {
        let z = 0.62 * i as f32;
        let from = vec3(-HALF - 0.5, high, z - 0.05);
        things.push(beam(from, vec3(HALF + 0.5, high + 0.18, z + 0.05)));
    }
}

/// The objects: mirror and glass ahead, a teapot at the right, balls behind, a bench at the left, a gilded ball above.
fn on_show(things: &mut Vec<Thing>) {
    let mirror = |r, g, b| Mirror {
        share: Rgb::new(r, g, b),
    };
    let ball = |x: f32, y: f32, z: f32, r: f32| Sphere::new(vec3(x, y, z), r);
    let stand = |x: f32, z: f32, half: f32, height: f32| {
        matte(block(vec3(x, 0.0, z), half, (0.0, height)), CREAM)
    };
    things.extend([
        Thing::new(ball(-1.1, 0.8, -2.3, 0.8), mirror(0.93, 0.93, 0.92)),
        stand(1.2, -2.2, 0.32, 1.0),
        Thing::new(ball(1.2, 1.451, -2.2, 0.45), Glass::of(Medium::GLASS)),
        stand(2.5, 0.1, 0.4, 0.95),
        Thing::new(pot(vec3(2.5, 0.95, 0.1)), glossy(BLUE)),
        glossy_ball(ball(0.7, 0.6, 2.5, 0.6), VERMILION),
        glossy_ball(ball(-0.55, 0.42, 2.1, 0.42), OCHRE),
        glossy_ball(ball(0.05, 0.26, 1.55, 0.26), CREAM),
        matte(
            Cuboid::between(vec3(-3.0, 0.40, -1.3), vec3(-2.5, 0.48, 1.3)),
            WOOD,
        ),
        stand(-2.75, -1.0, 0.2, 0.4),
        stand(-2.75, 1.0, 0.2, 0.4),
        glossy_ball(ball(-2.75, 0.73, -0.6, 0.25), TEAL),
        glossy_ball(ball(-2.75, 0.66, 0.1, 0.18), VERMILION),
        Thing::new(ball(0.5, 2.75, -0.5, 0.2), mirror(0.95, 0.72, 0.32)),
    ]);
}

/// The teapot, 0.95 m long from handle to spout, with the spout to the viewer's right.
fn pot(translation: Vec3) -> Instance {
    let mesh = teapot::mesh(8);
    let scale = 0.95 / mesh.bounds().size().x;
    Instance {
        shape: Arc::new(Meshed::new(mesh, WideBvh::new)),
        scale,
        rotation: Mat3::from_rotation_y(-FRAC_PI_2),
        translation,
    }
}

/// A box on a square, from one height to another.
fn block(middle: Vec3, half: f32, (low, high): (f32, f32)) -> Cuboid {
    let corner = |side: f32, y: f32| (middle + vec3(side, 0.0, side)).with_y(middle.y + y);
    Cuboid::between(corner(-half, low), corner(half, high))
}

fn matte(shape: impl Shape + 'static, colour: Rgb) -> Thing {
    let specular = Rgb::BLACK;
    Thing::new(
        shape,
        Phong {
            specular,
            ..glossy(colour)
        },
    )
}

fn glossy_ball(ball: Sphere, colour: Rgb) -> Thing {
    Thing::new(ball, glossy(colour))
}

fn glossy(colour: Rgb) -> Phong {
    Phong {
        ambient: colour,
        diffuse: colour * FRAC_1_PI,
        specular: Rgb::gray(0.2),
        exponent: 90.0,
    }
}
