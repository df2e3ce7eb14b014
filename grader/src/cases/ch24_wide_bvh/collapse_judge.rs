//! The judge of `collapse`: by what a wide tree must keep to and by its cost, not by its shape.

use super::{MOST, half_area, is_branch, pair};
use crate::Verdict;
use raybook_workbook::exercises::ch24_wide_bvh::{Collapse, FamilyRow};

/// By what a wide tree must keep to, and its cost: the areas of its branches together. A tree of another shape that
/// costs no more is as right.
pub(super) fn judge(q: &Collapse, golden: &[FamilyRow], got: &[FamilyRow]) -> Verdict {
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
            "branch {branch} has {} children; there are {MOST} lanes",
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
