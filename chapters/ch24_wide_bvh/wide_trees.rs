//! A binary tree and the wide one that is made of it, side by side.

use crate::kit::figure::{CENTRE, Canvas, Figure, figure, text, write};
use crate::kit::palette::{BLUE, FAINT, INK, ORANGE};
use crate::kit::stage::Drawn;
use plotters::prelude::{Circle, Color, PathElement, Rectangle, WHITE};
use raybook::accel::bvh::build::Method;
use raybook::inside::bvh::{COST, Cost, Node, build};
use raybook::inside::wide_bvh::{binary, children, collapse};
use raybook::scene::soup::soup;
use raybook::shape::Shape;
use std::collections::BTreeMap;
use std::error::Error;

/// Leaves of the tree.
const LEAVES: u32 = 40;

/// The canvas, in its pixels, and where on it a tree is.
const WIDTH: u32 = 1920;
const HEIGHT: u32 = 1500;
const TOP: [i32; 2] = [190, 1040];
const STEP: [i32; 2] = [82, 130];

/// Above, the binary tree, with blue branches where a branch stays; below, the wide tree that is made of it.
///
/// # Errors
/// If plotters cannot draw.
pub(super) fn draw() -> Figure {
    let boxes: Vec<_> = soup(LEAVES, 6).facets().iter().map(Shape::bounds).collect();
    let nodes = binary(&build(&boxes, Method::Sweep, &Cost { most: 1, ..COST }));
    let families = collapse(&nodes);
    let wide: BTreeMap<_, _> = families
        .into_iter()
        .map(|f| (f.branch, f.children))
        .collect();
    let pairs = |i: u32| match nodes[i as usize].link.count {
        0 => children(&nodes[i as usize]).to_vec(),
        _ => Vec::new(),
    };
    let eight = |i: u32| wide.get(&i).cloned().unwrap_or_default();
    figure(WIDTH / 2, HEIGHT / 2, |canvas| {
        for (tree, below) in [&pairs as &dyn Fn(u32) -> Vec<u32>, &eight]
            .into_iter()
            .enumerate()
        {
            let mut picture = Picture {
                canvas,
                nodes: &nodes,
                stays: &|i| wide.contains_key(&i),
                below,
                top: TOP[tree],
                step: STEP[tree],
                leaves: 0,
            };
            picture.node(0, 0)?;
        }
        let opened = nodes.len() - LEAVES as usize - wide.len();
        let titles = [
            format!(
                "two children: {} branches above {LEAVES} leaves; {opened} of them give way",
                LEAVES - 1
            ),
            format!("up to eight children: {} branches stay", wide.len()),
        ];
        for (title, top) in titles.iter().zip(TOP) {
            let above = (WIDTH as i32 / 2, top - 110);
            write(canvas, title, above, text(46).pos(CENTRE))?;
        }
        Ok(())
    })
}

struct Picture<'a, 'b> {
    canvas: &'a Canvas<'b>,
    nodes: &'a [Node],
    stays: &'a dyn Fn(u32) -> bool,
    below: &'a dyn Fn(u32) -> Vec<u32>,
    top: i32,
    step: i32,
    /// How many leaves are drawn.
    leaves: i32,
}

impl Picture<'_, '_> {
    /// Draws everything below a node, and then the node; returns the place of the node.
    fn node(&mut self, i: u32, depth: i32) -> Result<(i32, i32), Box<dyn Error>> {
        let y = self.top + depth * self.step;
        if self.nodes[i as usize].link.count > 0 {
            let x = 60 + self.leaves * (WIDTH as i32 - 120) / (LEAVES as i32 - 1);
            self.leaves += 1;
            let corners = [(x - 13, y - 13), (x + 13, y + 13)];
            self.canvas
                .draw(&Rectangle::new(corners, ORANGE.filled()))?;
            return Ok((x, y));
        }
        let below: Result<Vec<_>, _> = (self.below)(i)
            .into_iter()
            .map(|child| self.node(child, depth + 1))
            .collect();
        let below = below?;
        let x = below.iter().map(|p| p.0).sum::<i32>() / below.len().max(1) as i32;
        for place in below {
            let line = vec![(x, y + 20), (place.0, place.1 - 14)];
            self.canvas
                .draw(&PathElement::new(line, INK.mix(0.45).stroke_width(3)))?;
        }
        self.branch(i, (x, y))?;
        Ok((x, y))
    }

    fn branch(&self, i: u32, at: (i32, i32)) -> Drawn {
        let (fill, rim) = if (self.stays)(i) {
            (BLUE, BLUE)
        } else {
            (WHITE, FAINT)
        };
        self.canvas.draw(&Circle::new(at, 20, fill.filled()))?;
        self.canvas
            .draw(&Circle::new(at, 20, rim.stroke_width(5)))?;
        Ok(())
    }
}
