//! A cell with many triangles is cut in eight, and each of the eight again, as long as cutting pays: the cells are small where
//! there is much to tell apart, and large where there is nothing. A ray walks from leaf to leaf, front to back.
//!
//! New: accel/octree/mod.rs accel/octree/tree.rs accel/octree/reach.rs accel/octree/build.rs accel/octree/walk.rs
//! New: accel/octree/validate.rs

mod blocks;
mod cuts;
mod letters;
mod quadtree;

use crate::kit::chapter;
use crate::kit::chart::{Chart, Corner};
use crate::kit::numbers::grouped;
use crate::kit::palette::{BLUE, FAINT, VERMILION};
use crate::kit::stage::{Drawn, Stage};
use crate::kit::{axis::Axis, sheet::sheet};
use crate::shared::law::{Reach, at_sizes, fit};
use crate::shared::own_mesh::{self, MeshKnob};
use crate::shared::showroom::{SMOOTH, Showroom, small};
use crate::shared::{heat::heat, speeds::rays_a_second};
use clap::Args;
use plotters::style::Color;
use raybook::accel::Accel;
use raybook::accel::octree::{Octree, build::Limits, reach::by_triangle};
use raybook::image::Image;
use raybook::math::{aabb::Aabb, interval::Interval};
use raybook::render::film::Film;
use raybook::shape::mesh::{Facet, Mesh};
use raybook::shape::{cuboid::Cuboid, teapot};
use std::process::ExitCode;

/// What the pictures depend on.
#[derive(Args, Clone, Debug)]
pub struct Knobs {
    #[command(flatten)]
    own: MeshKnob,
    /// Depth of the tree of the blocks: the maximum number of cuts from the root to a block
    #[arg(long, value_name = "3..7 cuts", default_value = "7")]
    depth: u32,
    /// Cost of opening a node, in triangle tests: the higher the cost, the larger the leaves, in `heat`
    #[arg(long, value_name = "0..100 tests", default_value = "2")]
    opening: f32,
}

/// Draws the chapter's pictures.
///
/// # Errors
/// If a picture cannot be drawn or written.
pub fn draw(stage: &Stage, knobs: &Knobs) -> Drawn {
    let octree_of = |mesh: &Mesh| {
        let limits = Limits {
            opening: knobs.opening,
            ..Limits::USUAL
        };
        Octree::with(mesh.facets(), limits, by_triangle)
    };
    if let Some(path) = &knobs.own.mesh {
        return own_mesh::draw(stage, path, octree_of, "nodes visited");
    }
    let mesh = teapot::mesh(24);
    let octree = octree_of(&mesh);
    let film = stage.film_of(640, 8, 1.6);
    // Finer than what pays, so that each level shows all its cells.
    let limits = Limits {
        opening: 0.0,
        copies: 500.0,
        depth: knobs.depth,
    };
    let fine = Octree::with(mesh.facets(), limits, by_triangle);
    if stage.wants("picture") {
        let mut cuts = blocks::CUTS.map(|cuts| cuts.min(knobs.depth)).to_vec();
        cuts.dedup();
        let cuts: Vec<_> = cuts.iter().map(u32::to_string).collect();
        let caption = format!(
            "The teapot, and the cells that an octree makes of it: from left to right the triangles, then the cells after at most \
            {} cuts.",
            cuts.join(", ")
        );
        let (cells, kept) = blocks::dissolving(&mesh, &fine);
        let room = Showroom::around(&mesh, film.aspect());
        stage.picture(
            "picture",
            &caption,
            &photograph(&film, &room, &mesh, cells, kept),
        )?;
    }

    let tile = small(&stage.film_of(800, 8, 1.6));
    stage.drawing("letters", letters::CAPTION, letters::draw)?;
    stage.drawing("cuts", cuts::CAPTION, cuts::draw)?;
    if stage.wants("levels") {
        let deepest = knobs.depth.min(6);
        let cells = |depth| blocks::cells(&fine, |_| depth);
        let largest = cells(deepest - 3);
        let shown = largest.iter().map(|cell| cell.bounds);
        let shown = shown.fold(Aabb::EMPTY, |all, cell| all.union(&cell));
        let room = Showroom::around_box(&mesh, &shown, tile.aspect());
        let tiles = [3, 2, 1, 0].map(|up| deepest - up).map(|depth| {
            let cells = cells(depth);
            let name = format!("{depth} cuts: {} cells", cells.len());
            let tile = photograph(&tile, &room, &mesh, cells, Vec::new());
            (name, tile)
        });
        let caption = "The cells that are not empty, level by level. A surface goes through about four of a small cell's eight children: then each level has about four times as many cells as the level above.";
        stage.figure("levels", caption, &sheet(2, &tiles)?)?;
    }

    if stage.wants("quadtree") {
        let caption = "A quad-tree, which is an octree in the plane: a ray visits the leaves in the order of their numbers, for \
            which small leaves have no room, and skips empty leaves.";
        stage.diagram("quadtree", caption, &quadtree::diagram()?)?;
    }

    if stage.wants("heat") {
        let room = Showroom::around(&mesh, tile.aspect());
        let speed = rays_a_second(&tile, |place| room.ray(place), &octree);
        let caption = format!(
            "What each pixel's ray costs with an octree of {} triangles: nodes visited on the left, triangles tested on the right. \
            One thread of this machine answers {speed}.",
            mesh.triangles().len()
        );
        let map = heat(&tile, |place| room.ray(place), &octree);
        stage.figure("heat", &caption, &map.figure("nodes visited")?)?;
    }
    if !stage.wants("law") {
        return Ok(());
    }
    draw_law(stage)
}

/// A picture of blocks, and of those facets of the mesh that are kept, all of clay.
///
/// An octree over the facets and an octree over the blocks find the nearest hits; a facet that is hit shortens the ray for the
/// blocks.
fn photograph(
    film: &Film,
    room: &Showroom,
    mesh: &Mesh,
    blocks: Vec<Cuboid>,
    kept: Vec<Facet>,
) -> Image {
    let (blocks, kept) = (Octree::new(blocks), Octree::of_facets(kept));
    film.refine(|place, _| {
        let ray = room.ray(place);
        let facet = kept.closest(&ray, Interval::AHEAD);
        let before = facet.map_or(Interval::AHEAD, |(_, hit)| Interval::AHEAD.before(hit.t));
        match (blocks.closest(&ray, before), facet) {
            (Some((block, hit)), _) => blocks::shade(block, &ray, &hit),
            (None, Some((_, hit))) => SMOOTH(&ray, &hit, &mesh.surface(&ray, &hit)),
            (None, None) => room.backdrop(place, &ray),
        }
    })
}

/// The cost of a ray against the number of triangles.
fn draw_law(stage: &Stage) -> Drawn {
    let sizes = [100, 316, 1000, 3162, 10_000, 31_623, 100_000];
    let counts = at_sizes(&sizes, Reach::Near, Octree::new);
    let [nodes, tests] = [0, 1].map(|i| {
        counts
            .iter()
            .map(|(n, tests)| (*n, tests[i]))
            .collect::<Vec<_>>()
    });
    let [a, b] = fit(&nodes);
    let law = nodes.iter().map(|&(n, _)| (n, a + b * n.log10()));
    let mut chart = Chart::new(
        Axis::log(80.0..125_000.0)
            .named("N: triangles")
            .format(grouped),
        Axis::linear(0.0..1.25 * nodes[6].1)
            .named("per ray")
            .labels(6),
    )
    .titled("A short ray in a soup, on average")
    .legend(Corner::UpperLeft);
    let name = format!("{a:.1} + {b:.2} log₁₀ N");
    chart.line(law, FAINT.stroke_width(3)).named(&name);
    for (points, name, colour) in [
        (nodes, "nodes visited", BLUE),
        (tests, "triangles tested", VERMILION),
    ] {
        chart
            .line(points.iter().copied(), colour.stroke_width(5))
            .named(name);
        chart.dots(points, 9, colour.filled());
    }
    let caption = "A short ray in a soup of N triangles, as long as the distance from one triangle to the next. The number of \
        nodes visited grows with log N, the depth of the tree; the number of triangles tested does not grow.";
    stage.diagram("law", caption, &chart.figure(900, 560)?)
}

/// The chapter's binary.
pub fn main() -> ExitCode {
    chapter::run("ch10_octree")
}
