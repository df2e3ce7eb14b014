//! Chapters 8 to 11 and 24: cells, trees, searches.

use crate::alternatives::wrong::{Wrong, scale};

const LISTS: &[&str] = &[
    "refine_cell",
    "two_level_walk",
    "octree_build",
    "octree_walk",
];

pub const WRONGS: &[Wrong] = &[
    (&["grid_resolution"], "one cell too many along y", |n| {
        n[1] += 1.0;
    }),
    (&["voxels_of_triangle"], "x and z are swapped", |cells| {
        cells[1..].chunks_mut(3).for_each(|cell| cell.swap(0, 2));
    }),
    (&["grid_walk"], "cells count from 1", |visits| {
        visits[1..].chunks_mut(4).for_each(|visit| visit[0] += 1.0);
    }),
    (&["grid_walk"], "leaves 1 % too late", |visits| {
        visits[1..].chunks_mut(4).for_each(|visit| visit[3] *= 1.01);
    }),
    (LISTS, "the last counts from 1", |cells| {
        *cells.last_mut().expect("a count") += 1.0;
    }),
    (&["octree_child"], "upside down", |child| {
        child[0] = (child[0] + 2.0) % 8.0;
    }),
    (&["sah_cost"], "1 % too dear", |cost| scale(cost, 1.01)),
    (&["sah_split"], "a box that is not there", |left| {
        left[1] = 99.0;
    }),
    (&["bvh_build"], "the root is too small", |tree| {
        tree[1] += 0.1;
    }),
    (&["bvh_closest"], "t is 1 % too large", |hit| hit[2] *= 1.01),
    (&["bvh_closest"], "ids count from 1", |hit| hit[3] += 1.0),
    (&["bvh_closest"], "three times as many tests", |hit| {
        hit[0] = 3.0 * hit[0] + 9.0;
    }),
    (
        &["collapse"],
        "the last child is its neighbour",
        |families| {
            *families.last_mut().expect("a number") += 1.0;
        },
    ),
    (&["wide_closest"], "t is 1 % too large", |hit| {
        hit[2] *= 1.01;
    }),
    (&["wide_closest"], "three times as many nodes", |hit| {
        hit[0] = 3.0 * hit[0] + 2.0;
    }),
    (&["wide_closest"], "three times as many tests", |hit| {
        hit[1] = 3.0 * hit[1] + 2.0;
    }),
];
