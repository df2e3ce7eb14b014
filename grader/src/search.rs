//! Searches of a tree for the nearest triangle, as students write them: the right one, and the ways to go wrong.

use crate::upon::changed;
use crate::{Flaw, Verdict};
use raybook::image::rgb::Rgb;
use raybook::inside::RayBox;
use raybook::math::{aabb::Aabb, interval::Interval, ray::Ray, slab};
use raybook::shape::{Shape, mesh::Facet};
use raybook_chapters::kit::palette::viridis;
use raybook_workbook::exercises::ch07_mesh::{Corners, MeshHitAnswer};

/// What is wrong where a judge of a search complains.
pub const FLAWS: &[Flaw] = &[
    Flaw {
        complaint: "no search can do with less",
        name: "leaves out work that every search has to do, or does not count it",
        hint: "Does the search go on until the next box begins behind the hit? And is each test counted, a test that finds nothing too?",
    },
    Flaw {
        complaint: "the hit is right, but",
        name: "finds the right hit with more work than needed",
        hint: "Which boxes and triangles behind a hit are still asked? Which child is opened first? Are the same tests counted twice?",
    },
    Flaw {
        complaint: "you returned triangle",
        name: "names another triangle than the one that is hit",
        hint: "Where does the number of a triangle come from: its place in the list of all triangles, or in its leaf?",
    },
    Flaw {
        complaint: "but you returned none",
        name: "misses triangles that are hit",
        hint: "Which nodes are never opened?",
    },
    Flaw {
        complaint: "but you returned one",
        name: "finds hits outside of the interval, or where there are none",
        hint: "Is every hit between the ends of the interval?",
    },
    Flaw {
        complaint: " m too ",
        name: "returns another distance than that of the nearest hit",
        hint: "If several triangles are hit, which of them stays, and from where is t measured?",
    },
];

/// A tree of any number of children, and what is searched for in it.
pub struct Tree<'a> {
    /// The ray.
    pub ray: &'a Ray,
    /// The distances that count.
    pub within: Interval,
    /// The triangles, by number.
    pub triangles: &'a [Corners],
    /// The children of a branch: their boxes, and what is in them.
    pub children: &'a dyn Fn(u32) -> Vec<(Aabb, Node)>,
}

/// A node, by number, or a leaf's triangles.
#[derive(Clone)]
pub enum Node {
    /// A branch.
    Branch(u32),
    /// A leaf.
    Leaf(Vec<u32>),
}

/// In which order a branch's children are opened.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// The nearest first.
    Nearest,
    /// The farthest first.
    Farthest,
    /// As they are stored.
    Stored,
    /// The last that is stored first, as from a stack.
    Backwards,
    /// The nearest first, and the others as they are stored.
    NearestThenStored,
    /// Leaves before branches, the nearest first among each.
    LeavesFirst,
    /// The one whose least corner is nearest to the ray's origin first.
    LeastCorner,
    /// The one whose box the ray leaves first.
    LeftFirst,
    /// The one in whose box the middle of the ray's stay is nearest.
    MiddleOfStay,
    /// The nearest of all that wait, wherever they are in the tree: as right as the nearest of a branch.
    NearestOfAll,
}

/// The distance of a box.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum By {
    /// Where the ray enters it.
    Enter,
    /// Where the ray leaves it.
    Exit,
    /// Where the ray passes its middle.
    Middle,
    /// Half way between where the ray enters it and where it leaves it.
    Stay,
}

/// Which of several hits stays.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Keeps {
    /// The nearest.
    Nearest,
    /// The first that is found.
    First,
    /// The last that is found.
    Last,
}

/// How a search goes; one field wrong is a mistake.
#[derive(Clone, Copy)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is a mistake of its own"
)]
pub struct How {
    /// Asks the children's boxes whether they are met.
    pub asks: bool,
    /// Asks the box of the first child for all of them.
    pub asks_the_first: bool,
    /// Looks at the first child in place of the second too.
    pub looks_twice: bool,
    /// How many of a branch's children are looked at.
    pub looks_at: usize,
    /// How many of those that are met are opened.
    pub opens: usize,
    /// Which of them comes first.
    pub order: Order,
    /// Leaves out those that wait behind a hit.
    pub drops: bool,
    /// A hit ends the interval.
    pub shortens: bool,
    /// From the first hit on, the interval begins at 0.
    pub begins_again: bool,
    /// Triangles are tested from 0 on, boxes from the interval's min on.
    pub tests_from_0: bool,
    /// Which hit stays.
    pub keeps: Keeps,
    /// Ends at the first leaf with a hit.
    pub stops: bool,
    /// Ends a leaf at its first hit.
    pub stops_in_leaf: bool,
    /// Ends a leaf after its first triangle.
    pub only_the_first: bool,
    /// Counts a triangle's test only if it finds a hit.
    pub counts_hits: bool,
    /// Counts a box's test only if the ray meets the box.
    pub counts_met: bool,
    /// Ends a leaf before its last triangle.
    pub forgets_the_last: bool,
    /// Begins a leaf with its second triangle.
    pub forgets_the_first: bool,
    /// By which distance of a box the search goes.
    pub by: By,
    /// Takes a box for missed if the ray begins in it.
    pub only_from_outside: bool,
    /// Takes all boxes for missed if the ray does not move along some axis.
    pub loses_parallel: bool,
    /// Takes a triangle for missed if the ray meets its back.
    pub culls: bool,
    /// Ends at the first waiting node behind a hit.
    pub ends_behind: bool,
}

/// As it should be.
const WELL: How = How {
    asks: true,
    asks_the_first: false,
    looks_twice: false,
    looks_at: usize::MAX,
    opens: usize::MAX,
    order: Order::Nearest,
    drops: true,
    shortens: true,
    begins_again: false,
    tests_from_0: false,
    keeps: Keeps::Nearest,
    stops: false,
    stops_in_leaf: false,
    only_the_first: false,
    counts_hits: false,
    counts_met: false,
    forgets_the_last: false,
    forgets_the_first: false,
    by: By::Enter,
    only_from_outside: false,
    loses_parallel: false,
    culls: false,
    ends_behind: false,
};

/// What a search found, and what it cost.
#[derive(Default)]
pub struct Found {
    /// Branches opened.
    pub branches: u32,
    /// Leaves looked into.
    pub leaves: u32,
    /// Boxes tested.
    pub boxes: u32,
    /// Triangles tested.
    pub tests: u32,
    /// The hit.
    pub hit: Option<MeshHitAnswer>,
}

/// The colour of a hit in a picture: neighbours in the list differ.
pub fn colour(hit: Option<&MeshHitAnswer>) -> Rgb {
    hit.map_or(Rgb::gray(0.1), |hit| {
        viridis((hit.id as f32 * 0.382).fract())
    })
}

/// Searches below a node, rightly but for what is changed.
pub fn search(tree: &Tree, root: &Node, change: fn(&mut How)) -> Found {
    go(tree, root, changed(WELL, change))
}

/// The same, as it is said.
fn go(tree: &Tree, root: &Node, how: How) -> Found {
    let (within, found) = (tree.within, Found::default());
    let mut search = Search {
        tree,
        how,
        within,
        found,
        is_over: false,
    };
    if how.order == Order::NearestOfAll {
        search.open_nearest_of_all(root);
    } else {
        search.open(root);
    }
    search.found
}

/// The least work of any search that asks boxes: that of one that knows the hit, if there is one, and opens only what the ray
/// enters before it. Boxes are a little smaller here, and the way shorter: what the ray only grazes may be left out. A search that
/// asks the box of the root first has no work where the ray misses it.
pub fn least(tree: &Tree, root: &Node, hit: Option<&MeshHitAnswer>) -> Found {
    if hit.is_none() && misses(tree, root) {
        return Found::default();
    }
    let end = hit.map_or(tree.within.max, |hit| hit.t - GRAZED * hit.t.abs());
    let within = tree.within.before(end);
    let mut least = search_grown(&Tree { within, ..*tree }, root, -GRAZED);
    least.tests = least.tests.max(u32::from(hit.is_some()));
    least
}

/// Whether the ray misses the box around a node, or only grazes it.
fn misses(tree: &Tree, node: &Node) -> bool {
    let corners = |&id: &u32| {
        let Corners { p0, p1, p2 } = tree.triangles[id as usize];
        Aabb::of([p0, p1, p2])
    };
    let parts: Vec<_> = match node {
        Node::Branch(branch) => (tree.children)(*branch)
            .into_iter()
            .map(|child| child.0)
            .collect(),
        Node::Leaf(ids) => ids.iter().map(corners).collect(),
    };
    let around = parts.iter().fold(Aabb::EMPTY, |all, part| all.union(part));
    let enters = RayBox::new(tree.ray).enters(&grown(around, -GRAZED), tree.within);
    enters.is_none()
}

/// The work of any search that asks boxes where nothing is hit: all do the same. Boxes are a little larger here: what the ray
/// only grazes may be opened.
pub fn without_hit(tree: &Tree, root: &Node) -> Found {
    search_grown(tree, root, GRAZED)
}

/// The fraction of a box's size, and of the distance of a hit, within which rounding may decide.
const GRAZED: f32 = 1e-3;

/// Searches a tree whose boxes are larger by a fraction of their size on every side.
fn search_grown(tree: &Tree, root: &Node, fraction: f32) -> Found {
    let grow = |(bounds, node): (Aabb, Node)| (grown(bounds, fraction), node);
    let children = |branch| (tree.children)(branch).into_iter().map(grow).collect();
    let children = &children;
    go(&Tree { children, ..*tree }, root, WELL)
}

/// A box that is larger by a fraction of its size on every side.
fn grown(bounds: Aabb, fraction: f32) -> Aabb {
    let by = fraction * bounds.size();
    Aabb {
        min: bounds.min - by,
        max: bounds.max + by,
    }
}

/// That as much work is counted as there must be at the least.
///
/// # Errors
/// If it is less.
pub fn counted(what: &str, least: u32, got: u32) -> Verdict {
    if got >= least {
        Ok(())
    } else {
        let why = "some are not counted, or the search ends too early";
        Err(format!(
            "of {what} you count {got}, and no search can do with less than {least}: {why}"
        ))
    }
}

struct Search<'a> {
    tree: &'a Tree<'a>,
    how: How,
    within: Interval,
    found: Found,
    /// Whether nothing more is opened.
    is_over: bool,
}

impl Search<'_> {
    fn open(&mut self, node: &Node) {
        match node {
            _ if self.is_over || self.how.stops && self.found.hit.is_some() => {}
            Node::Branch(branch) => self.open_children(*branch),
            Node::Leaf(triangles) => self.open_leaf(triangles),
        }
    }

    fn open_leaf(&mut self, triangles: &[u32]) {
        self.found.leaves += 1;
        let last = usize::from(self.how.forgets_the_last);
        let end = if self.how.only_the_first {
            triangles.len().min(1)
        } else {
            triangles.len().saturating_sub(last)
        };
        let first = usize::from(self.how.forgets_the_first);
        for &id in triangles[..end].iter().skip(first) {
            if self.test(id) && self.how.stops_in_leaf {
                break;
            }
        }
    }

    fn open_nearest_of_all(&mut self, root: &Node) {
        let mut waiting = vec![(self.within.min, root.clone())];
        let nearest = |waiting: &[(f32, Node)]| {
            (0..waiting.len()).min_by(|&a, &b| waiting[a].0.total_cmp(&waiting[b].0))
        };
        while let Some(i) = nearest(&waiting) {
            let (t, node) = waiting.swap_remove(i);
            if t > self.within.max || self.how.stops && self.found.hit.is_some() {
                break;
            }
            match node {
                Node::Branch(branch) => waiting.extend(self.met(branch)),
                Node::Leaf(triangles) => self.open_leaf(&triangles),
            }
        }
    }

    /// The children of a branch whose boxes are met, each with the distance by which they are put in order.
    fn met(&mut self, branch: u32) -> Vec<(f32, Node)> {
        self.met_boxes(branch)
            .into_iter()
            .map(|(t, _, child)| (t, child))
            .collect()
    }

    /// The same with their boxes.
    fn met_boxes(&mut self, branch: u32) -> Vec<(f32, Aabb, Node)> {
        self.found.branches += 1;
        let mut children = (self.tree.children)(branch);
        if self.how.asks_the_first {
            let first = children[0].0;
            for child in &mut children {
                child.0 = first;
            }
        }
        if self.how.looks_twice {
            let again = (self.tree.children)(branch).into_iter().take(1);
            children.splice(1.., again);
        }
        let children = children.into_iter();
        let children = children.take(self.how.looks_at);
        children
            .filter_map(|(bounds, child)| Some((self.meets(&bounds)?, bounds, child)))
            .collect()
    }

    fn open_children(&mut self, branch: u32) {
        let mut met = self.met_boxes(branch);
        self.put_in_order(&mut met);
        for (t, _, child) in met.iter().take(self.how.opens) {
            if !self.how.drops || *t <= self.within.max {
                self.open(child);
            } else if self.how.ends_behind {
                self.is_over = true;
            }
        }
    }

    /// The children that are met in the order in which they are opened.
    fn put_in_order(&self, met: &mut [(f32, Aabb, Node)]) {
        let far = |bounds: &Aabb| bounds.min.distance(self.tree.ray.origin);
        let stay = |bounds: &Aabb| {
            let inside = slab::clip(bounds, self.tree.ray, self.within);
            inside.unwrap_or(self.within)
        };
        let leaves = |bounds: &Aabb| stay(bounds).max;
        let middle = |bounds: &Aabb| 0.5 * (stay(bounds).min + stay(bounds).max);
        match self.how.order {
            Order::Stored | Order::NearestOfAll => {}
            Order::Backwards => met.reverse(),
            Order::Nearest => met.sort_by(|a, b| a.0.total_cmp(&b.0)),
            Order::Farthest => {
                met.sort_by(|a, b| a.0.total_cmp(&b.0));
                met.reverse();
            }
            Order::NearestThenStored => {
                let nearest = (0..met.len()).min_by(|&a, &b| met[a].0.total_cmp(&met[b].0));
                if let Some(nearest) = nearest {
                    met[..=nearest].rotate_right(1);
                }
            }
            Order::LeavesFirst => met.sort_by(|a, b| {
                let is_branch = |node: &Node| matches!(node, Node::Branch(_));
                let kinds = is_branch(&a.2).cmp(&is_branch(&b.2));
                kinds.then(a.0.total_cmp(&b.0))
            }),
            Order::LeastCorner => met.sort_by(|a, b| far(&a.1).total_cmp(&far(&b.1))),
            Order::LeftFirst => met.sort_by(|a, b| leaves(&a.1).total_cmp(&leaves(&b.1))),
            Order::MiddleOfStay => met.sort_by(|a, b| middle(&a.1).total_cmp(&middle(&b.1))),
        }
    }

    fn meets(&mut self, bounds: &Aabb) -> Option<f32> {
        let Tree { ray, within, .. } = *self.tree;
        let met = if self.how.asks {
            match self.how.by {
                By::Enter => RayBox::new(ray).enters(bounds, self.within),
                By::Exit => slab::clip(bounds, ray, within).map(|inside| inside.max),
                By::Stay => {
                    slab::clip(bounds, ray, within).map(|inside| 0.5 * (inside.min + inside.max))
                }
                By::Middle => slab::clip(bounds, ray, within)
                    .map(|_| ray.direction.dot(bounds.center() - ray.origin)),
            }
        } else {
            Some(self.within.min)
        };
        let met = met.filter(|_| !self.loses(bounds));
        self.found.boxes += u32::from(met.is_some() || !self.how.counts_met);
        met
    }

    /// Whether a box that is met is taken for missed.
    fn loses(&self, bounds: &Aabb) -> bool {
        let ray = self.tree.ray;
        let is_parallel = || ray.direction.to_array().contains(&0.0);
        let begins_inside = || {
            let all = Interval::new(f32::NEG_INFINITY, f32::INFINITY);
            let enters = slab::clip(bounds, ray, all).map(|inside| inside.min);
            enters.is_some_and(|t| t <= self.tree.within.min)
        };
        self.how.loses_parallel && is_parallel() || self.how.only_from_outside && begins_inside()
    }

    /// Whether a triangle is hit.
    fn test(&mut self, id: u32) -> bool {
        let Corners { p0, p1, p2 } = self.tree.triangles[id as usize];
        let corners = [p0, p1, p2];
        let mut within = self.within;
        if self.how.tests_from_0 {
            within.min = 0.0;
        }
        let hit = (Facet { corners, id }).hit(self.tree.ray, within);
        let is_front = || {
            let n = (p1 - p0).cross(p2 - p0);
            n.dot(*self.tree.ray.direction) < 0.0
        };
        let hit = hit.filter(|_| !self.how.culls || is_front());
        self.found.tests += u32::from(hit.is_some() || !self.how.counts_hits);
        if let Some(hit) = &hit {
            if self.how.shortens {
                self.within = self.within.before(hit.t);
            }
            if self.how.begins_again {
                self.within.min = 0.0;
            }
            let stays = |best: &MeshHitAnswer| match self.how.keeps {
                Keeps::Nearest => hit.t < best.t,
                Keeps::First => false,
                Keeps::Last => true,
            };
            if self.found.hit.as_ref().is_none_or(stays) {
                self.found.hit = Some(MeshHitAnswer { t: hit.t, id });
            }
        }
        hit.is_some()
    }
}

/// What is left of the distances that count, made of these and of those at which the ray is inside a leaf's box.
pub type Part = fn(Interval, Interval) -> Interval;

/// Only those inside the box.
pub const INSIDE: Part = |_, inside| inside;

/// Only those behind the entry.
pub const BEHIND_THE_ENTRY: Part = |within, inside| Interval::new(inside.min, within.max);

/// Only those before the exit.
pub const BEFORE_THE_EXIT: Part = |within, inside| Interval::new(within.min, inside.max);

/// Shrinks a triangle in a leaf with these bounds to a point, unless the ray hits it within a part of the distances that count.
pub fn lose_outside(
    triangle: &mut Corners,
    bounds: &Aabb,
    (ray, within): (&Ray, Interval),
    part: Part,
) {
    let &mut Corners { p0, p1, p2 } = triangle;
    let facet = Facet {
        corners: [p0, p1, p2],
        id: 0,
    };
    let inside = slab::clip(bounds, ray, within);
    let hit = inside.and_then(|inside| facet.hit(ray, part(within, inside)));
    if hit.is_none() {
        (triangle.p1, triangle.p2) = (p0, p0);
    }
}
