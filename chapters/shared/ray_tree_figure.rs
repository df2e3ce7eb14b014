//! The figure of a tree of rays: in the scene, and as a tree.

use crate::kit::figure::{Canvas, SCALE, figure};
use crate::kit::palette::{BLUE, FAINT, INK, ORANGE, PURPLE, VERMILION};
use crate::kit::sheet::Sheet;
use crate::kit::sketch::{Sketch, label};
use crate::kit::stage::Drawn;
use crate::shared::ray_tree::{Branch, End, Kind};
use glam::{Vec2, Vec3, vec2, vec3};
use plotters::prelude::{Circle, Color, PathElement, RGBColor};
use raybook::camera::pinhole::{LookAtError, Pinhole};
use raybook::image::{Image, rgb::Rgb, tone};
use std::error::Error;

/// Width and height of the photograph on which the rays are drawn, in pixels of the figure.
pub const PHOTOGRAPH: (usize, usize) = (560, 520);

/// Width of the tree beside it, in pixels of the figure.
const TREE: u32 = 420;

/// Free space at the right of the tree, for the name of the last line, in pixels of the canvas.
const MARGIN: f32 = 120.0;

/// Drawn length of a ray that goes on for ever, and of the camera ray, in metres.
const SHOWN: f32 = 1.6;

/// A camera above and at the left of the marbles, for which the balls hide little of each other.
///
/// # Errors
/// If there is no such camera.
pub fn above(aspect: f32) -> Result<Pinhole, LookAtError> {
    let (from, to) = (vec3(-2.6, 4.8, 6.0), vec3(-0.35, 0.45, 0.9));
    Pinhole::look_at(from, to, Vec3::Y, 0.038, aspect)
}

/// Draws the rays on a photograph that `viewer` took of their scene, and beside it the tree.
///
/// # Errors
/// What plotters reports.
pub fn draw(tree: &Branch, photograph: &Image, viewer: Pinhole) -> Sheet {
    let (width, height) = PHOTOGRAPH;
    let figure = figure(width as u32 + TREE, height as u32, |canvas| {
        let (left, right) = canvas.split_horizontally(SCALE * width as u32);
        background(&left, photograph)?;
        let sketch = Sketch {
            canvas: &left,
            viewer,
        };
        rays(&sketch, tree)?;
        numbers(&sketch, tree, &mut 0)?;
        let levels = depth(tree) as f32;
        let layout = Layout {
            canvas: &right,
            across: (2.0 * TREE as f32 - MARGIN) / leaves(tree) as f32,
            down: (2.0 * height as f32 - 200.0) / levels,
        };
        layout.branch(tree, (0.0, 0), None, &mut 0).map(|_| ())
    })?;
    Ok(figure.pixels) // there is a photograph in it
}

/// The colour of a kind of ray, and its name; a ray to a light is named at its end.
fn style(branch: &Branch) -> (RGBColor, &'static str) {
    match (branch.kind, branch.end) {
        (Kind::Camera, _) => (INK, "camera ray"),
        (Kind::Reflected, _) => (VERMILION, "reflected"),
        (Kind::Refracted, _) => (BLUE, "refracted"),
        (Kind::Light, End::Shadow) => (PURPLE, ""),
        (Kind::Light, _) => (ORANGE, ""),
    }
}

fn depth(branch: &Branch) -> usize {
    1 + branch.asks.iter().map(depth).max().unwrap_or(0)
}

fn leaves(branch: &Branch) -> usize {
    branch.asks.iter().map(leaves).sum::<usize>().max(1)
}

/// The photograph, paled, so that lines stand out.
fn background(canvas: &Canvas, photograph: &Image) -> Drawn {
    for y in 0..photograph.height() * SCALE as usize {
        for x in 0..photograph.width() * SCALE as usize {
            let colour = photograph.at(x / SCALE as usize, y / SCALE as usize);
            let pale = tone::clamp(colour).lerp(Rgb::WHITE, 0.35);
            canvas.draw_pixel((x as i32, y as i32), &display(pale))?;
        }
    }
    Ok(())
}

fn rays(sketch: &Sketch, branch: &Branch) -> Drawn {
    let (colour, _) = style(branch);
    let to = branch.from + branch.distance.min(SHOWN) * branch.direction;
    match branch.kind {
        Kind::Camera => {
            let to = branch.from + branch.distance * branch.direction;
            sketch.arrow(to - 2.0 * SHOWN * branch.direction, to, colour, 6)?;
        }
        Kind::Light => sketch.dashes(branch.from, to, colour, 5)?,
        _ if branch.distance.is_finite() => {
            let to = branch.from + branch.distance * branch.direction;
            sketch.arrow(branch.from, to, colour, 6)?;
        }
        _ => sketch.arrow(branch.from, to, colour, 6)?,
    }
    branch
        .asks
        .iter()
        .try_for_each(|branch| rays(sketch, branch))
}

/// A number at each surface, in the order in which they are met.
fn numbers(sketch: &Sketch, branch: &Branch, count: &mut u32) -> Drawn {
    if branch.end == End::Surface {
        *count += 1;
        let place = branch.from + branch.distance * branch.direction;
        sketch.dot(place, 9, INK)?;
        sketch.label(place, vec2(-32.0, 30.0), &count.to_string(), INK)?;
    }
    branch
        .asks
        .iter()
        .try_for_each(|branch| numbers(sketch, branch, count))
}

/// Where the nodes of the tree go.
struct Layout<'a, 'b> {
    canvas: &'a Canvas<'b>,
    /// From leaf to leaf, and from level to level, in pixels of the canvas.
    across: f32,
    down: f32,
}

impl Layout<'_, '_> {
    /// Draws everything below a node, then the node over the lines; returns the place of the node.
    fn branch(
        &self,
        branch: &Branch,
        (first_leaf, level): (f32, usize),
        above: Option<Vec2>,
        count: &mut u32,
    ) -> Result<Vec2, Box<dyn Error>> {
        let place = self.place(first_leaf + 0.5 * leaves(branch) as f32, level);
        let (colour, name) = style(branch);
        let from = above.unwrap_or(place - vec2(0.0, 90.0));
        let line = vec![pixel(from), pixel(place)];
        self.canvas
            .draw(&PathElement::new(line, colour.stroke_width(6)))?;
        let number = branch.end == End::Surface;
        *count += u32::from(number);
        let title = match branch.end {
            End::Surface => count.to_string(),
            End::Backdrop => "sky".to_owned(),
            End::Limit => "limit".to_owned(),
            End::Light => "light".to_owned(),
            End::Shadow => "shadow".to_owned(),
        };
        let mut leaf = first_leaf;
        for below in &branch.asks {
            self.branch(below, (leaf, level + 1), Some(place), count)?;
            leaf += leaves(below) as f32;
        }
        // Beside the line, on the side to which it leans.
        let aside = if place.x > from.x + 1.0 {
            105.0
        } else {
            -105.0
        };
        let beside_line = from.lerp(place, 0.5) + vec2(aside, 0.0);
        label(self.canvas, beside_line, name, colour)?;
        self.canvas.draw(&Circle::new(
            pixel(place),
            30,
            display(branch.sees).filled(),
        ))?;
        self.canvas
            .draw(&Circle::new(pixel(place), 30, FAINT.stroke_width(4)))?;
        let beside = if branch.end == End::Surface {
            vec2(-58.0, 0.0)
        } else {
            vec2(0.0, 58.0)
        };
        label(self.canvas, place + beside, &title, INK)?;
        Ok(place)
    }

    fn place(&self, leaf: f32, level: usize) -> Vec2 {
        vec2(self.across * leaf, 130.0 + self.down * level as f32)
    }
}

/// A radiance as a display shows it.
fn display(radiance: Rgb) -> RGBColor {
    let [r, g, b] = radiance.channels().map(tone::to_byte);
    RGBColor(r, g, b)
}

fn pixel(place: Vec2) -> (i32, i32) {
    (place.x as i32, place.y as i32)
}
