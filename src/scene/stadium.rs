//! The teapot in a stadium: a small object of many triangles in the middle of a large one.
//!
//! ```
//! use raybook::scene::stadium::{Part, stadium};
//!
//! let stadium = stadium(1);
//! assert_eq!(stadium.part(0), Part::Teapot);
//! assert!(stadium.mesh.bounds().size().x > 100.0 && stadium.mesh.triangles().len() > 8000);
//! ```

use crate::shape::mesh::Mesh;
use crate::shape::teapot;
use glam::{Vec3, vec3};
use std::f32::consts::TAU;

/// A life-size teapot on the centre spot of a stadium.
#[derive(Clone, Debug)]
pub struct Stadium {
    /// Teapot and stadium, in metres.
    pub mesh: Mesh,
    /// The parts in order, each with the number of the first triangle after it.
    ends: Vec<(Part, u32)>,
}

/// The part of the stadium to which a triangle belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The teapot.
    Teapot,
    /// The field and what is under the seats.
    Ground,
    /// The white lines on the field.
    Lines,
    /// The steps on which the seats are, and the wall behind the last step.
    Steps,
    /// The seats.
    Seats,
    /// The roof over them.
    Roof,
}

/// The teapot's width from spout to handle, in metres.
const TEAPOT: f32 = 0.4;

/// Half the length and half the width of the area that the seats surround, in metres.
const FIELD: (f32, f32) = (58.0, 40.0);

/// Number of rows of seats.
const ROWS: u16 = 24;

/// Distance from one row to the next, in metres.
const DEPTH: f32 = 0.85;

/// The stadium whose teapot is [`teapot::mesh`] of n = `fineness`, from 1 to 100, with 38·n seats and 2·n aisles in a row: about
/// 64·n² + 8000·n triangles, that is 40 000 for n = 5 and 120 000 for n = 14.
///
/// It is the classical bad case for a uniform grid: a cell whose size suits the seats holds the whole teapot.
pub fn stadium(fineness: u32) -> Stadium {
    let fineness = fineness.clamp(1, 100);
    let columns = 40 * fineness;
    let height = |row: f32| 1.2 + 0.38 * row + 0.008 * row * row;
    let back = f32::from(ROWS) * DEPTH;
    let top = height(f32::from(ROWS));

    let mut steps = vec![(0.0, 0.0), (0.0, height(0.0))];
    for row in (0..ROWS).map(f32::from) {
        steps.push(((row + 1.0) * DEPTH, height(row)));
        steps.push(((row + 1.0) * DEPTH, height(row + 1.0)));
    }
    steps.extend([
        (back, top + 1.5),
        (back + 2.0, top + 1.5),
        (back + 2.0, 0.0),
    ]);
    let roof = [
        (back + 2.5, top + 6.0),
        (back - 0.5 * back, top + 7.5),
        (back - 0.5 * back, top + 7.0),
    ];

    let mut builder = Builder::default();
    let pot = teapot::mesh(fineness as usize);
    let scale = TEAPOT / pot.bounds().size().x;
    builder.positions = pot.positions().iter().map(|&p| scale * p).collect();
    builder.triangles = pot.triangles().to_vec();
    builder.end(Part::Teapot);
    let corner = |x: f32, z: f32| vec3(x * FIELD.0, 0.0, z * FIELD.1);
    builder.quad([(-1.0, 1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)].map(|(x, z)| corner(x, z)));
    builder.end(Part::Ground);
    builder.lines();
    builder.end(Part::Lines);
    builder.sweep(&steps, columns);
    builder.end(Part::Steps);
    for row in (0..ROWS).map(f32::from) {
        let (depth, floor) = ((row + 0.55) * DEPTH, height(row));
        for column in (0..columns).filter(|column| column % 20 > 0) {
            let place = |across: f32, s: f32, y: f32| {
                around((column as f32 + across) / columns as f32, s, y)
            };
            let [front, seat, back] = [
                (depth - 0.3, floor + 0.42),
                (depth, floor + 0.4),
                (depth + 0.1, floor + 0.8),
            ];
            for [(s0, y0), (s1, y1)] in [[front, seat], [seat, back]] {
                builder.quad([
                    place(0.1, s0, y0),
                    place(0.9, s0, y0),
                    place(0.9, s1, y1),
                    place(0.1, s1, y1),
                ]);
            }
        }
    }
    builder.end(Part::Seats);
    builder.sweep(&roof, columns);
    builder.end(Part::Roof);
    Stadium {
        mesh: Mesh::new(builder.positions, builder.triangles, None, None)
            .unwrap_or_else(|error| unreachable!("a stadium is finite: {error}")),
        ends: builder.ends,
    }
}

impl Stadium {
    /// The part to which a triangle belongs.
    pub fn part(&self, triangle: u32) -> Part {
        let found = self.ends.iter().find(|&&(_, end)| triangle < end);
        found.map_or(Part::Ground, |&(part, _)| part)
    }
}

/// A place around the field: at the fraction `turn` of a full turn, s metres outside the field, at the height y, in metres.
///
/// The curve is |x/a|³ + |z/b|³ = 1 (a superellipse), which is between an ellipse and a rectangle.
fn around(turn: f32, s: f32, y: f32) -> Vec3 {
    let (sin, cos) = (TAU * turn).sin_cos();
    let (a, b) = (FIELD.0 + s, FIELD.1 + s);
    let r = ((cos / a).abs().powi(3) + (sin / b).abs().powi(3)).powf(-1.0 / 3.0);
    vec3(r * cos, y, r * sin)
}

/// A list of triangles, part by part.
#[derive(Default)]
struct Builder {
    positions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    ends: Vec<(Part, u32)>,
}

impl Builder {
    /// Ends a part: all triangles since the last end belong to `part`.
    fn end(&mut self, part: Part) {
        self.ends.push((part, self.triangles.len() as u32));
    }

    /// Adds a quadrilateral from four corners, counter-clockwise.
    fn quad(&mut self, corners: [Vec3; 4]) {
        let first = self.positions.len() as u32;
        self.positions.extend(corners);
        self.triangles
            .extend([[0, 1, 2], [0, 2, 3]].map(|t| t.map(|i| first + i)));
    }

    /// Adds the field's markings: its edge, the halfway line and the centre circle, 12 cm wide.
    fn lines(&mut self) {
        let mut stripe = |x0: f32, z0: f32, x1: f32, z1: f32| {
            self.quad([(x0, z1), (x1, z1), (x1, z0), (x0, z0)].map(|(x, z)| vec3(x, 0.01, z)));
        };
        let (x, z, w) = (52.5, 34.0, 0.12);
        stripe(-x, -z, x, -z + w);
        stripe(-x, z - w, x, z);
        for x in [-x, -0.5 * w, x - w] {
            stripe(x, -z, x + w, z);
        }
        let circle = |i: u16, r: f32| {
            let (sin, cos) = (TAU * f32::from(i) / 64.0).sin_cos();
            vec3(r * cos, 0.01, r * sin)
        };
        for i in 0..64 {
            self.quad([
                circle(i, 9.15),
                circle(i + 1, 9.15),
                circle(i + 1, 9.03),
                circle(i, 9.03),
            ]);
        }
    }

    /// Adds the surface of a line of points (s, y) that is swept around the field, in `columns` columns.
    fn sweep(&mut self, line: &[(f32, f32)], columns: u32) {
        let first = self.positions.len() as u32;
        for column in 0..columns {
            let turn = column as f32 / columns as f32;
            self.positions
                .extend(line.iter().map(|&(s, y)| around(turn, s, y)));
        }
        let points = line.len() as u32;
        let vertex = |column, point| first + column % columns * points + point;
        for column in 0..columns {
            for point in 1..points {
                let [a, b] = [vertex(column, point - 1), vertex(column + 1, point - 1)];
                let [c, d] = [vertex(column + 1, point), vertex(column, point)];
                self.triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
    }
}
