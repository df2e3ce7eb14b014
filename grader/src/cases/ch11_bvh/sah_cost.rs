//! `sah_cost`: random questions, judge and mistakes.

use super::{area, heaps, tree, without_faces};
use crate::upon::changed;
use crate::{Graded, Mistake, Verdict, judge, sample};
use raybook::accel::bvh::build::Method;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercises::ch11_bvh::SahCost;
use raybook_workbook::tree_rows::NodeRow;

/// How nodes are weighed: by a measure of the box, and a price.
#[derive(Clone, Copy)]
struct How {
    measure: fn(&NodeRow) -> f32,
    price: fn(&SahCost, &NodeRow) -> f32,
}

/// Σ of a price per node times a measure of its box, by that of the root's; one of the two is changed.
fn weighted(q: &SahCost, change: impl FnOnce(&mut How)) -> f32 {
    let right = How {
        measure: node_area,
        price: node_price,
    };
    let How { measure, price } = changed(right, change);
    let sum: f32 = q.nodes.iter().map(|n| measure(n) * price(q, n)).sum();
    sum / q.nodes.first().map_or(1.0, measure)
}

/// The same with another measure.
fn measured(q: &SahCost, measure: fn(&NodeRow) -> f32) -> f32 {
    weighted(q, |how| how.measure = measure)
}

/// The same with another price.
fn priced(q: &SahCost, price: fn(&SahCost, &NodeRow) -> f32) -> f32 {
    weighted(q, |how| how.price = price)
}

pub(super) fn node_area(node: &NodeRow) -> f32 {
    area(node.min, node.max)
}

fn node_price(q: &SahCost, node: &NodeRow) -> f32 {
    match node.count {
        0 => q.branch,
        count => q.shape * count as f32,
    }
}

impl Graded for SahCost {
    fn random(rng: &mut Pcg) -> SahCost {
        let boxes = heaps(rng);
        SahCost {
            branch: sample::number(rng, 0.5, 2.0),
            shape: sample::number(rng, 0.5, 2.0),
            nodes: tree(&boxes, Method::Median, 8).nodes,
        }
    }

    fn judge(_q: &SahCost, golden: &f32, got: &f32) -> Verdict {
        judge::number("the cost", "", *golden, *got)
    }

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "forgets to divide by the root's area",
            hint: "Make everything twice as large: does a search take longer?",
            answer: |q| SahCost::right(q) * q.nodes.first().map_or(1.0, node_area),
        },
        Mistake {
            name: "divides by the number of nodes, not by the root's area",
            hint: "The chance that a ray which meets the root also meets a node is a ratio of two areas: of which?",
            answer: |q| {
                SahCost::right(q) * q.nodes.first().map_or(1.0, node_area)
                    / q.nodes.len().max(1) as f32
            },
        },
        Mistake {
            name: "divides the area of each node by that of its parent",
            hint: "Half of all rays meet a node, and half of these meet its child: what part of all rays is that?",
            answer: |q| by_parents(q, 0, 1.0),
        },
        Mistake {
            name: "takes half of each area, and forgets to divide by the root's",
            hint: "Make everything twice as large: does a search take longer?",
            answer: |q| 0.5 * SahCost::right(q) * q.nodes.first().map_or(1.0, node_area),
        },
        Mistake {
            name: "counts the leaves only",
            hint: "A ray that comes to a leaf has opened branches before: for free?",
            answer: |q| Self::misread(q, |q| q.branch = 0.0),
        },
        Mistake {
            name: "counts the branches only",
            hint: "What does a search do once it is in a leaf?",
            answer: |q| Self::misread(q, |q| q.shape = 0.0),
        },
        Mistake {
            name: "gives every leaf the cost of one shape",
            hint: "Does a leaf of five shapes cost as much as a leaf of one?",
            answer: |q| priced(q, |q, n| if n.count == 0 { q.branch } else { q.shape }),
        },
        Mistake {
            name: "weighs by volume",
            hint: "How large is the chance that a ray meets a flat box, which has no volume?",
            answer: |q| measured(q, |n| (n.max - n.min).element_product()),
        },
        Mistake {
            name: "leaves out the root",
            hint: "With what probability does a ray that meets the root's box open the root?",
            answer: |q| SahCost::right(q) - q.nodes.first().map_or(0.0, |n| node_price(q, n)),
        },
        Mistake {
            name: "leaves out the cost of opening the root",
            hint: "Every ray that meets the root's box opens the root: where is that counted?",
            answer: |q| {
                let opened = q.nodes.first().filter(|root| root.count == 0);
                SahCost::right(q) - opened.map_or(0.0, |_| q.branch)
            },
        },
        Mistake {
            name: "weighs every node alike, whatever its area",
            hint: "Do as many rays meet a small box as a large one?",
            answer: |q| measured(q, |_| 1.0),
        },
        Mistake {
            name: "weighs by the longest side",
            hint: "How many lines meet a box depends on its surface area, not on a length: what do you weigh by?",
            answer: |q| measured(q, |n| (n.max - n.min).max_element()),
        },
        Mistake {
            name: "adds the cost of a branch to leaves too",
            hint: "A ray that enters a leaf opens no children: what does it pay for?",
            answer: |q| {
                priced(q, |q, n| {
                    node_price(q, n) + if n.count > 0 { q.branch } else { 0.0 }
                })
            },
        },
        Mistake {
            name: "does not weigh the leaves by their area",
            hint: "Is every leaf tested by every ray?",
            answer: |q| {
                let leaves = q.nodes.iter().filter(|n| n.count > 0);
                let tests: f32 = leaves.map(|n| node_price(q, n)).sum();
                let root = q.nodes.first().map_or(1.0, node_area);
                let of_branch =
                    |q: &SahCost, n: &NodeRow| if n.count == 0 { q.branch } else { 0.0 };
                priced(q, of_branch) + tests / root
            },
        },
        Mistake {
            name: "does not weigh the branches by their area",
            hint: "Is every branch entered by every ray?",
            answer: |q| {
                let branches = q.nodes.iter().filter(|n| n.count == 0).count();
                let root = q.nodes.first().map_or(1.0, node_area);
                Self::misread(q, |q| q.branch = 0.0) + q.branch * branches as f32 / root
            },
        },
        Mistake {
            name: "asks the first child of each branch twice, and the second never",
            hint: "A branch has two children: what are their numbers?",
            answer: |q| {
                let root = q.nodes.first().map_or(1.0, node_area);
                first_times(q, 0, 2.0) / root
            },
        },
        Mistake {
            name: "leaves out the second child of each branch",
            hint: "A branch has two children, side by side: what are their numbers?",
            answer: |q| {
                let root = q.nodes.first().map_or(1.0, node_area);
                first_times(q, 0, 1.0) / root
            },
        },
        Mistake {
            name: "weighs by the sum of the sides",
            hint: "How many lines meet a box depends on its surface area, not on a length: what do you weigh by?",
            answer: |q| measured(q, |n| (n.max - n.min).element_sum()),
        },
        Mistake {
            name: "leaves the faces across x out of the area",
            hint: "A box has six faces: which of them are in your sum?",
            answer: |q| measured(q, |n| without_faces(n.max - n.min, 0)),
        },
        Mistake {
            name: "leaves the faces across y out of the area",
            hint: "A box has six faces: which of them are in your sum?",
            answer: |q| measured(q, |n| without_faces(n.max - n.min, 1)),
        },
        Mistake {
            name: "leaves the faces across z out of the area",
            hint: "A box has six faces: which of them are in your sum?",
            answer: |q| measured(q, |n| without_faces(n.max - n.min, 2)),
        },
        Mistake {
            name: "divides by the sum of all nodes' areas",
            hint: "With what probability does a ray that meets the root's box open the root: is it 1 in your sum?",
            answer: |q| {
                let all: f32 = q.nodes.iter().map(node_area).sum();
                SahCost::right(q) * q.nodes.first().map_or(1.0, node_area) / all
            },
        },
        Mistake {
            name: "divides by the areas of the root's two children together",
            hint: "With what probability does a ray that meets the root's box open the root: is it 1 in your sum?",
            answer: |q| {
                let both = q.nodes.first().map_or(0.0, |root| match root.count {
                    0 => children(q, root).map(node_area).sum(),
                    _ => node_area(root),
                });
                SahCost::right(q) * q.nodes.first().map_or(1.0, node_area) / both
            },
        },
        Mistake {
            name: "multiplies by the root's area where it should divide",
            hint: "Make everything twice as large: does a search take longer?",
            answer: |q| {
                let root = q.nodes.first().map_or(1.0, node_area);
                SahCost::right(q) * root * root
            },
        },
        Mistake {
            name: "weighs the branches above a leaf by the leaf's area",
            hint: "A ray opens a branch and misses both of its children: does it pay for the branch?",
            answer: |q| {
                let Some(root) = q.nodes.first() else {
                    return 0.0;
                };
                paths(q, root, 0) / node_area(root)
            },
        },
        Mistake {
            name: "takes the cost of one cut at the root: all shapes below a child are tested there",
            hint: "A child that is a branch has children of its own: does a ray that enters it test all shapes below?",
            answer: |q| {
                let Some(root) = q.nodes.first() else {
                    return 0.0;
                };
                if root.count > 0 {
                    return node_price(q, root);
                }
                let tests = |node: &NodeRow| node_area(node) * shapes(q, node) as f32;
                let below: f32 = children(q, root).map(tests).sum();
                q.branch + q.shape * below / node_area(root)
            },
        },
        Mistake {
            name: "takes 2i + 1 and 2i + 2 for the numbers of the children, as in a full tree",
            hint: "The children of node 2 need not be nodes 5 and 6: which number of a branch says where its children are?",
            answer: |q| as_if_full(q, 0) / q.nodes.first().map_or(1.0, node_area),
        },
        Mistake {
            name: "multiplies the probability of each node by those of all branches above it",
            hint: "You divide each area by the root's: is that the share of all rays that meet the node, or of those that meet its parent?",
            answer: |q| q.nodes.first().map_or(0.0, |root| by_ancestors(q, root)),
        },
        Mistake {
            name: "weighs by the square of the area",
            hint: "A node has half the root's area: which part of the rays that meet the root meets the node? How often is it in your product?",
            answer: |q| measured(q, |n| node_area(n).powi(2)),
        },
        Mistake {
            name: "takes a node for a branch if its `first` is not 0",
            hint: "The second leaf of a tree does not begin at shape 0: which number of a node tells a leaf from a branch?",
            answer: |q| {
                priced(q, |q, n| {
                    if n.first > 0 {
                        q.branch
                    } else {
                        q.shape * n.count as f32
                    }
                })
            },
        },
        Mistake {
            name: "counts the cost of a branch once for each of its two children",
            hint: "What does the task give the cost of: of opening a branch, or of asking one box?",
            answer: |q| Self::misread(q, |q| q.branch *= 2.0),
        },
        Mistake {
            name: "weighs the cost of a branch by the areas of its two children, and not by its own",
            hint: "A ray opens a branch and misses both of its children: does it pay for the branch?",
            answer: |q| {
                let Some(root) = q.nodes.first() else {
                    return 0.0;
                };
                let leaf = |q: &SahCost, n: &NodeRow| if n.count > 0 { q.branch } else { 0.0 };
                let of_root = if root.count > 0 {
                    leaf(q, root)
                } else {
                    node_price(q, root)
                };
                Self::right(q) + priced(q, leaf) - of_root
            },
        },
        Mistake {
            name: "weighs each node by the area of its parent",
            hint: "A ray that enters a branch asks the boxes of both children: does it enter both?",
            answer: by_parents_areas,
        },
        Mistake {
            name: "doubles only the first of the three products of an area",
            hint: "How does your language read 2 * a + b + c: how many of the three are doubled?",
            answer: |q| {
                measured(q, |n| {
                    let d = n.max - n.min;
                    node_area(n) + 2.0 * d.x * d.y
                })
            },
        },
        Mistake {
            name: "doubles only the last of the three products of an area",
            hint: "How does your language read a + b + 2 * c: how many of the three are doubled?",
            answer: |q| {
                measured(q, |n| {
                    let d = n.max - n.min;
                    node_area(n) + 2.0 * d.z * d.x
                })
            },
        },
    ];
}

/// The children of a branch.
fn children<'a>(q: &'a SahCost, branch: &NodeRow) -> impl Iterator<Item = &'a NodeRow> + use<'a> {
    q.nodes.iter().skip(branch.first as usize).take(2)
}

/// The number of shapes below a node.
fn shapes(q: &SahCost, node: &NodeRow) -> u32 {
    match node.count {
        0 => children(q, node).map(|child| shapes(q, child)).sum(),
        count => count,
    }
}

/// What the leaves below a node cost, if each pays for this number of branches above it too, times their areas.
fn paths(q: &SahCost, node: &NodeRow, branches: u32) -> f32 {
    if node.count > 0 {
        let price = node_price(q, node) + q.branch * branches as f32;
        return node_area(node) * price;
    }
    let below = children(q, node).map(|child| paths(q, child, branches + 1));
    below.sum()
}

/// What a node and all below it cost, times the root's area, if the children have the numbers that they have in a full tree.
fn as_if_full(q: &SahCost, i: usize) -> f32 {
    let Some(node) = q.nodes.get(i) else {
        return 0.0;
    };
    let own = node_area(node) * node_price(q, node);
    if node.count > 0 {
        own
    } else {
        own + as_if_full(q, 2 * i + 1) + as_if_full(q, 2 * i + 2)
    }
}

/// What a node and all below it cost if the node counts by its share, and each node below by its share of its parent only.
fn by_parents(q: &SahCost, node: usize, share: f32) -> f32 {
    let Some(node) = q.nodes.get(node) else {
        return 0.0;
    };
    let own = share * node_price(q, node);
    if node.count > 0 {
        return own;
    }
    let below = [0, 1].map(|k| {
        let child = node.first as usize + k;
        let area = q.nodes.get(child).map_or(0.0, node_area);
        by_parents(q, child, area / node_area(node))
    });
    own + below[0] + below[1]
}

/// What a node and all below it cost, if all of that counts by the node's share of the root's area.
fn by_ancestors(q: &SahCost, node: &NodeRow) -> f32 {
    let share = node_area(node) / q.nodes.first().map_or(1.0, node_area);
    let below = match node.count {
        0 => children(q, node).map(|child| by_ancestors(q, child)).sum(),
        _ => 0.0,
    };
    share * (node_price(q, node) + below)
}

/// What a node and all below it cost, times the root's area, if each branch asks its first child only, and counts that some times.
fn first_times(q: &SahCost, node: usize, times: f32) -> f32 {
    let Some(node) = q.nodes.get(node) else {
        return 0.0;
    };
    let own = node_area(node) * node_price(q, node);
    if node.count > 0 {
        own
    } else {
        own + times * first_times(q, node.first as usize, times)
    }
}

/// The cost of a search that enters both children of each branch that it opens.
fn by_parents_areas(q: &SahCost) -> f32 {
    let Some(root) = q.nodes.first() else {
        return 0.0;
    };
    let branches = q.nodes.iter().filter(|node| node.count == 0);
    let prices = |branch| children(q, branch).map(|child| node_price(q, child));
    let below = branches.map(|branch| node_area(branch) * prices(branch).sum::<f32>());
    node_price(q, root) + below.sum::<f32>() / node_area(root)
}
