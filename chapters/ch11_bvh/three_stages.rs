//! The three stages of building a tree, side by side: boxes, a tree, an array.

use super::flat_boxes::{LEVELS, Paper, bounds, height, tree, triangles};
use crate::kit::figure::{Figure, figure};
use crate::kit::palette::{BLUE, FAINT, INK};
use crate::kit::stage::Drawn;
use glam::{Vec2, vec2};
use plotters::prelude::{Circle, Color, PathElement, RGBColor, Rectangle, WHITE};
use raybook::accel::bvh::build::Method;
use raybook::inside::bvh::{Flat, Node};
use std::error::Error;

/// Where the triangles are, and how large.
const PLACES: [((f32, f32), f32); 7] = [
    ((0.6, 0.6), 0.42),
    ((1.5, 1.5), 0.46),
    ((0.5, 2.3), 0.34),
    ((3.9, 0.8), 0.48),
    ((4.9, 1.5), 0.38),
    ((4.2, 3.3), 0.52),
    ((2.2, 3.8), 0.40),
];

/// Pixels of the canvas per metre.
const SCALE: f32 = 105.0;

/// The figure.
///
/// # Errors
/// What plotters reports.
pub(super) fn draw() -> Figure {
    let triangles = triangles(&PLACES.map(|((x, y), size)| (vec2(x, y), size)), 5);
    let tree = tree(&triangles, Method::Sweep);
    figure(1120, 390, |canvas| {
        let paper = |left: f32| Paper {
            canvas,
            origin: vec2(left, 630.0),
            scale: SCALE,
        };
        let (boxes, nested, array) = (paper(60.0), paper(760.0), paper(1440.0));
        let title = vec2(2.7, 5.35);
        boxes.centred("1  boxes and their centres", title, 42, INK)?;
        nested.centred("2  a tree of boxes", title, 42, INK)?;
        array.centred("3  an array", vec2(3.5, title.y), 42, INK)?;
        for (number, triangle) in triangles.iter().enumerate() {
            let bounds = bounds(triangle);
            boxes.triangle(triangle)?;
            nested.triangle(triangle)?;
            boxes.outline(&bounds, 0.0, BLUE, 4)?;
            let center = bounds.center().truncate();
            disc(&boxes, center, 7, BLUE)?;
            let above = vec2(center.x, bounds.max.y + 0.22);
            boxes.centred(&letter(number), above, 36, INK)?;
        }
        if let Some(root) = &tree.root {
            nested.boxes(&tree, root, 0)?;
            Diagram {
                paper: &array,
                tree: &tree,
            }
            .draw(root)?;
        }
        Ok(())
    })
}

fn letter(number: usize) -> String {
    char::from(b'a' + number as u8).to_string()
}

fn disc(paper: &Paper, at: Vec2, radius: i32, colour: RGBColor) -> Drawn {
    let p = paper.origin + paper.scale * vec2(at.x, -at.y);
    let disc = Circle::new((p.x as i32, p.y as i32), radius, colour.filled());
    paper.canvas.draw(&disc)?;
    Ok(())
}

/// The tree as circles and lines, and below it as an array.
struct Diagram<'a, 'b, 'c> {
    paper: &'a Paper<'b, 'c>,
    tree: &'a Flat,
}

/// Distance between two leaves, and between two levels, in metres.
const APART: Vec2 = vec2(1.0, 0.88);

impl Diagram<'_, '_, '_> {
    fn draw(&self, root: &Node) -> Drawn {
        self.subtree(root, 0, 0, &mut 0)?;
        let text = |text: &str, y| self.paper.centred(text, vec2(3.5, y), 36, INK);
        text("nodes, depth-first; siblings lie side by side", -0.62)
    }

    /// Draws a subtree with this number in the array; `leaves` have been drawn to the left of it. Returns its place.
    fn subtree(
        &self,
        node: &Node,
        number: usize,
        level: usize,
        leaves: &mut usize,
    ) -> Result<Vec2, Box<dyn Error>> {
        let colour = LEVELS[level.min(LEVELS.len() - 1)];
        let y = 4.6 - APART.y * level as f32;
        let place = if node.link.count > 0 {
            *leaves += 1;
            vec2(APART.x * (*leaves as f32 - 0.5), y)
        } else {
            let first = 1 + 2 * node.link.first as usize;
            let [left, right] = self.tree.pairs[node.link.first as usize].nodes();
            let left = self.subtree(&left, first, level + 1, leaves)?;
            let right = self.subtree(&right, first + 1, level + 1, leaves)?;
            let place = vec2(0.5 * (left.x + right.x), y);
            self.line(place, left)?;
            self.line(place, right)?;
            place
        };
        disc(self.paper, place, 27, colour)?;
        disc(self.paper, place, 22, WHITE)?;
        self.paper.centred(&number.to_string(), place, 36, colour)?;
        let shape = self.tree.order.get(node.link.first as usize);
        let shape = shape.filter(|_| height(self.tree, node) == 0);
        let name = shape
            .map(|&shape| letter(shape as usize))
            .unwrap_or_default();
        self.paper
            .centred(&name, place - vec2(0.0, 0.45), 36, INK)?;
        self.cell(number, &name, colour)?;
        Ok(place)
    }

    fn line(&self, from: Vec2, to: Vec2) -> Drawn {
        let rim = 27.0 / SCALE * (to - from).normalize_or_zero();
        let ends = [from + rim, to - rim].map(|p| {
            let p = self.paper.origin + self.paper.scale * vec2(p.x, -p.y);
            (p.x as i32, p.y as i32)
        });
        let line = PathElement::new(ends.to_vec(), FAINT.stroke_width(5));
        self.paper.canvas.draw(&line)?;
        Ok(())
    }

    fn cell(&self, number: usize, name: &str, colour: RGBColor) -> Drawn {
        // A gap before each pair: a pair is one cache line.
        let left = 55.0 * number as f32 + 12.0 * number.div_ceil(2) as f32 - 66.0;
        let corner = self.paper.origin + vec2(left, -40.0);
        let (x, y) = (corner.x as i32, corner.y as i32);
        let corners = [(x, y), (x + 52, y + 64)];
        self.paper
            .canvas
            .draw(&Rectangle::new(corners, colour.mix(0.18).filled()))?;
        self.paper
            .canvas
            .draw(&Rectangle::new(corners, colour.stroke_width(3)))?;
        let middle = (corner + vec2(26.0, 18.0) - self.paper.origin) / self.paper.scale;
        let at = vec2(middle.x, -middle.y);
        self.paper.centred(&number.to_string(), at, 36, colour)?;
        self.paper.centred(name, at - vec2(0.0, 0.26), 36, INK)
    }
}
