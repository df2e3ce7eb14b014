//! Triangles in the plane, and the boxes of a tree around them: a tree that can be seen whole. (Cells in the plane, and a ray
//! through them, are in `flatland.rs`.)

use crate::kit::figure::{CENTRE, Canvas, Figure, coloured, figure, write};
use crate::kit::palette::{BLUE, FAINT, GREEN, INK, ORANGE, PURPLE, VERMILION};
use crate::kit::stage::Drawn;
use glam::{Vec2, vec2};
use plotters::prelude::{Color, Polygon, RGBColor, Rectangle};
use rand::RngExt;
use raybook::accel::bvh::build::Method;
use raybook::inside::bvh::{COST, Cost, Flat, Node, build, sah_cost};
use raybook::math::{aabb::Aabb, pcg};

/// The boxes reach far enough above and below the paper that only their outlines on it count: a ray in the paper meets a
/// rectangle in proportion to its perimeter.
const HIGH: f32 = 1000.0;

/// Colours of the levels of a tree, from the root down.
pub(super) const LEVELS: [RGBColor; 6] = [INK, BLUE, VERMILION, GREEN, PURPLE, ORANGE];

/// Triangles around places, each with the given size; always the same ones.
pub(super) fn triangles(places: &[(Vec2, f32)], seed: u64) -> Vec<[Vec2; 3]> {
    let mut rng = pcg::stream(seed, 0);
    let mut triangle = |&(at, size): &(Vec2, f32)| {
        let turn = rng.random::<f32>() * 2.1;
        [0.0, 2.0, 4.2].map(|angle| {
            at + size * (0.8 + 0.4 * rng.random::<f32>()) * Vec2::from_angle(turn + angle)
        })
    };
    places.iter().map(&mut triangle).collect()
}

/// The box of a triangle.
pub(super) fn bounds(triangle: &[Vec2; 3]) -> Aabb {
    Aabb::of(
        [-HIGH, HIGH]
            .into_iter()
            .flat_map(|z| triangle.map(|p| p.extend(z))),
    )
}

/// A tree over triangles with one in each leaf.
pub(super) fn tree(triangles: &[[Vec2; 3]], method: Method) -> Flat {
    let boxes: Vec<_> = triangles.iter().map(bounds).collect();
    build(&boxes, method, &Cost { most: 1, ..COST })
}

/// Paper, and where on the canvas it lies.
pub(super) struct Paper<'a, 'b> {
    /// What is drawn on.
    pub canvas: &'a Canvas<'b>,
    /// The pixel of the origin: x goes right from there, and y up.
    pub origin: Vec2,
    /// Pixels per metre.
    pub scale: f32,
}

impl Paper<'_, '_> {
    fn pixel(&self, p: Vec2) -> (i32, i32) {
        let p = self.origin + self.scale * vec2(p.x, -p.y);
        (p.x.round() as i32, p.y.round() as i32)
    }

    /// A filled triangle.
    ///
    /// # Errors
    /// If plotters cannot draw; likewise below.
    pub(super) fn triangle(&self, corners: &[Vec2; 3]) -> Drawn {
        let corners = corners.map(|p| self.pixel(p)).to_vec();
        self.canvas.draw(&Polygon::new(corners, FAINT.filled()))?;
        Ok(())
    }

    /// The outline of a box, larger by `margin` metres on each side.
    ///
    /// # Errors
    /// As for [`Paper::triangle`].
    pub(super) fn outline(
        &self,
        bounds: &Aabb,
        margin: f32,
        colour: RGBColor,
        width: u32,
    ) -> Drawn {
        let corners = [
            bounds.min.truncate() - margin,
            bounds.max.truncate() + margin,
        ];
        let corners = corners.map(|p| self.pixel(p));
        self.canvas
            .draw(&Rectangle::new(corners, colour.stroke_width(width)))?;
        Ok(())
    }

    /// A line of text with its middle at a place.
    ///
    /// # Errors
    /// As for [`Paper::triangle`].
    pub(super) fn centred(&self, words: &str, at: Vec2, size: i32, colour: RGBColor) -> Drawn {
        write(
            self.canvas,
            words,
            self.pixel(at),
            coloured(size, colour).pos(CENTRE),
        )
    }

    /// All boxes below a node, coloured by level; each has some air around those inside.
    ///
    /// # Errors
    /// As for [`Paper::triangle`].
    pub(super) fn boxes(&self, tree: &Flat, node: &Node, level: usize) -> Drawn {
        let colour = LEVELS[level.min(LEVELS.len() - 1)];
        let air = 0.05 * height(tree, node) as f32;
        self.outline(&node.bounds, air, colour, 4)?;
        if node.link.count > 0 {
            return Ok(());
        }
        let children = tree.pairs[node.link.first as usize].nodes();
        children
            .iter()
            .try_for_each(|child| self.boxes(tree, child, level + 1))
    }
}

/// The levels below a node.
pub(super) fn height(tree: &Flat, node: &Node) -> u32 {
    if node.link.count > 0 {
        return 0;
    }
    let [left, right] = tree.pairs[node.link.first as usize].nodes();
    1 + height(tree, &left).max(height(tree, &right))
}

/// Two trees over the same 22 triangles, side by side, each with its cost.
///
/// # Errors
/// What plotters reports.
pub(super) fn two_organisations() -> Figure {
    let mut rng = pcg::stream(22, 0);
    let mut near = |at: Vec2, spread: f32| {
        at + spread * vec2(rng.random::<f32>() - 0.5, rng.random::<f32>() - 0.5)
    };
    let mut places: Vec<_> = (0..13).map(|_| (near(vec2(1.3, 1.3), 1.7), 0.13)).collect();
    places.extend((0..5).map(|_| (near(vec2(6.6, 4.6), 1.5), 0.18)));
    places
        .extend([(1.0, 5.2), (3.9, 3.3), (4.6, 0.9), (7.2, 1.2)].map(|(x, y)| (vec2(x, y), 0.34)));
    let triangles = triangles(&places, 2);
    figure(1120, 520, |canvas| {
        for (left, name, method) in [
            (40.0, "half of them on each side", Method::Median),
            (1150.0, "by surface area", Method::Sweep),
        ] {
            let origin = vec2(left + 20.0, 920.0);
            let paper = Paper {
                canvas,
                origin,
                scale: 128.0,
            };
            triangles.iter().try_for_each(|t| paper.triangle(t))?;
            let tree = tree(&triangles, method);
            let cost = Cost { most: 1, ..COST };
            let cost = sah_cost(tree.root.as_ref(), &tree.pairs, &cost);
            tree.root
                .iter()
                .try_for_each(|root| paper.boxes(&tree, root, 0))?;
            let label = format!("{name}: cost {cost:.1}");
            paper.centred(&label, vec2(4.0, 6.65), 46, INK)?;
        }
        Ok(())
    })
}
