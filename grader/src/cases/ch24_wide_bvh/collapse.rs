//! `collapse`: random questions, judge and mistakes.

mod families;

use self::families::{
    Lists, families, first, last, leaves_below, size, take, three_levels, without,
};
use super::{MOST, half_area, is_branch, pair};
use crate::{Flaw, Graded, Mistake, Verdict, sample, traits};
use glam::Vec3;
use rand::RngExt;
use raybook::accel::bvh::build::Method;
use raybook::inside::bvh::{COST, Cost, build};
use raybook::math::{aabb::Aabb, pcg::Pcg};
use raybook_workbook::exercises::ch24_wide_bvh::{Collapse, FamilyRow};
use raybook_workbook::tree_rows::to_rows;

/// This number of boxes up to a size, in metres.
fn boxes(rng: &mut Pcg, count: usize, most: f32) -> Vec<Aabb> {
    let of_any = |_| {
        let (at, size) = (sample::point(rng, 4.0), sample::number(rng, 0.05, most));
        Aabb {
            min: at,
            max: at + size * (sample::point(rng, 0.4) + 0.5),
        }
    };
    (0..count).map(of_any).collect()
}

/// Boxes in groups, of which some are cubes, some plates and some rods: where area, volume and length put them in other orders.
fn groups(rng: &mut Pcg, count: usize) -> Vec<Aabb> {
    let group = |rng: &mut Pcg| {
        let mut stretch = [1.0; 3];
        let thin = rng.random_range(0..3);
        let first = rng.random_range(0..3);
        (0..thin).for_each(|i| stretch[(first + i) % 3] = 0.02);
        let size = sample::number(rng, 0.5, 4.0);
        (sample::point(rng, 8.0), size * Vec3::from(stretch))
    };
    let groups: Vec<_> = (0..5).map(|_| group(rng)).collect();
    let one = |_| {
        let (middle, stretch) = groups[rng.random_range(0..groups.len())];
        let at = middle + stretch * sample::point(rng, 1.0);
        Aabb {
            min: at,
            max: at + stretch * (sample::point(rng, 0.1) + 0.2),
        }
    };
    (0..count).map(one).collect()
}

impl Graded for Collapse {
    fn random(rng: &mut Pcg) -> Collapse {
        let count = rng.random_range(14..40);
        if rng.random_bool(0.5) {
            binary_tree(&groups(rng, count))
        } else {
            binary_tree(&boxes(rng, count, 2.0))
        }
    }

    fn crowded(rng: &mut Pcg, count: usize) -> Option<Collapse> {
        Some(binary_tree(&boxes(rng, count, 0.5)))
    }

    /// By what a wide tree must keep to, and its cost: the areas of its branches together. A tree of another shape that
    /// costs no more is as right.
    fn judge(q: &Collapse, golden: &Vec<FamilyRow>, got: &Vec<FamilyRow>) -> Verdict {
        let mut due: Vec<u32> = Vec::new();
        if (0..q.nodes.len() as u32)
            .take(1)
            .any(|root| is_branch(q, root))
        {
            due.push(0);
        }
        let mut done = 0;
        while let Some(branch) = due.pop() {
            let mut own = got.iter().filter(|family| family.branch == branch);
            let (Some(family), None) = (own.next(), own.next()) else {
                return Err(format!(
                    "branch {branch} is in the new tree, so it needs one list of children; there are {}",
                    got.iter().filter(|family| family.branch == branch).count()
                ));
            };
            judge_family(q, family)?;
            due.extend(family.children.iter().filter(|&&child| is_branch(q, child)));
            done += 1;
        }
        if done < got.len() {
            return Err(format!(
                "{} branches have children, but only {done} are in the tree that begins at node 0",
                got.len()
            ));
        }
        let cost = |families: &[FamilyRow]| -> f32 {
            families
                .iter()
                .map(|family| half_area(q, family.branch))
                .sum()
        };
        let (least, paid) = (cost(golden), cost(got));
        if paid > 1.01 * least {
            let more = 100.0 * (paid / least - 1.0);
            return Err(format!(
                "all leaves are there, but the branches that are left have {more:.0} % more area than they need"
            ));
        }
        Ok(())
    }

    fn traits(q: &Collapse, got: &Vec<FamilyRow>) -> Vec<f64> {
        let children = || got.iter().flat_map(|family| &family.children);
        let n = children().count().max(1) as f64;
        let exists = |i: &&u32| (**i as usize) < q.nodes.len();
        let branches = children()
            .filter(exists)
            .filter(|i| is_branch(q, **i))
            .count();
        let area = |i: &u32| f64::from(half_area(q, *i) / half_area(q, 0).max(f32::MIN_POSITIVE));
        let sizes = got.iter().map(|family| family.children.len());
        vec![
            n / got.len().max(1) as f64 / 8.0,
            sizes.max().unwrap_or(0) as f64 / 8.0,
            branches as f64 / n,
            children().filter(exists).map(area).sum::<f64>().min(100.0),
            got.len() as f64 / q.nodes.len().max(1) as f64,
            n / q.nodes.len().max(1) as f64,
            traits::distinct(children().map(|i| f64::from(*i))),
        ]
    }

    const FLAWS: &'static [Flaw] = &[
        Flaw {
            complaint: "so it needs one list of children",
            name: "does not write one list of children for each branch that is left",
            hint: "Which branches are members of a list? Each of them needs a list of its own, under its own number, and the root too.",
        },
        Flaw {
            complaint: "are in the tree that begins at node 0",
            name: "keeps lists of branches that have been opened, or of leaves",
            hint: "A branch whose children have moved up is no member any more: does it still need a list?",
        },
        Flaw {
            complaint: "nodes",
            name: "names children that are not there",
            hint: "Are the children's numbers those of the binary tree's nodes, from 0?",
        },
        Flaw {
            complaint: "are allowed",
            name: "gives a branch more than eight children",
            hint: "Opening a branch takes one member away and brings two: when must you stop?",
        },
        Flaw {
            complaint: "is below none of its new children",
            name: "loses leaves",
            hint: "Count the leaves before and after. A child may be a leaf or a branch: do both have a place in your list?",
        },
        Flaw {
            complaint: "is below another child",
            name: "names a child twice, or a branch beside its own children",
            hint: "Once a branch's children are in the list, should the branch itself be there too?",
        },
        Flaw {
            complaint: "could be opened",
            name: "stops opening branches while there is still room",
            hint: "Opening a branch takes one member away and brings two: up to how many members may you go on? And where the largest is a leaf, is there a branch beside it?",
        },
        Flaw {
            complaint: "more area than they need",
            name: "opens the wrong branches",
            hint: "Which of the members' boxes do most rays enter, and which of them would you rather spare a step?",
        },
    ];

    const MISTAKES: &'static [Mistake<Self>] = &[
        Mistake {
            name: "opens the smallest branch first",
            hint: "Which of two boxes do more rays enter, and which of them would you rather spare a step?",
            answer: |q| families(q, |how| how.order = |q, i| -half_area(q, i)),
        },
        Mistake {
            name: "opens the branches in the order of the list",
            hint: "Not every branch is equally worth opening: what tells how often rays enter it?",
            answer: |q| families(q, |how| how.order = |_, i| -(i as f32)),
        },
        Mistake {
            name: "keeps two children per branch",
            hint: "There is room for eight: whose children can move up?",
            answer: |q| families(q, |how| how.most = 2),
        },
        Mistake {
            name: "stops at seven children",
            hint: "Opening a branch takes one member away and brings two: is there room for that with seven members?",
            answer: |q| families(q, |how| how.most = MOST - 1),
        },
        Mistake {
            name: "opens the widest branch along x first",
            hint: "Is a long, thin box met by more rays than a large one?",
            answer: |q| families(q, |how| how.order = |q, i| size(q, i).x),
        },
        Mistake {
            name: "opens one branch only",
            hint: "After one branch is opened there may be room for more: what makes your loop end?",
            answer: |q| families(q, |how| how.most = 3),
        },
        Mistake {
            name: "stops at four children",
            hint: "How many children may a branch have?",
            answer: |q| families(q, |how| how.most = 4),
        },
        Mistake {
            name: "goes on to nine children",
            hint: "Opening a branch takes one member away and brings two: when must you stop?",
            answer: |q| families(q, |how| how.most = MOST + 1),
        },
        Mistake {
            name: "goes on to eight branches, and does not count the leaves among the children",
            hint: "How many children may a branch have, leaves included?",
            answer: |q| {
                families(q, |how| {
                    how.count = |q, members| {
                        let branches = members.iter().filter(|&&member| is_branch(q, member));
                        branches.count()
                    };
                })
            },
        },
        Mistake {
            name: "forgets the second child of the last branch it opens",
            hint: "Count the leaves before and after.",
            answer: |q| {
                let right = Collapse::right(q);
                without(right, |i, _| i != 7)
            },
        },
        Mistake {
            name: "leaves out leaves",
            hint: "A child may be a leaf or a branch: do both have a place in your node?",
            answer: |q| {
                let right = Collapse::right(q);
                let leaves: Vec<_> = q.nodes.iter().map(|node| node.count > 0).collect();
                without(right, |_, child| !leaves[child as usize])
            },
        },
        Mistake {
            name: "names a branch among its own children",
            hint: "Once a branch's children are in the list, should the branch itself be there too?",
            answer: |q| {
                let mut right = Collapse::right(q);
                for family in &mut right {
                    family.children.push(family.branch);
                }
                right
            },
        },
        Mistake {
            name: "opens the branch with the longest edges first",
            hint: "Is a long, thin box met by more rays than a large one?",
            answer: |q| families(q, |how| how.order = |q, i| size(q, i).element_sum()),
        },
        Mistake {
            name: "opens the branch that came into the list first, however small it is",
            hint: "Not every branch is equally worth opening: what tells how often rays enter it?",
            answer: |q| families(q, |how| how.next = first),
        },
        Mistake {
            name: "opens the branch that came into the list last, however small it is",
            hint: "Not every branch is equally worth opening: what tells how often rays enter it?",
            answer: |q| families(q, |how| how.next = last),
        },
        Mistake {
            name: "writes the list of the root only",
            hint: "Some of the root's new children are branches: where are their children?",
            answer: |q| {
                Self::right(q)
                    .into_iter()
                    .filter(|family| family.branch == 0)
                    .collect()
            },
        },
        Mistake {
            name: "writes a list for branches that were opened, too",
            hint: "A branch whose children have moved up is no member any more: does it still need a list?",
            answer: |q| families(q, |how| how.lists = Lists::All),
        },
        Mistake {
            name: "opens the branch with the largest side along x and y first",
            hint: "A box has three pairs of sides: how many of them are in your area?",
            answer: |q| families(q, |how| how.order = |q, i| size(q, i).x * size(q, i).y),
        },
        Mistake {
            name: "opens the branch with the largest volume first",
            hint: "A flat box has no volume: do rays enter it?",
            answer: |q| families(q, |how| how.order = |q, i| size(q, i).element_product()),
        },
        Mistake {
            name: "opens the branch with the longest edge first",
            hint: "Is a long, thin box met by more rays than a large one?",
            answer: |q| families(q, |how| how.order = |q, i| size(q, i).max_element()),
        },
        Mistake {
            name: "stops as soon as the largest child is a leaf",
            hint: "A leaf cannot be opened, however large: is there a branch among the other children?",
            answer: |q| {
                families(q, |how| {
                    how.next = |q, members, order| {
                        let by_order = |a: &usize, b: &usize| {
                            order(q, members[*a]).total_cmp(&order(q, members[*b]))
                        };
                        let greatest = (0..members.len()).max_by(by_order);
                        greatest.filter(|&i| is_branch(q, members[i]))
                    };
                })
            },
        },
        Mistake {
            name: "takes up three levels at once, however large the boxes are",
            hint: "A small branch two levels down is opened, and a large one beside a leaf is not: which of them do more rays enter?",
            answer: |q| families(q, |how| how.members = three_levels),
        },
        Mistake {
            name: "fills half of the places with what is below the left child, before it looks at the right one",
            hint: "The left child is small, and the right one large: which of them should have more of the eight places below?",
            answer: |q| {
                families(q, |how| {
                    how.members = |q, how, branch, open| take(q, branch, how.most, open);
                })
            },
        },
        Mistake {
            name: "opens the branch with the most leaves below it first",
            hint: "Many small leaves lie close together: what tells how often a ray enters their box?",
            answer: |q| families(q, |how| how.order = |q, i| leaves_below(q, i) as f32),
        },
        Mistake {
            name: "opens the branch with the longest diagonal first",
            hint: "Is a long, thin box met by more rays than a large one?",
            answer: |q| families(q, |how| how.order = |q, i| size(q, i).length()),
        },
        Mistake {
            name: "opens the first branch of the list, however small it is, and puts its children in its place",
            hint: "Not every branch is equally worth opening: what tells how often rays enter it?",
            answer: |q| {
                families(q, |how| {
                    how.next = first;
                    how.put = |members, i, two| drop(members.splice(i..=i, two));
                })
            },
        },
        Mistake {
            name: "writes lists for branches that were opened, too, and several for some of them",
            hint: "A branch whose children have moved up is no member any more: does it still need a list?",
            answer: |q| families(q, |how| how.lists = Lists::OpenedToo),
        },
        Mistake {
            name: "opens the branch that came into the list first, however small it is, and of two the right one",
            hint: "Not every branch is equally worth opening: what tells how often rays enter it?",
            answer: |q| {
                families(q, |how| {
                    how.next = first;
                    how.pair = |q, branch| {
                        let [left, right] = pair(q, branch);
                        [right, left]
                    };
                })
            },
        },
    ];
}

/// A binary tree over boxes, one in each leaf.
fn binary_tree(boxes: &[Aabb]) -> Collapse {
    let cost = Cost { most: 1, ..COST };
    Collapse {
        nodes: to_rows(&build(boxes, Method::Binned, &cost)),
    }
}

/// Whether a family's children hold what the branch holds, and there are as many of them as there can be.
fn judge_family(q: &Collapse, family: &FamilyRow) -> Verdict {
    let FamilyRow { branch, children } = family;
    if let Some(wrong) = children
        .iter()
        .find(|&&child| child as usize >= q.nodes.len())
    {
        return Err(format!(
            "branch {branch} has a child {wrong}, and there are only {} nodes",
            q.nodes.len()
        ));
    }
    if children.len() > MOST {
        return Err(format!(
            "branch {branch} has {} children; at most {MOST} are allowed",
            children.len()
        ));
    }
    let mut met = vec![0; children.len()];
    cover(q, *branch, children, &mut met).map_err(|lost| {
        format!("leaf {lost} was below branch {branch} and is below none of its new children")
    })?;
    if let Some(i) = met.iter().position(|&times| times != 1) {
        return Err(format!(
            "child {} of branch {branch} is below another child, twice in the list, or not below the branch",
            children[i]
        ));
    }
    match children.iter().find(|&&child| is_branch(q, child)) {
        Some(open) if children.len() < MOST => Err(format!(
            "branch {branch} has only {} children, and child {open} could be opened",
            children.len()
        )),
        _ => Ok(()),
    }
}

/// Goes down to the children, counting how often each is met; the number of a leaf that is reached without meeting one.
fn cover(q: &Collapse, node: u32, children: &[u32], met: &mut [u32]) -> Result<(), u32> {
    let mut here = false;
    for (child, met) in children.iter().zip(met.iter_mut()) {
        if *child == node {
            *met += 1;
            here = true;
        }
    }
    if here {
        Ok(())
    } else if is_branch(q, node) {
        pair(q, node)
            .into_iter()
            .try_for_each(|below| cover(q, below, children, met))
    } else {
        Err(node)
    }
}
