//! The sphere of directions and its map, side by side: the letters of the lessons on environments and on panoramas.

use crate::kit::figure::{Canvas, Figure, LEFT, RIGHT, figure};
use crate::kit::palette::{BLUE, FAINT, GREEN, INK, VERMILION};
use crate::kit::sketch::{Sketch, on_plane, xy};
use crate::kit::stage::Drawn;
use glam::{Vec2, Vec3, vec2, vec3};
use raybook::camera::pinhole::Pinhole;
use raybook::light::environment::latlong;
use raybook::math::dir3::Dir3;
use std::error::Error;
use std::f32::consts::{FRAC_PI_2, PI, TAU};

/// The angles θ from +y and φ from −z of the direction that is drawn.
const DIRECTION: [f32; 2] = [0.85, 0.6];

/// Width and height of the figure in pixels.
const SIZE: (u32, u32) = (800, 350);

/// Height of what is seen; the sphere has the radius 1.
const HEIGHT: f32 = 3.1;

/// The corner of the map at its upper left, and its height, which is half of its width; both on the plane of the page.
const MAP: (Vec3, f32) = (xy(0.95, 0.75), 1.6);

/// What the lesson calls the axes +y, −z and +x.
pub type Names = [&'static str; 3];

/// Draws the sphere of directions with an axis of each name at the left, and the map at the right, on which `draw` draws more: it is given the
/// place on the page of a place of the map, and the place of the direction that is drawn.
///
/// # Errors
/// If plotters cannot draw.
pub fn directions(
    names: Names,
    draw: impl Fn(&Sketch, &dyn Fn(Vec2) -> Vec3, Vec2) -> Drawn,
) -> Figure {
    let [theta, phi] = DIRECTION;
    let d = to(theta, phi);
    figure(SIZE.0, SIZE.1, |canvas| {
        sphere(&far_away(canvas)?, names, d)?;
        let page = on_plane(canvas, xy(1.6, 0.0), HEIGHT)?;
        let (corner, high) = MAP;
        let at = |place: Vec2| corner + high * xy(2.0 * place.x, -place.y);
        let corners = [vec2(0.0, 0.0), Vec2::X, Vec2::ONE, Vec2::Y, Vec2::ZERO].map(at);
        page.line(&corners, INK, 4)?;
        let above = xy(0.0, 0.14);
        page.arrow(at(Vec2::ZERO) + above, at(vec2(0.25, 0.0)) + above, INK, 3)?;
        page.label(at(vec2(0.12, 0.0)) + above, vec2(0.0, -28.0), "u", INK)?;
        let beside = xy(-0.14, 0.0);
        page.arrow(at(Vec2::ZERO) + beside, at(vec2(0.0, 0.4)) + beside, INK, 3)?;
        page.words(
            at(vec2(0.0, 0.2)) + beside,
            vec2(-12.0, 0.0),
            "v",
            INK,
            RIGHT,
        )?;
        draw(&page, &at, latlong::place(Dir3::new_or(d, Dir3::Y)))
    })
}

/// The direction at the angle θ from +y and φ from −z towards +x.
fn to(theta: f32, phi: f32) -> Vec3 {
    vec3(
        theta.sin() * phi.sin(),
        theta.cos(),
        -theta.sin() * phi.cos(),
    )
}

/// A view of the sphere from so far away that parallel lines stay parallel, with the sphere at the left of the canvas.
fn far_away<'a, 'b>(canvas: &'a Canvas<'b>) -> Result<Sketch<'a, 'b>, Box<dyn Error>> {
    /// Where the viewer is, and by how much the view is moved to the right, both in radii of the sphere.
    const FROM: Vec3 = vec3(80.0, 32.0, -22.0);
    const MOVED: f32 = 2.3;
    let aspect = SIZE.0 as f32 / SIZE.1 as f32;
    let viewer = Pinhole::look_at(FROM, Vec3::ZERO, Vec3::Y, FROM.length(), aspect)?;
    let viewer = Pinhole {
        focal_point: viewer.focal_point + MOVED * *viewer.right,
        plane: HEIGHT * vec2(aspect, 1.0),
        ..viewer
    };
    Ok(Sketch { canvas, viewer })
}

/// The sphere, its three axes, the direction and its two angles.
fn sphere(sketch: &Sketch, [up, ahead, right]: Names, d: Vec3) -> Drawn {
    let [theta, phi] = DIRECTION;
    let circle = |point: &dyn Fn(f32) -> Vec3, to: f32| -> Vec<Vec3> {
        (0..=60).map(|i| point(to * i as f32 / 60.0)).collect()
    };
    sketch.disc(Vec3::ZERO, 1.0, BLUE, 0.1)?;
    sketch.line(&circle(&|angle| self::to(FRAC_PI_2, angle), TAU), FAINT, 3)?;
    sketch.line(&circle(&|angle| self::to(angle, phi), PI), FAINT, 3)?;
    let foot = d.with_y(0.0);
    sketch.dashes(Vec3::ZERO, foot, INK, 2)?;
    sketch.dashes(foot, d, INK, 2)?;
    for (axis, name, beside) in [
        (Vec3::Y, up, vec2(0.0, -30.0)),
        (Vec3::NEG_Z, ahead, vec2(10.0, 36.0)),
        (Vec3::X, right, vec2(-10.0, 34.0)),
    ] {
        sketch.arrow(Vec3::ZERO, 1.2 * axis, INK, 4)?;
        sketch.label(1.2 * axis, beside, name, INK)?;
    }
    sketch.line(
        &circle(&|angle| 0.45 * self::to(angle, phi), theta),
        GREEN,
        5,
    )?;
    sketch.label(
        0.45 * self::to(0.5 * theta, phi),
        vec2(16.0, -28.0),
        "θ",
        GREEN,
    )?;
    sketch.line(
        &circle(&|angle| 0.6 * self::to(FRAC_PI_2, angle), phi),
        BLUE,
        5,
    )?;
    sketch.label(
        0.6 * self::to(FRAC_PI_2, 0.5 * phi),
        vec2(6.0, 34.0),
        "φ",
        BLUE,
    )?;
    sketch.arrow(Vec3::ZERO, d, VERMILION, 8)?;
    sketch.words(d, vec2(16.0, -18.0), "d", VERMILION, LEFT)
}
