//! Four plates and four lamps: a test of multiple importance sampling, in which neither strategy is best everywhere.
//!
//! ```
//! use raybook::scene::plates::plates;
//!
//! assert_eq!(plates().lights.len(), 4); // of four sizes
//! ```

use crate::accel::{Meshed, list::List};
use crate::image::rgb::Rgb;
use crate::light::{Light, extent::LightSampling, sphere_light::SphereLight};
use crate::material::{lambert::Lambert, modified_phong::ModifiedPhong};
use crate::math::dir3::Dir3;
use crate::scene::world::{Scene, Thing};
use crate::shape::mesh::Mesh;
use crate::shape::{plane::Plane, sphere::Sphere};
use glam::{Vec2, Vec3, vec2, vec3};

/// Where the camera stands, in metres.
pub const EYE: Vec3 = vec3(0.0, 2.0, 15.0);
/// The point that the camera looks at, in metres.
pub const AT: Vec3 = vec3(0.0, -1.6, 1.5);

/// y and z of each plate's middle, in metres, and the exponent of its highlight; the smoothest plate is at the back.
const PLATES: [(Vec2, f32); 4] = [
    (vec2(-2.4, -0.1), 20_000.0),
    (vec2(-3.1, 1.0), 2000.0),
    (vec2(-3.6, 2.2), 300.0),
    (vec2(-3.9, 3.5), 60.0),
];
/// Half the depth and half the width of a plate, in metres.
const HALF: Vec2 = vec2(0.5, 4.0);

/// The lamps' radii, in metres. All lamps have the same power, so the smaller a lamp, the larger its radiance.
const RADII: [f32; 4] = [0.04, 0.12, 0.36, 0.9];
/// Radiance times r² of each lamp, in W/sr.
const POWER: Rgb = Rgb::new(1.0, 0.92, 0.78);

/// A row of lamps from small to large, and below them plates from smooth to rough, each tilted so that the lamps are seen in it
/// (after Veach and Guibas 1995).
pub fn plates() -> Scene {
    let mut things: Vec<Thing> = PLATES.map(|(at, exponent)| plate(at, exponent)).into();
    let room = Lambert {
        albedo: Rgb::new(0.66, 0.68, 0.72),
    };
    let walls = [
        (vec3(0.0, -4.3, 0.0), Dir3::Y),
        (vec3(0.0, 0.0, -2.5), Dir3::Z),
    ];
    things.extend(walls.map(|(point, normal)| Thing::new(Plane::through(point, normal), room)));
    let lights = RADII.iter().zip([-3.75, -1.25, 1.25, 3.75]).map(|(&r, x)| {
        Box::new(SphereLight {
            sphere: Sphere::new(vec3(x, 0.0, 0.0), r),
            radiance: POWER / (r * r),
            choose: LightSampling::BySolidAngle,
        }) as Box<dyn Light>
    });
    Scene::new(things, lights.collect())
}

/// A plate around x = 0, whose normal is half way between the eye and the lamps.
fn plate(at: Vec2, exponent: f32) -> Thing {
    let middle = vec3(0.0, at.x, at.y);
    let toward = |p: Vec3| (p - middle).normalize_or_zero();
    let normal = Dir3::new_or(toward(EYE) + toward(Vec3::ZERO), Dir3::Y);
    let (right, back) = (HALF.y * Vec3::X, HALF.x * Vec3::X.cross(*normal));
    let corners = [-right - back, right - back, right + back, -right + back];
    let positions = corners.map(|corner| middle + corner).into();
    let mesh = Mesh::new(positions, vec![[0, 1, 2], [0, 2, 3]], None, None)
        .unwrap_or_else(|error| unreachable!("a plate is finite: {error}"));
    let polish = ModifiedPhong {
        diffuse: Rgb::new(0.06, 0.08, 0.1),
        specular: Rgb::gray(0.6),
        exponent,
    };
    Thing::new(Meshed::new(mesh, List::new), polish)
}
