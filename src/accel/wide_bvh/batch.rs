//! Several rays in flight: while one waits for memory, the others go on.

use super::lanes::{Lanes, Work};
use super::nearest::{Nearest, Seeker};
use super::node::{CHILDREN, Link};
use super::stack::{PLACES, Places};
use super::tree::Tree;
use super::walk;
use crate::math::{interval::Interval, ray::Ray};
use crate::shape::{Hit, mesh::Facet};

/// How many rays take turns.
const IN_FLIGHT: usize = 16;

/// A search that can be left after each step, and be taken up again.
struct Flight<'r> {
    /// Which ray of the batch.
    ray: usize,
    seeker: Seeker<'r>,
    found: Nearest,
    /// What is to be tested next: it has been asked of the memory.
    next: Link,
    stack: Places,
    height: usize,
}

impl<'r> Flight<'r> {
    #[inline(always)]
    fn new(tree: &Tree, root: Link, rays: &'r [Ray], ray: usize, within: Interval) -> Self {
        Self {
            ray,
            seeker: Seeker::new(&rays[ray], within.min, tree),
            found: Nearest::nothing(within.max),
            next: root,
            stack: Places::new(),
            height: 0,
        }
    }

    /// Takes up another ray. The stack is empty, whatever its places hold.
    #[inline(always)]
    fn start(&mut self, tree: &Tree, root: Link, rays: &'r [Ray], ray: usize, within: Interval) {
        self.ray = ray;
        self.seeker = Seeker::new(&rays[ray], within.min, tree);
        self.found = Nearest::nothing(within.max);
        self.next = root;
        self.height = 0;
    }

    /// Tests one node or leaf, and asks the memory for the next; false at the end.
    #[inline(always)]
    fn step<L: Lanes>(&mut self, lanes: L, tree: &Tree) -> bool {
        if let Some(leaf) = self.next.as_leaf() {
            let leaf = &tree.leaves[leaf];
            self.found = self.seeker.test(lanes, tree, leaf, self.found, &mut ());
        } else if self.height + CHILDREN > PLACES {
            self.found = walk::closest(lanes, tree, self.next, &self.seeker, self.found, &mut ());
        } else {
            let node = &tree.nodes[self.next.index()];
            let (mut met, t) = lanes.boxes(node, &self.seeker.wide, self.found.limit);
            if met.is_power_of_two() {
                self.next = node.links[walk::first(&mut met)];
                lanes.fetch_next(tree, self.next);
                return true;
            }
            if met != 0 {
                let Self { stack, height, .. } = self;
                self.next = walk::nearest(node, met, &t, stack, height, |_| ()); // no other is near
                lanes.fetch_next(tree, self.next);
                return true;
            }
        }
        while self.height > 0 {
            self.height -= 1;
            let next = self.stack.at(self.height);
            if next.t() < self.found.limit {
                self.next = next.link();
                lanes.fetch_next(tree, self.next);
                return true;
            }
        }
        false
    }
}

/// The nearest hit of each of many rays.
pub(super) struct Batch<'a, 'r> {
    /// The tree.
    pub tree: &'a Tree,
    /// The rays.
    pub rays: &'r [Ray],
    /// The distances that count.
    pub within: Interval,
}

impl<'a> Work for Batch<'a, '_> {
    type Answer = Vec<Option<(&'a Facet, Hit)>>;

    #[inline(always)]
    fn with<L: Lanes>(self, lanes: L) -> Self::Answer {
        let Self { tree, rays, within } = self;
        let mut answers = vec![None; rays.len()];
        let Some(root) = tree.root else {
            return answers;
        };
        let mut flights: Vec<_> = (0..rays.len().min(IN_FLIGHT))
            .map(|ray| Flight::new(tree, root, rays, ray, within))
            .collect();
        let mut started = flights.len();
        while !flights.is_empty() {
            let mut turn = 0;
            while turn < flights.len() {
                let flight = &mut flights[turn];
                if flight.step(lanes, tree) {
                    turn += 1;
                    continue;
                }
                answers[flight.ray] = flight.found.of(&tree.facets);
                if started < rays.len() {
                    flight.start(tree, root, rays, started, within);
                    started += 1;
                    turn += 1;
                } else {
                    flights.swap_remove(turn);
                }
            }
        }
        answers
    }
}
