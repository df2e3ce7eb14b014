//! Teapots on a long table in the garden, at dusk, under strings of lamps.

use glam::{Mat3, Vec3, vec2, vec3};
use raybook::accel::Meshed;
use raybook::accel::wide_bvh::WideBvh;
use raybook::image::rgb::Rgb;
use raybook::light::point::PointLight;
use raybook::light::rect_light::RectLight;
use raybook::material::mirror::Mirror;
use raybook::material::phong::Phong;
use raybook::material::polished::Polished;
use raybook::material::texture::Texture;
use raybook::math::ray::Ray;
use raybook::math::whole::below;
use raybook::scene::noise::{self, hash, rise};
use raybook::scene::world::{Scene, Thing};
use raybook::shape::cuboid::Cuboid;
use raybook::shape::instance::Instance;
use raybook::shape::{Shape, Surface, teapot};
use std::f32::consts::PI;
use std::sync::Arc;

/// Where the table is seen from, in metres.
pub const EYE: Vec3 = vec3(0.0, 0.30, 0.0);

/// The point that the camera of the main picture looks at.
pub const VIEW: Vec3 = vec3(0.0, 0.19, -1.0);

/// Where the table is seen from for a narrow picture of all teapots: the row is shorter from there.
pub const ALONG: Vec3 = vec3(0.16, 0.30, 0.0);

/// The point that the camera of the narrow picture looks at.
pub const NARROW_VIEW: Vec3 = vec3(-0.02, 0.19, -1.0);

/// The point that the camera looks at for a detail with some of the teapots.
pub const DETAIL: Vec3 = vec3(-0.20, 0.11, -1.0);

/// The camera's focal length, in metres.
pub const FOCAL_LENGTH: f32 = 0.05;

/// A point among the lamps that are far behind.
pub const FAR: Vec3 = vec3(0.0, 0.4, -9.0);

/// The middle of each teapot's foot, the nearest first.
pub const POTS: [Vec3; 5] = [
    vec3(0.20, 0.0, -0.62),
    vec3(0.03, 0.0, -0.98),
    vec3(-0.22, 0.0, -1.50),
    vec3(-0.56, 0.0, -2.20),
    vec3(-1.02, 0.0, -3.15),
];

/// Their glazes.
const GLAZES: [Rgb; 5] = [
    Rgb::new(0.05, 0.28, 0.33),
    Rgb::new(0.72, 0.16, 0.05),
    Rgb::new(0.75, 0.50, 0.10),
    Rgb::new(0.70, 0.68, 0.62),
    Rgb::new(0.12, 0.20, 0.45),
];

/// Height of a teapot, in metres; Newell's teapot is 3.15 of his units high.
const HEIGHT: f32 = 0.15;

/// The table, the teapots and a soft light from the left.
pub fn tea_table() -> Scene {
    let cloth = Cuboid::between(vec3(-1.7, -0.05, -4.0), vec3(1.1, 0.0, 0.5));
    let mut things = vec![Thing::new(cloth, Gingham)];
    let pot: Arc<dyn Shape> = Arc::new(Meshed::new(teapot::mesh(10), WideBvh::new));
    for (i, (foot, glaze)) in POTS.into_iter().zip(GLAZES).enumerate() {
        let shape = Instance {
            shape: pot.clone(),
            scale: HEIGHT / 3.15,
            rotation: Mat3::from_rotation_y(-0.35 - 0.5 * i as f32),
            translation: foot,
        };
        things.push(Thing::new(shape, glazed(glaze)));
    }
    // It faces the table from the left, above the camera.
    let (corner, up, across) = (
        vec3(-1.9, 0.9, -1.2),
        vec3(0.4, 1.0, 0.0),
        vec3(0.5, 0.0, 1.5),
    );
    let window = RectLight::new(corner, up, across, Rgb::new(7.0, 6.0, 4.8));
    Scene::new(things, vec![Box::new(window)]).surrounded_by(Rgb::new(0.30, 0.33, 0.42), dusk)
}

/// The lamps: three strings of them, and some far behind.
pub fn lamps() -> Vec<PointLight> {
    let warm = Rgb::new(1.0, 0.56, 0.18);
    let colours = [
        warm,
        Rgb::new(1.0, 0.74, 0.40),
        Rgb::new(1.0, 0.26, 0.12),
        warm,
        Rgb::new(0.15, 0.62, 0.68),
    ];
    // Farther lamps are brighter: with the focus at 1 m, all discs are about equally bright.
    let lamp = |position: Vec3, colour: Rgb| PointLight {
        position,
        intensity: colour * (0.000_8 * (position.z + 1.0).powi(2)),
    };
    let string = |row: i32| {
        let (depth, top) = (3.9 + 1.1 * row as f32, 0.75 + 0.42 * row as f32);
        (0..9 + 2 * row).map(move |i| {
            // Loops of a parabola between hooks that are 1.6 m apart.
            let x = (i as f32 - 0.5 * (8 + 2 * row) as f32) * 0.46 + 0.19 * row as f32;
            let loops = (x + 0.37 * row as f32).rem_euclid(1.6) / 0.8 - 1.0;
            let sway = 0.05 * (hash(i, row) - 0.5);
            let y = top - 0.34 * (1.0 - loops * loops) + sway;
            lamp(
                vec3(x, y, -depth - sway),
                colours[(i + 2 * row) as usize % 5],
            )
        })
    };
    let far = (0..26).map(|i| {
        let [x, y, z] = [7, 11, 13].map(|k| hash(i, k));
        let depth = 7.0 + 5.0 * z;
        let place = vec3((x - 0.5) * 0.95 * depth, 0.10 + 0.075 * y * depth, -depth);
        lamp(place, colours[(i % 4) as usize] * 0.6)
    });
    (0..3).flat_map(string).chain(far).collect()
}

/// Glaze: colour below, and a little of a mirror above.
fn glazed(colour: Rgb) -> Polished<Phong> {
    Polished {
        mirror: Mirror {
            share: Rgb::gray(0.07),
        },
        below: Phong {
            ambient: colour,
            diffuse: colour / PI,
            specular: Rgb::gray(0.16),
            exponent: 30.0,
        },
    }
}

/// Stripes across stripes: a tablecloth.
struct Gingham;

impl Texture for Gingham {
    type Material = Phong;

    fn at(&self, at: &Surface) -> Phong {
        /// Width of a stripe, in metres.
        const STRIPE: f32 = 0.045;
        let dyed = |v: f32| f32::from(below(v / STRIPE) & 1 == 0);
        let share = 0.5 * (dyed(at.position.x) + dyed(at.position.z));
        let colour = Rgb::new(0.80, 0.78, 0.73).lerp(Rgb::new(0.20, 0.33, 0.50), share);
        Phong {
            ambient: colour,
            diffuse: colour / PI,
            specular: Rgb::BLACK,
            exponent: 1.0,
        }
    }
}

/// The last light over hedges.
pub fn dusk(ray: &Ray) -> Rgb {
    let d = ray.direction;
    let up = d.y.max(0.0);
    let sky = Rgb::new(0.58, 0.32, 0.22).lerp(Rgb::new(0.11, 0.16, 0.31), (3.0 * up).min(1.0));
    let hedge = Rgb::new(0.060, 0.085, 0.080).lerp(Rgb::new(0.10, 0.12, 0.10), (-d.y).max(0.0));
    let azimuth = d.x.atan2(-d.z);
    let leaves = 0.010 * (noise::layers(vec2(60.0 * azimuth, 60.0 * d.y), 3) - 0.5);
    let top = 0.035 + 0.016 * (9.0 * azimuth).sin() + 0.012 * (23.0 * azimuth + 1.0).sin() + leaves;
    // Sharp: what blurs it is the lens.
    hedge.lerp(sky, rise(-0.001, 0.001, d.y - top))
}
