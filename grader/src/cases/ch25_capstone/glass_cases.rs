//! What is asked of `trace`: mirrors and glass, one difficulty at a time.

use super::things::{AHEAD, RED, SIDE, ask, ball, edge, from, glass, lamp, mirror, shiny, wall};
use crate::Edge;
use raybook::math::dir3::Dir3;
use raybook::scene::description::{Matter, Object};
use raybook_workbook::exercises::ch25_capstone::Trace;
use glam::{Vec3, vec3};

/// Mirrors, and where the depth ends.
pub fn mirrors() -> Vec<Edge<Trace>> {
    let between = |depth| {
        let facing = vec![
            Object::plane(Dir3::X, -1.0, mirror()),
            Object::plane(-Dir3::X, -1.0, mirror()),
            wall(),
        ];
        let lamps = [lamp(0.0, 0.5, 2.0, 20.0)];
        from(
            vec3(0.1, 0.0, 4.0),
            ask(depth, vec3(1.0, 0.1, -1.1), &lamps, facing),
        )
    };
    let to_mirror = vec3(0.5, 0.1, -1.0);
    [
        (
            "a mirror shows the backdrop",
            ask(2, AHEAD, &[SIDE], vec![ball(0.0, 0.0, 0.0, mirror())]),
        ),
        (
            "a mirror shows a ball",
            ask(
                2,
                to_mirror,
                &[lamp(0.5, 4.0, 4.0, 60.0)],
                vec![
                    Object::plane(-Dir3::X, -1.5, mirror()),
                    ball(-0.7, 0.8, -1.5, shiny(RED)),
                ],
            ),
        ),
        (
            "a mirror has nothing to show at depth 1",
            ask(1, AHEAD, &[SIDE], vec![ball(0.0, 0.0, 0.0, mirror())]),
        ),
        (
            "mirror, mirror, mirror and wall: four surfaces, just enough",
            between(4),
        ),
        ("the same with one surface less", between(3)),
        (
            "a mirror seen from behind is a mirror too",
            ask(
                3,
                vec3(0.2, 0.5, -1.0),
                &[SIDE],
                vec![
                    Object::plane(Dir3::Y, 1.5, mirror()),
                    ball(1.0, -1.5, -2.0, shiny(RED)),
                ],
            ),
        ),
    ]
    .map(edge)
    .into()
}

/// Glass, from outside and from inside.
pub fn refracting() -> Vec<Edge<Trace>> {
    let water = || {
        vec![
            Object::plane(Dir3::Y, 0.0, glass()),
            ball(4.0, -2.0, 0.0, shiny(RED)),
        ]
    };
    let below = vec3(0.0, -2.0, 0.3);
    [
        (
            "straight through the middle of glass",
            ask(
                3,
                Vec3::NEG_Z,
                &[SIDE],
                vec![ball(0.0, 0.0, 0.0, glass()), wall()],
            ),
        ),
        (
            "aslant through glass",
            ask(
                4,
                AHEAD,
                &[SIDE],
                vec![ball(0.0, 0.0, 0.0, glass()), wall()],
            ),
        ),
        (
            "far out on a ball of glass, where it mirrors much",
            ask(
                5,
                vec3(0.19, 0.0, -1.0),
                &[SIDE],
                vec![ball(0.0, 0.0, 0.0, glass()), wall()],
            ),
        ),
        (
            "from below water, steeply: out and back",
            from(below, ask(3, vec3(0.3, 1.0, -0.2), &[SIDE], water())),
        ),
        (
            "from below water, flatly: totally reflected",
            from(
                below,
                ask(
                    3,
                    vec3(1.0, 0.5, -0.1),
                    &[lamp(2.0, -1.0, 3.0, 30.0)],
                    water(),
                ),
            ),
        ),
        (
            "a bubble in glass",
            ask(
                6,
                vec3(0.05, 0.1, -1.0),
                &[SIDE],
                vec![
                    ball(0.0, 0.0, 0.0, glass()),
                    Object::sphere(Vec3::ZERO, 0.7, Matter::glass(0.6667)),
                    wall(),
                ],
            ),
        ),
        (
            "through a plate of glass into a mirror, and back",
            ask(
                6,
                vec3(0.02, 0.06, -1.0),
                &[SIDE],
                vec![
                    Object::plane(Dir3::Z, 1.0, glass()),
                    Object::plane(Dir3::Z, 0.5, Matter::glass(0.6667)),
                    ball(0.0, 0.0, -2.0, mirror()),
                ],
            ),
        ),
    ]
    .map(edge)
    .into()
}
