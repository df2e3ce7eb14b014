//! What is asked of `trace`: lamps, shadows and Phong's material, one difficulty at a time.

use super::things::{AHEAD, BLUE, RED, SIDE, ask, ball, edge, glass, lamp, shiny, wall};
use crate::Edge;
use raybook::math::dir3::Dir3;
use raybook::scene::description::Object;
use raybook_workbook::exercises::ch25_capstone::Trace;
use glam::vec3;

/// The backdrop, and a ball in all lights.
pub fn lamps() -> Vec<Edge<Trace>> {
    let red_ball = || vec![ball(0.0, 0.0, 0.0, shiny(RED))];
    [
        (
            "only the backdrop",
            ask(3, vec3(0.3, 0.6, -1.0), &[SIDE], vec![]),
        ),
        (
            "no surface may be met at all",
            ask(0, AHEAD, &[SIDE], red_ball()),
        ),
        ("ambient light alone", ask(1, AHEAD, &[], red_ball())),
        ("one lamp, aslant", ask(1, AHEAD, &[SIDE], red_ball())),
        (
            "in the highlight",
            ask(1, AHEAD, &[lamp(2.5, 3.8, -0.4, 60.0)], red_ball()),
        ),
        (
            "the lamp is behind the ball",
            ask(1, AHEAD, &[lamp(-1.0, 2.0, -4.0, 60.0)], red_ball()),
        ),
        (
            "two lamps",
            ask(1, AHEAD, &[SIDE, lamp(-1.5, 1.0, 5.0, 40.0)], red_ball()),
        ),
        (
            "brighter than 1",
            ask(1, AHEAD, &[lamp(1.0, 1.5, 4.0, 700.0)], red_ball()),
        ),
        (
            "of two balls the nearer, which comes second",
            ask(
                1,
                AHEAD,
                &[SIDE],
                vec![
                    ball(0.4, 0.4, -3.0, shiny(BLUE)),
                    ball(0.0, 0.0, 0.0, shiny(RED)),
                ],
            ),
        ),
    ]
    .map(edge)
    .into()
}

/// Shadows, and both sides of what is flat.
pub fn shadows_and_sides() -> Vec<Edge<Trace>> {
    let sail = [
        vec3(-2.0, -1.5, 0.0),
        vec3(2.0, -1.0, 0.5),
        vec3(0.2, 2.5, -0.5),
    ];
    [
        (
            "in the shadow of a ball",
            ask(
                1,
                AHEAD,
                &[SIDE],
                vec![wall(), Object::sphere(vec3(1.8, 2.2, 0.5), 0.9, shiny(RED))],
            ),
        ),
        (
            "in the shadow of a ball of glass",
            ask(
                1,
                AHEAD,
                &[SIDE],
                vec![wall(), Object::sphere(vec3(1.8, 2.2, 0.5), 0.9, glass())],
            ),
        ),
        (
            "what is beyond the lamp throws no shadow",
            ask(
                1,
                AHEAD,
                &[lamp(1.0, 1.4, 0.0, 30.0)],
                vec![wall(), ball(2.3, 2.8, 2.8, shiny(RED))],
            ),
        ),
        (
            "a triangle from its front",
            ask(1, AHEAD, &[SIDE], vec![Object::triangle(sail, shiny(RED))]),
        ),
        (
            "a triangle from behind",
            ask(
                1,
                AHEAD,
                &[SIDE],
                vec![Object::triangle([sail[1], sail[0], sail[2]], shiny(RED))],
            ),
        ),
        (
            "beyond a triangle's side, in the other half of the parallelogram",
            ask(
                1,
                vec3(2.34, 1.65, -5.0),
                &[SIDE],
                vec![Object::triangle(sail, shiny(RED)), wall()],
            ),
        ),
        (
            "beside the triangle, in its plane",
            ask(
                1,
                vec3(-0.4, 0.3, -1.0),
                &[SIDE],
                vec![Object::triangle(sail, shiny(RED)), wall()],
            ),
        ),
        (
            "a plane from below, the lamp below too",
            ask(
                1,
                vec3(0.2, 0.5, -1.0),
                &[lamp(2.0, -1.0, 4.0, 60.0)],
                vec![Object::plane(Dir3::Y, 1.5, shiny(RED))],
            ),
        ),
        (
            "a plane from below, the lamp above it",
            ask(
                1,
                vec3(0.2, 0.5, -1.0),
                &[lamp(0.0, 4.0, 2.0, 60.0)],
                vec![Object::plane(Dir3::Y, 1.5, shiny(RED))],
            ),
        ),
    ]
    .map(edge)
    .into()
}
