//! The shadow of a board under a light, from the side: where the umbra and the penumbra are, and what is measured there.

use crate::kit::axis::Axis;
use crate::kit::chart::Chart;
use crate::kit::figure::{CENTRE, Canvas, Figure, figure};
use crate::kit::palette::{BLUE, FAINT, INK, ORANGE, VERMILION};
use crate::kit::stage::Drawn;
use glam::{Vec2, Vec3, vec3};
use plotters::prelude::Color;
use raybook::image::rgb::Rgb;
use raybook::light::rect_light::RectLight;
use raybook::math::dir3::Dir3;
use raybook::math::pcg;
use raybook::render::soft_shadow::visible_fraction;
use raybook::scene::world::{Scene, Thing};
use raybook::shape::Surface;
use raybook::shape::cuboid::Cuboid;

/// A board below a light, both level and with their middles above the origin; very long in the third dimension.
#[derive(Clone, Copy, Debug)]
pub struct Shadow {
    /// The light's width and its height above the floor, in metres.
    pub light: Vec2,
    /// The board's width and its height above the floor, in metres.
    pub board: Vec2,
}

impl Shadow {
    /// The x at which the umbra ends, and the x at which the penumbra ends. Both are on lines past an end of the board: from the
    /// end of the light on the same side, which is seen first, and from the end on the other side, which is seen last. With light
    /// and board w and b wide, H and h high, similar triangles give (b H ∓ w h)/(2 (H − h)). If the first x is negative, there is
    /// no umbra.
    pub fn ends(&self) -> [f32; 2] {
        let (light, board) = (self.light, self.board);
        [-1.0, 1.0].map(|sign| {
            (board.x * light.y + sign * light.x * board.y) / (2.0 * (light.y - board.y))
        })
    }

    /// The fraction of the light that is seen from x on the floor, estimated by random samples.
    pub fn seen_from(&self, x: f32, samples: u32) -> f32 {
        /// Half the length of light and board: so long that their ends hardly matter in the middle.
        const LONG: f32 = 50.0;
        let corner = vec3(-0.5 * self.light.x, self.light.y, -0.01 * LONG);
        let (across, along) = (self.light.x * Vec3::X, 0.02 * LONG * Vec3::Z);
        let light = RectLight::new(corner, across, along, Rgb::WHITE);
        let half = vec3(0.5 * self.board.x, 0.0, LONG);
        let board = Cuboid::between(self.board.y * Vec3::Y - half, self.board.y * Vec3::Y + half);
        let thing = Thing::new(board, ());
        let floor = Surface::flat(x * Vec3::X, 0.0, Dir3::Y);
        let rng = &mut pcg::stream(16, u64::from(x.to_bits()));
        visible_fraction(
            &Scene::new(vec![thing], vec![]),
            &floor,
            &light,
            samples,
            rng,
        )
    }
}

/// The side view, and below it the fraction of the light that is seen along the floor.
///
/// # Errors
/// If plotters cannot draw.
pub fn diagram() -> Figure {
    let shadow = Shadow {
        light: Vec2::new(1.6, 3.0),
        board: Vec2::new(2.0, 1.2),
    };
    figure(900, 640, |canvas| {
        let (above, below) = canvas.split_vertically(740);
        side_view(&above, &shadow)?;
        profile(&below, &shadow)
    })
}

/// How much of the floor is drawn, in metres to either side.
const REACH: f32 = 3.2;

/// Space to the left of both charts, in pixels of the canvas.
const BESIDE: u32 = 150;

fn side_view(canvas: &Canvas, shadow: &Shadow) -> Drawn {
    let across = Axis::linear(-REACH..REACH).hidden();
    let up = Axis::linear(-0.3_f32..3.4).hidden();
    let mut chart = Chart::new(across, up).left(BESIDE);
    let (light, board) = (shadow.light, shadow.board);
    let [umbra, penumbra] = shadow.ends();
    for (from, to, colour) in [
        (-umbra, umbra, INK),
        (umbra, penumbra, ORANGE),
        (-penumbra, -umbra, ORANGE),
    ] {
        chart.bar([(from, -0.12), (to, 0.0)], colour.filled());
    }
    for side in [-1.0, 1.0] {
        for (end, floor_end, colour) in [(0.5, umbra, INK), (-0.5, penumbra, ORANGE)] {
            let from = (side * end * light.x, light.y);
            chart.line([from, (side * floor_end, 0.0)], colour.stroke_width(3));
        }
    }
    chart.line([(-REACH, 0.0), (REACH, 0.0)], FAINT.stroke_width(4));
    for (size, thick, colour) in [(light, 0.1, VERMILION), (board, 0.08, BLUE)] {
        let (x, y) = (0.5 * size.x, size.y);
        chart.bar([(-x, y), (x, y + thick)], colour.filled());
    }
    let middle = 0.5 * (umbra + penumbra);
    for (name, at, colour) in [
        ("light", (0.0, light.y + 0.25), VERMILION),
        ("board", (0.0, board.y + 0.24), BLUE),
        ("umbra", (0.0, -0.24), INK),
        ("penumbra", (middle, -0.24), INK),
        ("penumbra", (-middle, -0.24), INK),
    ] {
        chart.label(CENTRE, at, name, colour);
    }
    chart.draw(canvas)
}

fn profile(canvas: &Canvas, shadow: &Shadow) -> Drawn {
    /// For each point of the floor, and how far the points are apart, in metres.
    const SAMPLES: u32 = 2000;
    const STEP: f32 = 0.02;
    let places = Axis::linear(-REACH..REACH)
        .named("place on the floor, in metres")
        .format(|x| format!("{x:.0}").replace('-', "−"));
    let shares = Axis::linear(0.0_f32..1.05)
        .named("light that is seen")
        .labels(5)
        .format(|share| format!("{:.0} %", 100.0 * share));
    let mut chart = Chart::new(places, shares).text(38).left(BESIDE);
    for end in shadow.ends() {
        for x in [-end, end] {
            chart.line([(x, 0.0), (x, 1.05)], ORANGE.stroke_width(4));
        }
    }
    let steps = (REACH / STEP) as i32;
    let measured = (-steps..=steps).map(|i| {
        let x = i as f32 * STEP;
        (x, shadow.seen_from(x, SAMPLES))
    });
    chart.line(measured, BLUE.stroke_width(4));
    chart.draw(canvas)
}
