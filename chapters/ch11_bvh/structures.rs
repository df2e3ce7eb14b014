//! The structures of the course by name: each can be built over the same triangles, and searched by the same rays.

use clap::ValueEnum;
use raybook::accel::bvh::build::Method;
use raybook::accel::two_level_grid::TwoLevelGrid;
use raybook::accel::{Accel, Count};
use raybook::accel::{bvh::Bvh, grid::Grid, list::List, octree::Octree, wide_bvh::WideBvh};
use raybook::math::{interval::Interval, ray::Ray};
use raybook::shape::Hit;
use raybook::shape::mesh::Facet;

/// A structure by its name, as on a command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Structure {
    /// All triangles, one after the other
    List,
    /// Cells of equal size
    Grid,
    /// Cells of equal size; cells with many triangles have a grid of their own
    TwoLevelGrid,
    /// Cells cut in eight where that pays
    Octree,
    /// Boxes in boxes, two by two
    Bvh,
    /// Boxes in boxes, eight by eight, tested at once
    WideBvh,
}

/// How trees of boxes are built.
#[derive(Clone, Copy, Debug)]
pub(super) struct Building {
    /// The method, of binary and of wide trees.
    pub method: Method,
    /// Maximum number of triangles in a leaf of a binary tree.
    pub leaf: u32,
}

impl Structure {
    /// The structures that have been taught by now.
    pub(super) const TAUGHT: [Self; 5] = [
        Self::List,
        Self::Grid,
        Self::TwoLevelGrid,
        Self::Octree,
        Self::Bvh,
    ];

    /// Its name in a sentence.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::List => "list",
            Self::Grid => "grid",
            Self::TwoLevelGrid => "two-level grid",
            Self::Octree => "octree",
            Self::Bvh => "BVH",
            Self::WideBvh => "wide BVH",
        }
    }

    /// What its search counts as boxes.
    pub(super) fn boxes(self) -> &'static str {
        match self {
            Self::List | Self::Bvh => "boxes tested",
            Self::Grid | Self::TwoLevelGrid => "cells visited",
            Self::Octree | Self::WideBvh => "nodes visited",
        }
    }

    /// Where a heat map shows the work.
    pub(super) fn work(self) -> &'static str {
        match self {
            Self::List => {
                "A list tests all triangles for every ray, also for a ray that hits nothing: no pixel is cheaper than another."
            }
            Self::Grid => {
                "A ray visits many cells, also in the empty space of the grid. The triangles are tested where the ray comes \
                close to the surface."
            }
            Self::TwoLevelGrid => {
                "In empty space a ray visits a few large cells. Most of the work is in the fine cells along the surface."
            }
            Self::Octree => {
                "Empty space costs little, because its cells are large. The work is where rays pass close by the surface, through many small cells."
            }
            Self::Bvh => {
                "The work is where rays pass close by the surface: these rays meet many boxes before they hit anything."
            }
            Self::WideBvh => {
                "A node has eight boxes, tested at once: a ray visits few nodes, and tests triangles in blocks."
            }
        }
    }

    /// The structure over triangles.
    pub(super) fn build(self, facets: Vec<Facet>, building: Building) -> Built {
        let Building { method, leaf } = building;
        match self {
            Self::List => Built::List(List::new(facets)),
            Self::Grid => Built::Grid(Grid::of_facets(facets)),
            Self::TwoLevelGrid => Built::TwoLevelGrid(TwoLevelGrid::of_facets(facets)),
            Self::Octree => Built::Octree(Octree::of_facets(facets)),
            Self::Bvh => Built::Bvh(Bvh::with_leaves(facets, method, leaf)),
            Self::WideBvh => Built::WideBvh(Box::new(WideBvh::build(facets, method))),
        }
    }
}

/// A structure over triangles, whichever it is.
pub(super) enum Built {
    List(List<Facet>),
    Grid(Grid<Facet>),
    TwoLevelGrid(TwoLevelGrid<Facet>),
    Octree(Octree<Facet>),
    Bvh(Bvh<Facet>),
    WideBvh(Box<WideBvh>),
}

impl Accel<Facet> for Built {
    fn closest_counted(
        &self,
        ray: &Ray,
        within: Interval,
        count: &mut impl Count,
    ) -> Option<(&Facet, Hit)> {
        match self {
            Self::List(list) => list.closest_counted(ray, within, count),
            Self::Grid(grid) => grid.closest_counted(ray, within, count),
            Self::TwoLevelGrid(grid) => grid.closest_counted(ray, within, count),
            Self::Octree(tree) => tree.closest_counted(ray, within, count),
            Self::Bvh(tree) => tree.closest_counted(ray, within, count),
            Self::WideBvh(tree) => tree.closest_counted(ray, within, count),
        }
    }

    fn any(&self, ray: &Ray, within: Interval) -> bool {
        match self {
            Self::List(list) => list.any(ray, within),
            Self::Grid(grid) => grid.any(ray, within),
            Self::TwoLevelGrid(grid) => grid.any(ray, within),
            Self::Octree(tree) => tree.any(ray, within),
            Self::Bvh(tree) => tree.any(ray, within),
            Self::WideBvh(tree) => tree.any(ray, within),
        }
    }
}
