//! quick builder
use super::Tree;
use super::node::{Leaf, Link, Node, TRIANGLES};
use crate::math::aabb::Aabb;
use crate::shape::{Shape, mesh::Facet};
use glam::Vec3;

pub enum Bin {
    Leaf(Aabb, usize, usize),
    Inner(Aabb, Box<[Bin; 2]>),
}
impl Bin {
    fn bounds(&self) -> Aabb {
        match self { Bin::Leaf(b, ..) | Bin::Inner(b, _) => *b }
    }
}
fn area(b: &Aabb) -> f32 {
    let s = b.size();
    if s.x < 0.0 { return 0.0; }
    s.x * s.y + s.y * s.z + s.z * s.x
}
const BINS: usize = 32;
fn cost(n: usize) -> f32 { n.div_ceil(TRIANGLES) as f32 }

fn split(items: &mut [(Aabb, Vec3, u32)], start: usize, depth: usize) -> Bin {
    let bounds = items.iter().fold(Aabb::EMPTY, |b, i| b.union(&i.0));
    let n = items.len();
    if n <= 1 { return Bin::Leaf(bounds, start, n); }
    let cb = Aabb::of(items.iter().map(|i| i.1));
    let mut best = (f32::INFINITY, 0, 0);
    if depth < 48 {
    for axis in 0..3 {
        let (lo, size) = (cb.min[axis], cb.size()[axis]);
        if !(size > 0.0) { continue; }
        let k = BINS as f32 * 0.9999 / size;
        let mut bins = [(Aabb::EMPTY, 0usize); BINS];
        for i in items.iter() {
            let b = &mut bins[(((i.1[axis] - lo) * k) as usize).min(BINS - 1)];
            b.0 = b.0.union(&i.0);
            b.1 += 1;
        }
        let mut right = [(0.0, 0usize); BINS];
        let mut acc = (Aabb::EMPTY, 0);
        for j in (1..BINS).rev() {
            acc = (acc.0.union(&bins[j].0), acc.1 + bins[j].1);
            right[j] = (area(&acc.0), acc.1);
        }
        let mut acc = (Aabb::EMPTY, 0);
        for j in 1..BINS {
            acc = (acc.0.union(&bins[j - 1].0), acc.1 + bins[j - 1].1);
            if acc.1 == 0 || right[j].1 == 0 { continue; }
            let c = area(&acc.0) * cost(acc.1) + right[j].0 * cost(right[j].1);
            if c < best.0 { best = (c, axis, j); }
        }
    }
    }
    let a = area(&bounds);
    if n <= TRIANGLES && !(best.0 + 0.5 * a < a * cost(n)) {
        return Bin::Leaf(bounds, start, n);
    }
    let mid = if best.0 < f32::INFINITY {
        let (_, axis, j) = best;
        let (lo, size) = (cb.min[axis], cb.size()[axis]);
        let k = BINS as f32 * 0.9999 / size;
        let (mut l, mut r) = (0, n);
        while l < r {
            if (((items[l].1[axis] - lo) * k) as usize).min(BINS - 1) < j { l += 1; } else { r -= 1; items.swap(l, r); }
        }
        l
    } else {
        n / 2
    };
    let (l, r) = items.split_at_mut(mid);
    let (l, r) = (split(l, start, depth + 1), split(r, start + mid, depth + 1));
    Bin::Inner(bounds, Box::new([l, r]))
}

pub fn build(facets: Vec<Facet>) -> Tree {
    let mut items: Vec<_> = facets.iter().zip(0..).map(|(f, i)| { let b = f.bounds(); (b, b.center(), i) }).collect();
    let mut tree = Tree { nodes: vec![], leaves: vec![], root: None, facets, largest: glam::Vec3A::ZERO };
    if items.is_empty() { return tree; }
    let bin = split(&mut items, 0, 0);
    let bounds = bin.bounds();
    tree.largest = bounds.min.abs().max(bounds.max.abs()).into();
    let order: Vec<u32> = items.iter().map(|i| i.2).collect();
    tree.root = Some(collapse(&mut tree, &order, &bin));
    let mut nodes = super::pages::list(tree.nodes.len()); nodes.append(&mut tree.nodes); tree.nodes = nodes;
    let mut leaves = super::pages::list(tree.leaves.len()); leaves.append(&mut tree.leaves); tree.leaves = leaves;
    tree
}

fn collapse(tree: &mut Tree, order: &[u32], bin: &Bin) -> Link {
    match bin {
        Bin::Leaf(_, s, n) => {
            let leaf = Leaf::new(&tree.facets, &order[*s..s + n]);
            tree.leaves.push(leaf);
            Link::leaf(tree.leaves.len() - 1)
        }
        Bin::Inner(_, two) => {
            let mut kids: Vec<&Bin> = two.iter().collect();
            while kids.len() < 8 {
                let open = (0..kids.len()).filter(|&i| matches!(kids[i], Bin::Inner(..))).max_by(|&a, &b| area(&kids[a].bounds()).total_cmp(&area(&kids[b].bounds())));
                let Some(i) = open else { break };
                let Bin::Inner(_, two) = kids.swap_remove(i) else { unreachable!() };
                kids.extend(two.iter());
            }
            let place = tree.nodes.len();
            tree.nodes.push(Node::new([]));
            let children: Vec<_> = kids.iter().map(|k| (k.bounds(), collapse(tree, order, k))).collect();
            tree.nodes[place] = Node::new(children);
            Link::node(place)
        }
    }
}
