//! `direction_to_latlong`: the place, compared by the direction that it is.

use super::toward;
use crate::{Graded, Mistake, Picture, Verdict, judge, sample};
use glam::{Vec2, Vec3, Vec3Swizzles, vec2, vec3};
use raybook::light::environment::latlong;
use raybook::math::{dir3::Dir3, pcg::Pcg};
use raybook_chapters::kit::palette::viridis;
use raybook_workbook::exercises::ch18_environment::DirectionToLatlong;
use std::f64::consts::PI;

fn turned(q: &DirectionToLatlong, turn: impl Fn(Vec3) -> Vec3) -> DirectionToLatlong {
    asks(Dir3::new_or(turn(*q.direction), Dir3::X))
}

fn asks(direction: Dir3) -> DirectionToLatlong {
    DirectionToLatlong { direction }
}

impl Graded for DirectionToLatlong {
    fn random(rng: &mut Pcg) -> DirectionToLatlong {
        asks(sample::direction(rng))
    }

    /// Places are compared by their directions: at a pole all u are the same place, and so are the left and the right edge.
    fn judge(_q: &Self, golden: &Vec2, got: &Vec2) -> Verdict {
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

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "has left and right exchanged",
            hint: "Look along -z, the middle of the map: on which side of it is +x?",
            answer: |q| Self::right(&turned(q, |d| vec3(-d.x, d.y, d.z))),
        },
        Mistake {
            name: "counts v from the bottom",
            hint: "What is v for +y, straight up?",
            answer: |q| Self::right(&turned(q, |d| vec3(d.x, -d.y, d.z))),
        },
        Mistake {
            name: "begins with -z at the left edge",
            hint: "What is u for -z, which is in the middle?",
            answer: |q| {
                let right = Self::right(q);
                vec2((right.x + 0.5).fract(), right.y)
            },
        },
        Mistake {
            name: "has +z in the middle",
            hint: "Which sign of z is in the middle of the map?",
            answer: |q| Self::right(&turned(q, |d| vec3(d.x, d.y, -d.z))),
        },
        Mistake {
            name: "has +x in the middle",
            hint: "Which two components does the angle around the y axis come from, and in which order?",
            answer: |q| Self::right(&turned(q, |d| vec3(d.z, d.y, -d.x))),
        },
        Mistake {
            name: "takes the height for the angle from +y",
            hint: "v is an angle divided by π. Half way up the sky, at 45 degrees, v is 0.25: what is yours?",
            answer: |q| vec2(Self::right(q).x, 0.5 - 0.5 * q.direction.y),
        },
        Mistake {
            name: "divides both angles by 2π",
            hint: "How large can the angle from +y get, and how large the one around it?",
            answer: |q| {
                let right = Self::right(q);
                vec2(right.x, 0.5 * right.y)
            },
        },
        Mistake {
            name: "takes the arc tangent of a quotient",
            hint: "Do two directions that lie opposite have the same place? The quotient has lost the signs.",
            answer: |q| {
                let d = q.direction;
                let phi = (d.x / -d.z).atan();
                let right = Self::right(q);
                if phi.is_nan() {
                    right
                } else {
                    vec2(0.5 + phi / (2.0 * PI as f32), right.y)
                }
            },
        },
        Mistake {
            name: "takes π for the whole way round",
            hint: "How many radians is the way round the horizon?",
            answer: |q| {
                let right = Self::right(q);
                vec2((2.0 * right.x - 0.5).rem_euclid(1.0), right.y)
            },
        },
        Mistake {
            name: "takes the angle from +z for the angle from +y",
            hint: "Which axis points up on the map?",
            answer: |q| {
                let right = Self::right(q);
                let angle = q.direction.z.clamp(-1.0, 1.0).acos();
                vec2(right.x, angle / std::f32::consts::PI)
            },
        },
        Mistake {
            name: "forgets on which side of the middle a direction is: the sign of x",
            hint: "An arc cosine is never negative: how do you tell left from right?",
            answer: |q| Self::right(&turned(q, |d| vec3(d.x.abs(), d.y, d.z))),
        },
        Mistake {
            name: "takes +z for up, and looks along +y",
            hint: "Which axis is up on this map, and which is in its middle?",
            answer: |q| Self::right(&turned(q, |d| vec3(d.x, d.z, -d.y))),
        },
        Mistake {
            name: "has -x in the middle",
            hint: "Which two components does the angle around the y axis come from, and in which order?",
            answer: |q| Self::right(&turned(q, |d| vec3(-d.z, d.y, d.x))),
        },
        Mistake {
            name: "returns the angles, not their shares of the way round and of the way down",
            hint: "In which units are the two numbers of a place: in radians, or as shares of the map?",
            answer: |q| {
                let right = Self::right(q);
                PI as f32 * vec2(2.0 * right.x, right.y)
            },
        },
        Mistake {
            name: "returns the angles in degrees",
            hint: "In which units are the two numbers of a place: in degrees, or as shares of the map?",
            answer: |q| 180.0 * vec2(2.0, 1.0) * Self::right(q),
        },
        Mistake {
            name: "returns the angles in degrees, the one around from −180 to 180",
            hint: "In which units are the two numbers of a place: in degrees, or as shares of the map? And where does the map begin?",
            answer: |q| 180.0 * (vec2(2.0, 1.0) * Self::right(q) - vec2(1.0, 0.0)),
        },
        Mistake {
            name: "returns the angles, the one around from −π to π",
            hint: "In which units are the two numbers of a place: in radians, or as shares of the map? And where does the map begin?",
            answer: |q| {
                let right = Self::right(q);
                PI as f32 * vec2(2.0 * right.x - 1.0, right.y)
            },
        },
        Mistake {
            name: "takes the angle above the horizon for the angle from +y",
            hint: "What is v for +y, straight up, and for the horizon?",
            answer: |q| {
                let right = Self::right(q);
                vec2(right.x, 0.5 - right.y)
            },
        },
        Mistake {
            name: "takes the arc sine for the angle around, so that what is behind comes to the front",
            hint: "Two angles around have the same sine: how do you tell front from back?",
            answer: |q| Self::right(&turned(q, |d| vec3(d.x, d.y, -d.z.abs()))),
        },
        Mistake {
            name: "takes the arc cosine of −z itself for the angle around",
            hint: "Half way up the sky, ahead: how long is what is left of the direction without its height?",
            answer: |q| {
                let d = q.direction;
                let phi = (-d.z).clamp(-1.0, 1.0).acos().copysign(d.x);
                vec2(0.5 + phi / (2.0 * PI as f32), Self::right(q).y)
            },
        },
        Mistake {
            name: "takes x and y of the direction themselves for the place, brought to the range from 0 to 1",
            hint: "Two directions with the same x and y, one ahead and one behind: do they have the same place? And what is an angle in your function?",
            answer: |q| 0.5 + vec2(0.5, -0.5) * q.direction.xy(),
        },
        Mistake {
            name: "exchanges the two arguments of the arc tangent",
            hint: "Which argument of the arc tangent is 0 in the middle of the map: is that x or z, and does it come first?",
            answer: |q| Self::right(&turned(q, |d| vec3(-d.z, d.y, -d.x))),
        },
        Mistake {
            name: "has -x in the middle, and left and right exchanged",
            hint: "Which two components does the angle around the y axis come from, in which order, and with which signs?",
            answer: |q| Self::right(&turned(q, |d| vec3(d.z, d.y, d.x))),
        },
        Mistake {
            name: "forgets the half that puts -z in the middle, and so has negative u on the left",
            hint: "What is u for -z, which is in the middle of the map, and what is the arc tangent there?",
            answer: |q| {
                let Vec3 { x, z, .. } = *q.direction;
                let is_pole = x == 0.0 && z == 0.0;
                let phi = if is_pole { 0.0 } else { x.atan2(-z) };
                vec2(phi / (2.0 * PI as f32), Self::right(q).y)
            },
        },
        Mistake {
            name: "has left and right exchanged, and counts v from the bottom",
            hint: "Look along -z, the middle of the map: on which side of it is +x, and what is v for +y, straight up?",
            answer: |q| Self::right(&turned(q, |d| vec3(-d.x, -d.y, d.z))),
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[Picture {
        name: "direction_to_latlong",
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
    }];
}
