//! Things of glass and water on a checkered floor.

use glam::{Vec3, vec3};
use raybook::image::rgb::Rgb;
use raybook::light::directional::DirectionalLight;
use raybook::material::checkered::Checkered;
use raybook::material::glass::{Glass, Medium};
use raybook::material::phong::Phong;
use raybook::math::basis::Basis;
use raybook::math::dir3::Dir3;
use raybook::math::ray::Ray;
use raybook::scene::world::{Scene, Thing};
use raybook::shape::cuboid::Cuboid;
use raybook::shape::plane::Plane;
use raybook::shape::sphere::Sphere;
use std::f32::consts::PI;

/// Where a camera sees the still life, where it looks, and its focal length.
pub const VIEW: (Vec3, Vec3, f32) = (vec3(0.4, 4.3, 7.2), vec3(0.1, 0.62, 0.0), 0.043);

/// Gap between things that seem to touch, in metres.
const GAP: f32 = 1e-3;

/// Things on a floor of squares of a metre, under the sun, in a studio with a window.
fn on_floor(mut things: Vec<Thing>) -> Scene {
    let tile = |r, g, b| Phong {
        ambient: Rgb::new(r, g, b),
        diffuse: Rgb::new(r, g, b) / PI,
        specular: Rgb::BLACK,
        exponent: 1.0,
    };
    let floor = Plane::through(Vec3::ZERO, Dir3::Y);
    let tiles = Checkered(tile(0.86, 0.80, 0.70), tile(0.05, 0.17, 0.23));
    things.push(Thing::new(floor, tiles));
    let sun = DirectionalLight {
        toward: Dir3::new_or(vec3(-0.5, 1.0, 0.4), Dir3::Y),
        irradiance: Rgb::new(2.0, 1.85, 1.6),
    };
    let mut scene = Scene::new(things, vec![Box::new(sun)]);
    scene.ambient = Rgb::new(0.30, 0.34, 0.40);
    scene.backdrop = Box::new(studio);
    scene
}

/// A ball inside another ball, which it displaces: both surfaces know both media.
fn ball_in_ball(center: Vec3, radii: [f32; 2], media: [Medium; 2]) -> [Thing; 2] {
    let inner = Glass {
        outside: media[0],
        inside: media[1],
    };
    [
        Thing::new(Sphere::new(center, radii[0]), Glass::of(media[0])),
        Thing::new(Sphere::new(center, radii[1]), inner),
    ]
}

/// What the things are made of.
#[derive(Clone, Copy, Debug)]
pub struct Stuff {
    /// The glass's index of refraction.
    pub index: f32,
    /// The index of refraction of the liquid in the tank.
    pub liquid: f32,
    /// Factor on the absorption of the coloured glass; 1 is the absorption that is given below.
    pub absorption: f32,
}

impl Stuff {
    /// Clear glass.
    fn clear(self) -> Medium {
        Medium::clear(self.index)
    }

    /// The liquid in the tank.
    fn liquid(self) -> Medium {
        Medium::clear(self.liquid)
    }

    /// Coloured glass: σ for each colour, in 1/m.
    fn coloured(self, r: f32, g: f32, b: f32) -> Medium {
        Medium {
            absorption: Rgb::new(r, g, b) * self.absorption,
            ..self.clear()
        }
    }
}

/// A ball that lies on the floor.
fn ball(x: f32, z: f32, radius: f32, medium: Medium) -> Thing {
    let center = vec3(x, radius + GAP, z);
    Thing::new(Sphere::new(center, radius), Glass::of(medium))
}

/// A ball of glass in a tank of a liquid; `around_ball` is the medium that the ball takes to be around it.
fn tank(x: f32, z: f32, around_ball: Medium, stuff: Stuff) -> [Thing; 2] {
    let water = Cuboid::between(vec3(x - 1.1, GAP, z - 1.0), vec3(x + 1.1, 1.9, z + 1.0));
    let in_water = Glass {
        outside: around_ball,
        inside: stuff.clear(),
    };
    [
        Thing::new(water, Glass::of(stuff.liquid())),
        Thing::new(Sphere::new(vec3(x, 0.75, z), 0.7), in_water),
    ]
}

/// A ball of glass, a ball with a large bubble, a ball in a tank of liquid, and three balls of coloured glass.
pub fn still_life(stuff: Stuff) -> Scene {
    let bubble = [stuff.clear(), Medium::AIR];
    let mut things = vec![
        ball(-0.35, -0.4, 1.25, stuff.clear()),
        ball(-1.45, 1.75, 0.45, stuff.coloured(0.15, 0.9, 3.2)),
        ball(0.95, 1.55, 0.45, stuff.coloured(3.0, 0.5, 0.4)),
        ball(2.35, 1.2, 0.45, stuff.coloured(0.25, 2.2, 1.0)),
    ];
    let hollow = vec3(-2.75, 0.95 + GAP, -0.9);
    things.extend(ball_in_ball(hollow, [0.95, 0.78], bubble));
    things.extend(tank(2.4, -1.2, stuff.liquid(), stuff));
    on_floor(things)
}

/// The same ball in four surroundings, each by its name.
pub fn nested(stuff: Stuff) -> [(&'static str, Scene); 4] {
    let center = vec3(0.0, 1.0 + GAP, 0.0);
    let bubble = ball_in_ball(center, [1.0, 0.7], [stuff.clear(), Medium::AIR]);
    [
        ("glass in air", vec![ball(0.0, 0.0, 1.0, stuff.clear())]),
        ("air in glass", bubble.into()),
        (
            "glass in the liquid",
            tank(0.0, 0.0, stuff.liquid(), stuff).into(),
        ),
        (
            "wrong: takes the liquid for air",
            tank(0.0, 0.0, Medium::AIR, stuff).into(),
        ),
    ]
    .map(|(name, things)| (name, on_floor(things)))
}

/// Balls of the same green glass, each twice as large as the one before.
pub fn sizes(stuff: Stuff) -> Scene {
    let green = stuff.coloured(1.6, 0.25, 0.9);
    let balls = [(-2.6, 0.2), (-1.75, 0.4), (-0.25, 0.8), (2.55, 1.6)];
    on_floor(balls.map(|(x, r)| ball(x, -r, r, green)).into())
}

/// A bright room: a pale wall, a blue ceiling, and a window of six panes.
fn studio(ray: &Ray) -> Rgb {
    let d = ray.direction;
    let wall =
        Rgb::new(0.78, 0.76, 0.74).lerp(Rgb::new(0.36, 0.50, 0.70), d.y.clamp(0.0, 1.0).sqrt());
    // The window is in a plane at distance 1 in the direction `toward`.
    let toward = Dir3::new_or(vec3(-0.6, 0.75, 0.55), Dir3::Y);
    let basis = Basis::around(toward);
    let ahead = d.dot(*toward);
    let (x, y) = (d.dot(*basis.x) / ahead, d.dot(*basis.y) / ahead);
    let inside = ahead > 0.0 && x.abs() < 0.36 && y.abs() < 0.5;
    let bars = x.abs() < 0.02 || (y.abs() - 0.17).abs() < 0.02;
    if inside && !bars {
        Rgb::new(5.0, 4.8, 4.4)
    } else {
        wall
    }
}
