//! `direction_to_cube`: the face, and the place on it.

mod faces;

use crate::{Graded, Mistake, Picture, Verdict, judge, sample};
use faces::{
    clockwise, counter_clockwise, divided, left_for_right, numbered, on, on_axis, top_for_bottom,
};
use glam::{Vec3, vec2};
use raybook::light::environment::latlong;
use raybook::math::{dir3::Dir3, pcg::Pcg};
use raybook_chapters::kit::palette::direction as direction_colour;
use raybook_workbook::exercises::ch18_environment::{CubePlace, DirectionToCube};

fn asks(direction: Dir3) -> DirectionToCube {
    DirectionToCube { direction }
}

impl Graded for DirectionToCube {
    fn random(rng: &mut Pcg) -> DirectionToCube {
        asks(sample::direction(rng))
    }

    fn judge(_q: &Self, golden: &CubePlace, got: &CubePlace) -> Verdict {
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

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "sees the faces from outside",
            hint: "Stand in the cube and look along -z: is +x on your right or on your left?",
            answer: |q| {
                let right = Self::right(q);
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
                let right = Self::right(q);
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
                let right = Self::right(q);
                CubePlace {
                    u: 2.0 * right.u - 1.0,
                    v: 2.0 * right.v - 1.0,
                    ..right
                }
            },
        },
        Mistake {
            name: "takes the component that is largest with its sign, not the one of the largest absolute value",
            hint: "Which component of (-0.9, 0.1, 0.2) decides?",
            answer: |q| on_axis(q, q.direction.max_position()),
        },
        Mistake {
            name: "never compares x with z when it looks for the component of the largest absolute value",
            hint: "Which component of (0.6, 0.1, 0.8) decides?",
            answer: |q| {
                let d = q.direction.abs();
                let of_the_others = if d.y > d.z { 1 } else { 2 };
                on_axis(q, if d.x > d.y { 0 } else { of_the_others })
            },
        },
        Mistake {
            name: "counts the three positive faces before the three negative ones",
            hint: "Which number has the face -x: the one after +x, or the one after +z?",
            answer: |q| {
                let right = Self::right(q);
                CubePlace {
                    face: right.face / 2 + 3 * (right.face % 2),
                    ..right
                }
            },
        },
        Mistake {
            name: "has the faces of each pair exchanged",
            hint: "Is +x face 0 or face 1?",
            answer: |q| {
                let right = Self::right(q);
                CubePlace {
                    face: right.face ^ 1,
                    ..right
                }
            },
        },
        Mistake {
            name: "divides by the largest component with its sign, not by its absolute value",
            hint: "On the face -x the largest component is negative: what does dividing by it do to the other two?",
            answer: |q| {
                let right = Self::right(q);
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
                let right = Self::right(q);
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
                let right = Self::right(q);
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
        Mistake {
            name: "exchanges the numbers of ceiling and floor",
            hint: "Which number has the face +y, and which -y?",
            answer: |q| {
                let right = Self::right(q);
                let face = match right.face {
                    2 => 3,
                    3 => 2,
                    face => face,
                };
                CubePlace { face, ..right }
            },
        },
        Mistake {
            name: "exchanges the numbers of the faces +x and -x",
            hint: "Which number has the face +x, and which -x?",
            answer: |q| {
                let right = Self::right(q);
                let face = match right.face {
                    0 => 1,
                    1 => 0,
                    face => face,
                };
                CubePlace { face, ..right }
            },
        },
        Mistake {
            name: "exchanges the numbers of the faces +z and -z",
            hint: "Which number has the face +z, and which -z?",
            answer: |q| {
                let right = Self::right(q);
                let face = match right.face {
                    4 => 5,
                    5 => 4,
                    face => face,
                };
                CubePlace { face, ..right }
            },
        },
        Mistake {
            name: "has the ceiling +y upside down",
            hint: "Look at -z and raise or lower your eyes: at which edge of that face do you arrive?",
            answer: |q| on(q, &[2], top_for_bottom),
        },
        Mistake {
            name: "has the floor -y upside down",
            hint: "Look at -z and raise or lower your eyes: at which edge of that face do you arrive?",
            answer: |q| on(q, &[3], top_for_bottom),
        },
        Mistake {
            name: "exchanges the faces +x and -x, with what is to the right on them",
            hint: "What is the sign of the direction's x on each of the two faces?",
            answer: |q| {
                on(q, &[0, 1], |p| CubePlace {
                    face: p.face ^ 1,
                    u: 1.0 - p.u,
                    v: p.v,
                })
            },
        },
        Mistake {
            name: "exchanges the faces +y and -y, with what is to the right on them",
            hint: "What is the sign of the direction's y on each of the two faces?",
            answer: |q| {
                on(q, &[2, 3], |p| CubePlace {
                    face: p.face ^ 1,
                    u: p.u,
                    v: 1.0 - p.v,
                })
            },
        },
        Mistake {
            name: "exchanges the faces +z and -z, with what is to the right on them",
            hint: "What is the sign of the direction's z on each of the two faces?",
            answer: |q| {
                on(q, &[4, 5], |p| CubePlace {
                    face: p.face ^ 1,
                    u: 1.0 - p.u,
                    v: p.v,
                })
            },
        },
        Mistake {
            name: "has left and right exchanged on the face +x only",
            hint: "Stand in the cube and look at that face: what is on your right?",
            answer: |q| on(q, &[0], left_for_right),
        },
        Mistake {
            name: "has left and right exchanged on the face -x only",
            hint: "Stand in the cube and look at that face: what is on your right?",
            answer: |q| on(q, &[1], left_for_right),
        },
        Mistake {
            name: "has left and right exchanged on the face +y only",
            hint: "Stand in the cube and look at that face: what is on your right?",
            answer: |q| on(q, &[2], left_for_right),
        },
        Mistake {
            name: "has left and right exchanged on the face -y only",
            hint: "Stand in the cube and look at that face: what is on your right?",
            answer: |q| on(q, &[3], left_for_right),
        },
        Mistake {
            name: "has left and right exchanged on the face +z only",
            hint: "Stand in the cube and look at that face: what is on your right?",
            answer: |q| on(q, &[4], left_for_right),
        },
        Mistake {
            name: "has left and right exchanged on the face -z only",
            hint: "Stand in the cube and look at that face: what is on your right?",
            answer: |q| on(q, &[5], left_for_right),
        },
        Mistake {
            name: "has the ceiling +y turned by half a turn",
            hint: "Look at -z and raise your eyes to the ceiling: where on it does it meet the wall -z?",
            answer: |q| on(q, &[2], |p| left_for_right(top_for_bottom(p))),
        },
        Mistake {
            name: "has the floor -y turned by half a turn",
            hint: "Look at -z and lower your eyes to the floor: where on it does it meet the wall -z?",
            answer: |q| on(q, &[3], |p| left_for_right(top_for_bottom(p))),
        },
        Mistake {
            name: "has the ceiling and the floor upside down",
            hint: "Look at -z and raise or lower your eyes: at which edge of those faces do you arrive?",
            answer: |q| on(q, &[2, 3], top_for_bottom),
        },
        Mistake {
            name: "has left and right exchanged on the walls +x and -x",
            hint: "Stand in the cube and look at those walls: what is on your right?",
            answer: |q| on(q, &[0, 1], left_for_right),
        },
        Mistake {
            name: "has left and right exchanged on the walls +z and -z",
            hint: "Stand in the cube and look at those walls: what is on your right?",
            answer: |q| on(q, &[4, 5], left_for_right),
        },
        Mistake {
            name: "has left and right exchanged on the ceiling and the floor",
            hint: "Stand in the cube and look up and down: what is on your right?",
            answer: |q| on(q, &[2, 3], left_for_right),
        },
        Mistake {
            name: "exchanges u and v on the ceiling and the floor",
            hint: "Which of the direction's x and z goes to the right on the ceiling?",
            answer: |q| {
                on(q, &[2, 3], |p| CubePlace {
                    u: p.v,
                    v: p.u,
                    ..p
                })
            },
        },
        Mistake {
            name: "takes y for v on all faces, on the ceiling and the floor too",
            hint: "All of the ceiling has the same y after the division: which axis runs down on it?",
            answer: |q| {
                let p = Self::right(q);
                let v = match p.face {
                    2 => 0.0,
                    3 => 1.0,
                    _ => p.v,
                };
                CubePlace { v, ..p }
            },
        },
        Mistake {
            name: "takes x for u on all faces, on the walls +x and -x too",
            hint: "All of the wall +x has the same x after the division: which axis runs to the right on it?",
            answer: |q| {
                let p = Self::right(q);
                let u = match p.face {
                    0 => 1.0,
                    1 => 0.0,
                    _ => p.u,
                };
                CubePlace { u, ..p }
            },
        },
        Mistake {
            name: "gives the positive face of a pair, whatever the sign is",
            hint: "Which face does the direction (-1, 0, 0) point at?",
            answer: |q| {
                let p = Self::right(q);
                let face = p.face - p.face % 2;
                CubePlace { face, ..p }
            },
        },
        Mistake {
            name: "goes by x, whichever component is the largest",
            hint: "Which component of (0.1, 0.9, 0.2) decides?",
            answer: |q| on_axis(q, 0),
        },
        Mistake {
            name: "goes by y, whichever component is the largest",
            hint: "Which component of (0.9, 0.1, 0.2) decides?",
            answer: |q| on_axis(q, 1),
        },
        Mistake {
            name: "goes by z, whichever component is the largest",
            hint: "Which component of (0.9, 0.1, 0.2) decides?",
            answer: |q| on_axis(q, 2),
        },
        Mistake {
            name: "divides by |x| on all faces",
            hint: "By the length of what is the direction divided, so that it ends on the wall?",
            answer: |q| divided(q, 0),
        },
        Mistake {
            name: "divides by |y| on all faces",
            hint: "By the length of what is the direction divided, so that it ends on the wall?",
            answer: |q| divided(q, 1),
        },
        Mistake {
            name: "divides by |z| on all faces",
            hint: "By the length of what is the direction divided, so that it ends on the wall?",
            answer: |q| divided(q, 2),
        },
        Mistake {
            name: "exchanges the numbers of the faces of x with those of z",
            hint: "Which numbers have the faces +x and -x, and which +z and -z?",
            answer: |q| numbered(q, [4, 5, 2, 3, 0, 1]),
        },
        Mistake {
            name: "spreads the places on a face by the angle, not by its tangent",
            hint: "A cube has flat walls: half way from the middle of a face to its edge, is the angle half as large?",
            answer: |q| {
                let p = Self::right(q);
                let by_angle = |x: f32| 0.5 + (2.0 * x - 1.0).atan() / std::f32::consts::FRAC_PI_2;
                CubePlace {
                    u: by_angle(p.u),
                    v: by_angle(p.v),
                    ..p
                }
            },
        },
        Mistake {
            name: "has the ceiling +y turned by a quarter turn, clockwise",
            hint: "Look at -z and raise your eyes: at which edge of that face do you arrive?",
            answer: |q| on(q, &[2], clockwise),
        },
        Mistake {
            name: "has the ceiling +y turned by a quarter turn, counter-clockwise",
            hint: "Look at -z and raise your eyes: at which edge of that face do you arrive?",
            answer: |q| on(q, &[2], counter_clockwise),
        },
        Mistake {
            name: "has the floor -y turned by a quarter turn, clockwise",
            hint: "Look at -z and lower your eyes: at which edge of that face do you arrive?",
            answer: |q| on(q, &[3], clockwise),
        },
        Mistake {
            name: "has the floor -y turned by a quarter turn, counter-clockwise",
            hint: "Look at -z and lower your eyes: at which edge of that face do you arrive?",
            answer: |q| on(q, &[3], counter_clockwise),
        },
        Mistake {
            name: "exchanges the numbers of the faces of y with those of z",
            hint: "Which numbers have the faces +y and -y, and which +z and -z?",
            answer: |q| numbered(q, [0, 1, 4, 5, 2, 3]),
        },
        Mistake {
            name: "exchanges the numbers of the faces of x with those of y",
            hint: "Which numbers have the faces +x and -x, and which +y and -y?",
            answer: |q| numbered(q, [2, 3, 0, 1, 4, 5]),
        },
        Mistake {
            name: "has left and right exchanged on the walls -x and -z",
            hint: "Stand in the cube and look at those walls: what is on your right?",
            answer: |q| on(q, &[1, 5], left_for_right),
        },
        Mistake {
            name: "has left and right exchanged on the walls +x and +z",
            hint: "Stand in the cube and look at those walls: what is on your right?",
            answer: |q| on(q, &[0, 4], left_for_right),
        },
        Mistake {
            name: "has left and right exchanged on the four walls",
            hint: "Stand in the cube and look at those walls: what is on your right?",
            answer: |q| on(q, &[0, 1, 4, 5], left_for_right),
        },
        Mistake {
            name: "has the four walls upside down",
            hint: "v runs downwards: what is v on a wall for a direction a little above the horizon?",
            answer: |q| on(q, &[0, 1, 4, 5], top_for_bottom),
        },
        Mistake {
            name: "goes by OpenGL's table of cube maps, which shows the faces from outside",
            hint: "OpenGL looks at the cube from outside: where do you stand here?",
            answer: |q| {
                let p = on(q, &[2, 3], top_for_bottom);
                if matches!(p.face, 2 | 3) {
                    p
                } else {
                    left_for_right(p)
                }
            },
        },
        Mistake {
            name: "has the ceiling and the floor turned by a quarter turn, clockwise",
            hint: "Look at -z and raise or lower your eyes: at which edge of those faces do you arrive?",
            answer: |q| on(q, &[2, 3], clockwise),
        },
        Mistake {
            name: "has the ceiling and the floor turned by a quarter turn, counter-clockwise",
            hint: "Look at -z and raise or lower your eyes: at which edge of those faces do you arrive?",
            answer: |q| on(q, &[2, 3], counter_clockwise),
        },
    ];

    const PICTURES: &'static [Picture<Self>] = &[Picture {
        name: "direction_to_cube",
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
    }];
}
