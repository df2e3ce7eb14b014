//! Where two surfaces meet, light arrives as it does beside: no dark line, and no light from behind.

use crate::ch15_shadows::rays::random_direction;
use crate::ch15_shadows::{from_lamp, lit, scene};
use glam::{Quat, Vec3, vec3};
use rand::RngExt;
use raybook::accel::{Meshed, wide_bvh::WideBvh};
use raybook::math::pcg::{self, Pcg};
use raybook::math::{dir3::Dir3, ray::Ray};
use raybook::shape::mesh::Mesh;
use raybook::shape::{Shape, cuboid::Cuboid, plane::Plane};
use raybook_common::{STALE, grouped, measured};

/// Two half planes that meet at an angle, turned and placed in the world; `at` says where a point of it is.
struct Crease {
    shapes: Vec<Box<dyn Shape>>,
    angle: f32,
    turn: Quat,
    place: Vec3,
    size: f32,
}

impl Crease {
    /// Along the crease, and at an angle above the first half plane, at a distance; all in sizes.
    fn at(&self, along: f32, angle: f32, distance: f32) -> Vec3 {
        let local = vec3(distance * angle.cos(), distance * angle.sin(), along);
        self.place + self.size * (self.turn * local)
    }

    /// Planes, rectangles of a mesh, or a box on a plane, from the scale of millimetres to that of kilometres.
    fn random(rng: &mut Pcg) -> Self {
        let size = 10.0_f32.powf(rng.random_range(-3.0..3.0));
        let turned = rng.random_bool(0.7);
        let turn = if turned {
            Quat::from_rotation_arc(Vec3::Y, *random_direction(rng))
        } else {
            Quat::IDENTITY
        };
        let mut crease = Self {
            shapes: Vec::new(),
            angle: rng.random_range(0.5..2.8),
            turn,
            place: size * rng.random_range(0.0..5.0) * *random_direction(rng),
            size,
        };
        let kind = if turned { rng.random_range(0..2) } else { 2 };
        if kind == 2 {
            crease.angle = std::f32::consts::FRAC_PI_2;
        }
        let half = |angle: f32| {
            [(-9.0, 0.0), (9.0, 0.0), (9.0, 9.0), (-9.0, 9.0)]
                .map(|(along, distance)| crease.at(along, angle, distance))
        };
        let mesh = |corners: Vec<[Vec3; 4]>| -> Box<dyn Shape> {
            let triangles = (0..corners.len() as u32)
                .flat_map(|i| [[4 * i, 4 * i + 1, 4 * i + 2], [4 * i, 4 * i + 2, 4 * i + 3]]);
            let mesh = Mesh::new(corners.concat(), triangles.collect(), None, None);
            Box::new(Meshed::new(mesh.expect("a crease is a mesh"), WideBvh::new))
        };
        let plane = |angle: f32| -> Box<dyn Shape> {
            let normal = crease.turn * vec3(-angle.sin(), angle.cos(), 0.0);
            Box::new(Plane::through(crease.place, Dir3::new_or(normal, Dir3::Y)))
        };
        crease.shapes = match kind {
            0 => vec![plane(0.0), plane(crease.angle)],
            1 => vec![mesh(vec![half(0.0), half(crease.angle)])],
            // The box is at the other side of its face, and stands on the ground.
            _ => vec![
                plane(0.0),
                Box::new(Cuboid::between(
                    crease.place - 9.0 * size * Vec3::Z,
                    crease.place + size * vec3(-9.0, 9.0, 9.0),
                )),
            ],
        };
        crease
    }
}

/// How rays leave a point of a crease.
#[derive(Clone, Copy, PartialEq)]
enum Start {
    /// Along the normal.
    OffTheSurface,
    /// On the way on which the point was seen (`Surface::seen_along`).
    TowardsTheEye,
}

/// How many of a number of points right in creases are dark in the light of a lamp before them, and how many are lit by one behind.
fn wrong(cases: usize, start: Start) -> [usize; 2] {
    let mut rng = pcg::stream(15, 7);
    let [mut dark, mut leaks] = [0, 0];
    for _ in 0..cases {
        let mut crease = Crease::random(&mut rng);
        let scene = scene(std::mem::take(&mut crease.shapes));
        // Anywhere before both half planes, 11° from each at least.
        let mut before = |distance: f32| {
            let angle = rng.random_range(0.2..crease.angle - 0.2);
            crease.at(rng.random_range(-2.0..2.0), angle, distance)
        };
        let (eye, lamp) = (before(3.0), before(2.0));
        let toward = Dir3::new(crease.at(0.0, 0.0, 0.0) - eye).expect("the eye is away");
        let mut at = scene
            .closest(&Ray::new(eye, toward))
            .expect("it is there")
            .surface;
        if start == Start::OffTheSurface {
            at.clear = Vec3::ZERO;
        }
        dark += usize::from(!lit(&scene, &at, &from_lamp(lamp, &at)));
        // Behind the half plane that the point is not on.
        let on_first = at.normal.dot(crease.turn * Vec3::Y).abs() > 0.9999;
        let behind = if on_first { crease.angle + 0.2 } else { -0.2 };
        let hidden = crease.at(rng.random_range(-2.0..2.0), behind, 2.0);
        leaks += usize::from(lit(&scene, &at, &from_lamp(hidden, &at)));
    }
    [dark, leaks]
}

#[test]
fn a_crease_is_neither_dark_nor_does_it_let_light_through() {
    const POINTS: usize = 20_000;
    assert_eq!(
        wrong(POINTS, Start::TowardsTheEye),
        [0, 0],
        "dark points, and points that are lit from behind"
    );
    let [dark, leaks] = wrong(POINTS, Start::OffTheSurface).map(|count| grouped(count as u64));
    let told = format!(
        "The tests look at {} points in creases, at scales from a millimetre to a kilometre. With the step along the normal alone, {dark} of \
        them are dark, and {leaks} are lit from behind. With the step back on the way to the eye, none is.\n",
        grouped(POINTS as u64)
    );
    assert_eq!(measured("creases", &told), told, "{STALE}");
}
