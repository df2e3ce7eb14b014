//! Chapter 18: `direction_to_cube`, `direction_to_latlong`, `sample_environment`, `environment_pdf`.

use crate::grade::examine::Examiner;
use crate::grade::{Edge, Graded, Mistake, Picture, Verdict, judge, sample};
use crate::lab::palette::{direction as direction_colour, viridis};
use crate::light::environment::latlong;
use crate::math::piecewise::Piecewise;
use crate::math::{dir3::Dir3, pcg::Pcg};
use crate::workbook::exercise::Exercise;
use crate::workbook::exercises::ch18_environment::{
    CubePlace, DensityQuestion, DirectionQuestion, DirectionToCube, DirectionToLatlong,
    EnvironmentPdf, LATTICE, MapQuestion, SampleEnvironment,
};
use glam::{Vec2, Vec3, vec2, vec3};
use rand::RngExt;
use std::f64::consts::PI;

/// This chapter's exercises, in order.
pub const GRADED: &[&dyn Examiner] = &[
    &DirectionToCube,
    &DirectionToLatlong,
    &SampleEnvironment,
    &EnvironmentPdf,
];

fn toward(x: f32, y: f32, z: f32) -> Dir3 {
    Dir3::new_or(vec3(x, y, z), Dir3::X)
}

fn asks(direction: Dir3) -> DirectionQuestion {
    DirectionQuestion { direction }
}

fn turned(q: &DirectionQuestion, turn: impl Fn(Vec3) -> Vec3) -> DirectionQuestion {
    asks(Dir3::new_or(turn(*q.direction), Dir3::X))
}

impl Graded for DirectionToCube {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "sees the faces from outside",
            hint: "Stand in the cube and look along -z: is +x on your right or on your left?",
            answer: |q| {
                let right = Self::answer(q);
                CubePlace {
                    u: 1.0 - right.u,
                    ..right
                }
            },
        },
        Mistake {
            name: "has the faces upside down",
            hint: "v runs downwards: what is v for a direction a little above the horizon?",
            answer: |q| {
                let right = Self::answer(q);
                CubePlace {
                    v: 1.0 - right.v,
                    ..right
                }
            },
        },
        Mistake {
            name: "leaves the place between -1 and 1",
            hint: "The middle of a face is at (0.5, 0.5): what do you return for an axis?",
            answer: |q| {
                let right = Self::answer(q);
                CubePlace {
                    u: 2.0 * right.u - 1.0,
                    v: 2.0 * right.v - 1.0,
                    ..right
                }
            },
        },
        Mistake {
            name: "takes the largest component, whatever its sign",
            hint: "Which component of (-0.9, 0.1, 0.2) decides?",
            answer: |q| CubePlace {
                face: 2 * q.direction.max_position() as u32,
                ..Self::answer(q)
            },
        },
        Mistake {
            name: "has the faces of each pair exchanged",
            hint: "Is +x face 0 or face 1?",
            answer: |q| {
                let right = Self::answer(q);
                CubePlace {
                    face: right.face ^ 1,
                    ..right
                }
            },
        },
        Mistake {
            name: "divides by the component with its sign",
            hint: "On the face -x the largest component is negative: what does dividing by it do to the other two?",
            answer: |q| {
                let right = Self::answer(q);
                let negative = right.face % 2 == 1;
                let turned = |x: f32| if negative { 1.0 - x } else { x };
                CubePlace {
                    u: turned(right.u),
                    v: turned(right.v),
                    ..right
                }
            },
        },
        Mistake {
            name: "does not divide by the largest component",
            hint: "At the edge of a face, u must be 0 or 1: the direction has to reach the cube's wall first.",
            answer: |q| {
                let d = q.direction;
                let right = Self::answer(q);
                let m = d.abs().max_element();
                CubePlace {
                    u: 0.5 + (right.u - 0.5) * m,
                    v: 0.5 + (right.v - 0.5) * m,
                    ..right
                }
            },
        },
        Mistake {
            name: "has ceiling and floor turned by half a turn",
            hint: "Look at -z and raise your eyes to the ceiling: where on it does it meet the wall -z?",
            answer: |q| {
                let right = Self::answer(q);
                let turned = |x: f32| {
                    if matches!(right.face, 2 | 3) {
                        1.0 - x
                    } else {
                        x
                    }
                };
                CubePlace {
                    u: turned(right.u),
                    v: turned(right.v),
                    ..right
                }
            },
        },
    ];

    const PICTURE: Option<Picture<Self>> = Some(Picture {
        width: 96,
        height: 48,
        alt: "All directions on a map of the world; each face of the cube has its colour, with rings around its middle",
        question: |x, y| {
            asks(latlong::direction(vec2(
                (x as f32 + 0.5) / 96.0,
                (y as f32 + 0.5) / 48.0,
            )))
        },
        colour: |_, place| {
            let from_middle = 2.0 * (vec2(place.u, place.v) - 0.5);
            let ring = (4.0 * from_middle.abs().max_element()).floor();
            let axis = [Vec3::X, Vec3::Y, Vec3::Z][(place.face as usize / 2).min(2)];
            let side = if place.face % 2 == 0 { axis } else { -axis };
            direction_colour(side)
                * if ring % 2.0 == 0.0 {
                    1.0
                } else {
                    0.75 + 0.1 * from_middle.x
                }
        },
    });

    fn edges() -> Vec<Edge<Self>> {
        let place = |face, u, v| CubePlace { face, u, v };
        vec![
            Edge::new("the middle of +x", asks(Dir3::X)),
            Edge::new("the middle of -x", asks(-Dir3::X)),
            Edge::new("the middle of +y", asks(Dir3::Y)),
            Edge::new("the middle of -y", asks(-Dir3::Y)),
            Edge::new("the middle of +z", asks(Dir3::Z)),
            Edge::new("the middle of -z", asks(-Dir3::Z)),
            Edge::new("right of and above -z", asks(toward(0.25, 0.5, -1.0))),
            Edge::new("on the ceiling, towards -z", asks(toward(0.2, 1.0, -0.7))),
            Edge::new("on the floor, towards -z", asks(toward(0.2, -1.0, -0.7))),
            Edge::new("on the wall -x", asks(toward(-1.0, 0.3, 0.6))),
            Edge::new("just before an edge", asks(toward(1.0, 0.2, -0.999))),
            Edge::new("on the edge of +x and +y", asks(toward(1.0, 1.0, 0.0)))
                .or(place(2, 1.0, 0.5)),
        ]
    }

    fn random(rng: &mut Pcg) -> DirectionQuestion {
        asks(sample::direction(rng))
    }

    fn judge(_q: &DirectionQuestion, golden: &CubePlace, got: &CubePlace) -> Verdict {
        const FACES: [&str; 6] = ["+x", "-x", "+y", "-y", "+z", "-z"];
        if golden.face != got.face {
            let name = |face: u32| FACES.get(face as usize).copied().unwrap_or("no face");
            return Err(format!(
                "the face is {} ({}), and should be {} ({})",
                got.face,
                name(got.face),
                golden.face,
                name(golden.face)
            ));
        }
        judge::number("u", "", golden.u, got.u)?;
        judge::number("v", "", golden.v, got.v)
    }
}

impl Graded for DirectionToLatlong {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "has left and right exchanged",
            hint: "Look along -z, the middle of the map: on which side of it is +x?",
            answer: |q| Self::answer(&turned(q, |d| vec3(-d.x, d.y, d.z))),
        },
        Mistake {
            name: "counts v from the bottom",
            hint: "What is v for +y, straight up?",
            answer: |q| Self::answer(&turned(q, |d| vec3(d.x, -d.y, d.z))),
        },
        Mistake {
            name: "begins with -z at the left edge",
            hint: "What is u for -z, which is in the middle?",
            answer: |q| {
                let right = Self::answer(q);
                vec2((right.x + 0.5).fract(), right.y)
            },
        },
        Mistake {
            name: "has +z in the middle",
            hint: "Which sign of z is in the middle of the map?",
            answer: |q| Self::answer(&turned(q, |d| vec3(d.x, d.y, -d.z))),
        },
        Mistake {
            name: "has +x in the middle",
            hint: "Which two components does the angle around the y axis come from, and in which order?",
            answer: |q| Self::answer(&turned(q, |d| vec3(d.z, d.y, -d.x))),
        },
        Mistake {
            name: "takes the height for the angle",
            hint: "v is an angle divided by pi. Half way up the sky, at 45 degrees, v is 0.25: what is yours?",
            answer: |q| vec2(Self::answer(q).x, 0.5 - 0.5 * q.direction.y),
        },
        Mistake {
            name: "divides both angles by 2 pi",
            hint: "How large can the angle from +y get, and how large the one around it?",
            answer: |q| {
                let right = Self::answer(q);
                vec2(right.x, 0.5 * right.y)
            },
        },
        Mistake {
            name: "takes the arc tangent of a quotient",
            hint: "Do two directions that lie opposite have the same place? The quotient has lost the signs.",
            answer: |q| {
                let d = q.direction;
                let phi = (d.x / -d.z).atan();
                let right = Self::answer(q);
                if phi.is_nan() {
                    right
                } else {
                    vec2(0.5 + phi / (2.0 * PI as f32), right.y)
                }
            },
        },
    ];

    const PICTURE: Option<Picture<Self>> = Some(Picture {
        width: 96,
        height: 72,
        alt: "A wide view into the middle of the map: lines of latitude and longitude",
        question: |x, y| {
            asks(toward(
                (x as f32 - 47.5) / 36.0,
                (35.5 - y as f32) / 36.0,
                -1.0,
            ))
        },
        colour: |_, place| {
            let lines = (24.0 * place.x).floor() + (12.0 * place.y).floor();
            viridis(place.x) * if lines % 2.0 == 0.0 { 1.0 } else { 0.6 }
        },
    });

    fn edges() -> Vec<Edge<Self>> {
        vec![
            Edge::new("the middle, -z", asks(-Dir3::Z)),
            Edge::new("right, +x", asks(Dir3::X)),
            Edge::new("left, -x", asks(-Dir3::X)),
            Edge::new("behind, +z", asks(Dir3::Z)).or(vec2(1.0, 0.5)),
            Edge::new("straight up", asks(Dir3::Y)),
            Edge::new("straight down", asks(-Dir3::Y)),
            Edge::new("45 degrees up", asks(toward(0.0, 1.0, -1.0))),
            Edge::new("nearly straight up", asks(toward(1e-4, 1.0, 0.0))),
            Edge::new("behind, on the right", asks(toward(0.3, 0.2, 1.0))),
            Edge::new("behind, on the left", asks(toward(-0.3, 0.2, 1.0))),
        ]
    }

    fn random(rng: &mut Pcg) -> DirectionQuestion {
        asks(sample::direction(rng))
    }

    /// Places are compared by their directions: at a pole all u are the same place, and so are the left and the right edge.
    fn judge(_q: &DirectionQuestion, golden: &Vec2, got: &Vec2) -> Verdict {
        let on_map = |x: f32| (-1e-4..=1.0 + 1e-4).contains(&x);
        if !(on_map(got.x) && on_map(got.y)) {
            return Err(format!(
                "({}, {}) is not on the map, which is from 0 to 1",
                got.x, got.y
            ));
        }
        let [golden, place] = [golden, got].map(|place| *latlong::direction(*place));
        judge::direction("the direction at your place", golden, place)
    }
}

/// The row and the cell of a place in so many.
fn cell(x: f32, n: u32) -> usize {
    ((x * n as f32).max(0.0) as usize).min(n as usize - 1)
}

impl MapQuestion {
    fn texel(&self, x: usize, y: usize) -> f64 {
        f64::from(self.texels[y * self.width as usize + x])
    }

    /// The solid angle of a texel of a row.
    fn solid_angle(&self, y: usize) -> f64 {
        let [top, bottom] = latlong::cosines(y, self.height as usize);
        2.0 * PI * (top - bottom) / f64::from(self.width)
    }

    /// The share of a texel in all the light.
    fn share(&self, x: usize, y: usize) -> f64 {
        let light = |x, y| self.texel(x, y) * self.solid_angle(y);
        let cells =
            (0..self.height as usize).flat_map(|y| (0..self.width as usize).map(move |x| (x, y)));
        light(x, y) / cells.map(|(x, y)| light(x, y)).sum::<f64>()
    }

    /// The directions of a sampler that goes by rows, then by columns.
    ///
    /// `weight` is what a texel counts for when its row is chosen and when it is chosen in the row; `cosine` places the
    /// direction between the cosines of the row's edges.
    fn sampled(
        &self,
        weight: fn(&Self, usize, usize) -> f64,
        cosine: fn(f64, f64, f64) -> f64,
    ) -> Vec<Vec3> {
        let (width, height) = (self.width as usize, self.height as usize);
        let columns: Vec<_> = (0..height)
            .map(|y| Piecewise::new((0..width).map(|x| weight(self, x, y))))
            .collect();
        let rows = Piecewise::new(columns.iter().map(Piecewise::total));
        let along = |i: usize| (i as f32 + 0.5) / LATTICE as f32;
        let points = (0..LATTICE).flat_map(|j| (0..LATTICE).map(move |i| (along(i), along(j))));
        let direction = |(u, v)| {
            let row = rows.choose(v)?;
            let column = columns[row.cell].choose(u)?;
            let [top, bottom] = latlong::cosines(row.cell, height);
            let turn = (column.cell as f32 + column.within) / width as f32;
            let cosine = cosine(top, bottom, f64::from(row.within));
            Some(*latlong::toward(turn, cosine as f32))
        };
        points.filter_map(direction).collect()
    }
}

fn by_solid_angle(top: f64, bottom: f64, within: f64) -> f64 {
    top + (bottom - top) * within
}

fn by_angle(top: f64, bottom: f64, within: f64) -> f64 {
    (top.acos() + (bottom.acos() - top.acos()) * within).cos()
}

/// So many of the points may be on the wrong side of a line: a line through the map goes through at most one point of each
/// row or column of the lattice, in a map of rows then columns, or columns then rows; half as many again are for other maps.
const STRAY: usize = LATTICE + LATTICE / 2;

impl Graded for SampleEnvironment {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "weighs all rows as if they were equally wide",
            hint: "The rows near the poles are as long on the map as the others: are they on the sphere?",
            answer: |q| q.sampled(MapQuestion::texel, by_solid_angle),
        },
        Mistake {
            name: "goes through a row evenly by its angle",
            hint: "Equal steps of the angle from a pole sweep unequal areas of the sphere: what does sweep equal ones?",
            answer: |q| q.sampled(|q, x, y| q.texel(x, y) * q.solid_angle(y), by_angle),
        },
        Mistake {
            name: "ignores how bright the texels are",
            hint: "Where is most of the light? Most of your directions should be there.",
            answer: |q| q.sampled(|q, _, y| q.solid_angle(y), by_solid_angle),
        },
        Mistake {
            name: "chooses all texels equally often",
            hint: "Neither the radiance nor the area of a texel seems to matter to you: both do.",
            answer: |q| q.sampled(|_, _, _| 1.0, by_solid_angle),
        },
        Mistake {
            name: "weighs by the square of the radiance",
            hint: "A texel twice as bright should be chosen twice as often: how often is it?",
            answer: |q| {
                q.sampled(
                    |q, x, y| q.texel(x, y).powi(2) * q.solid_angle(y),
                    by_solid_angle,
                )
            },
        },
        Mistake {
            name: "chooses the column without regard to the row",
            hint: "Two bright texels in different rows: do you ever choose the row of one and the column of the other?",
            answer: |q| {
                q.sampled(
                    |q, x, y| {
                        let column: f64 = (0..q.height as usize).map(|y| q.share(x, y)).sum();
                        let row: f64 = (0..q.width as usize).map(|x| q.share(x, y)).sum();
                        column * row
                    },
                    by_solid_angle,
                )
            },
        },
        Mistake {
            name: "always takes the middle of a texel",
            hint: "Are two directions in the same texel ever different? All of the texel shines.",
            answer: |q| {
                let centre = |d: &Vec3| {
                    let place = latlong::place(toward(d.x, d.y, d.z));
                    let (x, y) = (cell(place.x, q.width), cell(place.y, q.height));
                    *latlong::direction(vec2(
                        (x as f32 + 0.5) / q.width as f32,
                        (y as f32 + 0.5) / q.height as f32,
                    ))
                };
                Self::answer(q).iter().map(centre).collect()
            },
        },
    ];

    fn edges() -> Vec<Edge<Self>> {
        let map = |width, height, texels: &[f32]| MapQuestion {
            width,
            height,
            texels: texels.to_vec(),
        };
        let one = |at: usize| {
            let mut texels = [0.0; 8];
            texels[at] = 2.0;
            map(4, 2, &texels)
        };
        vec![
            Edge::new("a single texel: all directions alike", map(1, 1, &[1.0])),
            Edge::new("a black map", map(2, 2, &[0.0; 4])),
            Edge::new("one bright texel", one(5)),
            Edge::new("the first texel only", one(0)),
            Edge::new("the last texel only", one(7)),
            Edge::new("a constant map of four rows", map(2, 4, &[1.0; 8])),
            Edge::new("the poles brightest", map(1, 5, &[4.0, 1.0, 1.0, 1.0, 4.0])),
            Edge::new(
                "two bright texels, in other rows and columns",
                map(3, 2, &[5.0, 0.0, 0.0, 0.0, 0.0, 5.0]),
            ),
            Edge::new("a bright sky, a dim ground", map(1, 2, &[3.0, 1.0])),
        ]
    }

    fn random(rng: &mut Pcg) -> MapQuestion {
        let (width, height) = (rng.random_range(2..5), rng.random_range(2..5));
        let texels = (0..width * height)
            .map(|_| sample::number(rng, 0.1, 2.0).powi(3))
            .collect();
        MapQuestion {
            width,
            height,
            texels,
        }
    }

    /// By distribution: of the lattice's points, the right share must be in every part of the sphere.
    fn judge(q: &MapQuestion, golden: &Vec<Vec3>, got: &Vec<Vec3>) -> Verdict {
        if golden.len() != got.len() {
            return Err(format!(
                "there are {} directions, and should be {}",
                got.len(),
                golden.len()
            ));
        }
        for (i, direction) in got.iter().enumerate() {
            if (direction.length() - 1.0).abs() > judge::LENGTH || !direction.is_finite() {
                return Err(format!("direction {i} has length {}", direction.length()));
            }
        }
        distributed(q, got)
    }
}

/// Whether directions are distributed as the map's light.
fn distributed(q: &MapQuestion, directions: &[Vec3]) -> Verdict {
    let (width, height) = (q.width as usize, q.height as usize);
    let places: Vec<Vec2> = directions
        .iter()
        .map(|d| latlong::place(toward(d.x, d.y, d.z)))
        .collect();
    let all = places.len() as f64;
    if directions.is_empty() {
        return Ok(()); // none are due: the map is black
    }
    let compare = |what: String, found: usize, share: f64| {
        let right = share * all;
        if (found as f64 - right).abs() <= STRAY as f64 {
            return Ok(());
        }
        Err(format!(
            "of {all} directions {found} are {what}, and should be about {right:.0}"
        ))
    };
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        let inside = |p: &&Vec2| cell(p.x, q.width) == x && cell(p.y, q.height) == y;
        let found = places.iter().filter(inside).count();
        compare(format!("in column {x} of row {y}"), found, q.share(x, y))?;
        // At the very edge, rounding may have chosen the side.
        let deep = |p: &&Vec2| {
            let within =
                vec2(p.x * q.width as f32, p.y * q.height as f32) - vec2(x as f32, y as f32);
            (within - 0.5).abs().max_element() < 0.5 - 1e-3
        };
        let found = places.iter().filter(deep).count();
        if q.share(x, y) == 0.0 && found > 0 {
            return Err(format!(
                "{found} directions are in column {x} of row {y}, which is black"
            ));
        }
    }
    // Above every circle of latitude and left of every meridian, in quarters of texels, there must be the right share.
    for quarter in 1..4 * height {
        let (y, part) = (quarter / 4, 0.25 * (quarter % 4) as f64);
        let row = |y: usize| (0..width).map(|x| q.share(x, y)).sum::<f64>();
        let [top, bottom] = latlong::cosines(y, height);
        let angle = PI * quarter as f64 / (4 * height) as f64;
        let of_row = (top - angle.cos()) / (top - bottom);
        let share = (0..y).map(row).sum::<f64>() + if part > 0.0 { of_row * row(y) } else { 0.0 };
        let found = places
            .iter()
            .filter(|p| f64::from(p.y) < angle / PI)
            .count();
        compare(
            format!("within {:.0}° of +y", angle.to_degrees()),
            found,
            share,
        )?;
    }
    for quarter in 1..4 * width {
        let (x, part) = (quarter / 4, 0.25 * (quarter % 4) as f64);
        let column = |x: usize| (0..height).map(|y| q.share(x, y)).sum::<f64>();
        let share = (0..x).map(column).sum::<f64>() + part * column(x);
        let edge = quarter as f64 / (4 * width) as f64;
        let found = places.iter().filter(|p| f64::from(p.x) < edge).count();
        compare(format!("left of {edge:.2} on the map"), found, share)?;
    }
    Ok(())
}

impl DensityQuestion {
    fn map(&self) -> MapQuestion {
        MapQuestion {
            width: self.width,
            height: self.height,
            texels: self.texels.clone(),
        }
    }

    /// The texel of the direction: its column and its row.
    fn texel(&self) -> (usize, usize) {
        let place = latlong::place(self.direction);
        (cell(place.x, self.width), cell(place.y, self.height))
    }

    /// The texel's share of the light, and its solid angle.
    fn share(&self) -> (f64, f64) {
        let (x, y) = self.texel();
        let share = self.map().share(x, y);
        (
            if share.is_nan() { 0.0 } else { share },
            self.map().solid_angle(y),
        )
    }
}

impl Graded for EnvironmentPdf {
    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "returns the probability of the texel",
            hint: "A probability becomes a density when it is divided by something: what is the unit of the answer?",
            answer: |q| q.share().0 as f32,
        },
        Mistake {
            name: "returns the density on the map, not on the sphere",
            hint: "How many steradians is the unit square of the map, and is it the same everywhere on it?",
            answer: |q| (q.share().0 * f64::from(q.width * q.height)) as f32,
        },
        Mistake {
            name: "takes the sine at the direction for the whole texel",
            hint: "Directions are uniform inside a texel: does your density differ between two of the same texel?",
            answer: |q| {
                let sine = f64::from(q.direction.x.hypot(q.direction.z)).max(1e-6);
                let on_map = q.share().0 * f64::from(q.width * q.height);
                (on_map / (2.0 * PI * PI * sine)) as f32
            },
        },
        Mistake {
            name: "forgets that rows differ in solid angle when it chooses them",
            hint: "For a constant map the density must be 1/(4 pi) everywhere: is it, near a pole?",
            answer: |q| {
                let (map, (x, y)) = (q.map(), q.texel());
                let sum: f64 = q.texels.iter().map(|t| f64::from(*t)).sum();
                if sum > 0.0 {
                    (map.texel(x, y) / sum / map.solid_angle(y)) as f32
                } else {
                    0.0
                }
            },
        },
        Mistake {
            name: "gives all texels the solid angle of 4 pi over their number",
            hint: "Texels at the equator and at a pole: which is larger on the sphere?",
            answer: |q| (q.share().0 * f64::from(q.width * q.height) / (4.0 * PI)) as f32,
        },
        Mistake {
            name: "ignores the map",
            hint: "Bright directions are chosen more often: is your density larger there?",
            answer: |q| {
                if q.texels.iter().all(|t| *t == 0.0) {
                    0.0
                } else {
                    (0.25 / PI) as f32
                }
            },
        },
        Mistake {
            name: "counts the rows from the bottom",
            hint: "Which row does +y belong to?",
            answer: |q| {
                let d = q.direction;
                Self::answer(&DensityQuestion {
                    direction: toward(d.x, -d.y, d.z),
                    ..q.clone()
                })
            },
        },
        Mistake {
            name: "returns the radiance",
            hint: "If the whole map were twice as bright, would the directions be chosen otherwise?",
            answer: |q| {
                let (x, y) = q.texel();
                q.map().texel(x, y) as f32
            },
        },
    ];

    const PICTURE: Option<Picture<Self>> = Some(Picture {
        width: 96,
        height: 48,
        alt: "A map of 8 by 4 texels, each as bright as the density there",
        question: |x, y| DensityQuestion {
            direction: latlong::direction(vec2((x as f32 + 0.5) / 96.0, (y as f32 + 0.5) / 48.0)),
            width: 8,
            height: 4,
            texels: (0..32).map(|i| ((i * 7) % 11) as f32).collect(),
        },
        colour: |_, density| viridis(4.0 * density),
    });

    fn edges() -> Vec<Edge<Self>> {
        let question = |direction, width, height, texels: &[f32]| DensityQuestion {
            direction,
            width,
            height,
            texels: texels.to_vec(),
        };
        let sky = [4.0, 2.0, 1.0, 0.5, 1.0, 2.0, 0.0, 1.0];
        let inside = toward(0.4, 0.5, -0.9);
        vec![
            Edge::new(
                "a single texel: all directions alike",
                question(inside, 1, 1, &[3.0]),
            ),
            Edge::new("a black map", question(inside, 2, 2, &[0.0; 4])),
            Edge::new(
                "one bright texel, outside it",
                question(inside, 2, 2, &[0.0, 0.0, 0.0, 5.0]),
            ),
            Edge::new(
                "one bright texel, inside it",
                question(inside, 2, 2, &[0.0, 5.0, 0.0, 0.0]),
            ),
            Edge::new(
                "a constant map, near a pole",
                question(toward(0.1, 1.0, 0.1), 2, 4, &[1.0; 8]),
            ),
            Edge::new(
                "a constant map, at the equator",
                question(toward(0.3, 0.1, 1.0), 2, 4, &[1.0; 8]),
            ),
            Edge::new(
                "the upper row",
                question(toward(-0.3, 0.8, 0.3), 2, 4, &sky),
            ),
            Edge::new(
                "the lower row",
                question(toward(0.3, -0.9, 0.3), 2, 4, &sky),
            ),
            Edge::new(
                "a black texel among others",
                question(toward(-0.4, -0.9, -0.3), 2, 4, &sky),
            ),
        ]
    }

    fn random(rng: &mut Pcg) -> DensityQuestion {
        let map = SampleEnvironment::random(rng);
        DensityQuestion {
            direction: sample::direction(rng),
            width: map.width,
            height: map.height,
            texels: map.texels,
        }
    }

    fn judge(_q: &DensityQuestion, golden: &f32, got: &f32) -> Verdict {
        let tolerance = judge::RELATIVE * golden.abs().max(1e-3);
        judge::number_within("the density", "per steradian", *golden, *got, tolerance)
    }
}
