//! dp
use super::collapse::{Family, children, half_area};
use super::node::CHILDREN;
use crate::accel::bvh::build::flat::Node;

/// dp
pub fn collapse(nodes: &[Node]) -> Vec<Family> {
    let extra: f32 = std::env::var("EXTRA").ok().and_then(|v| v.parse().ok()).unwrap_or(0.0);
    let extra = nodes.first().map_or(0.0, half_area) * extra;
    let mut cost = vec![[0.0f32; CHILDREN]; nodes.len()];
    let dist = |cost: &[[f32; CHILDREN]], [l, r]: [u32; 2], j: usize| {
        let mut best = (f32::INFINITY, 0);
        for k in 1..j {
            let c = cost[l as usize][k.min(7)] + cost[r as usize][(j - k).min(7)];
            if c < best.0 { best = (c, k); }
        }
        best
    };
    for n in (0..nodes.len()).rev() {
        if nodes[n].link.count > 0 { continue; }
        let ch = children(&nodes[n]);
        cost[n][1] = half_area(&nodes[n]) + extra + dist(&cost, ch, 8).0;
        for i in 2..8 {
            cost[n][i] = dist(&cost, ch, i).0.min(cost[n][i - 1]);
        }
    }
    let mut families = Vec::new();
    let mut waiting: Vec<u32> = nodes.first().map(|_| 0).into_iter().collect();
    while let Some(branch) = waiting.pop() {
        if nodes[branch as usize].link.count > 0 { continue; }
        let mut members = Vec::with_capacity(CHILDREN);
        let mut open = vec![(branch, 8)];
        while let Some((m, mut i)) = open.pop() {
            let c = &cost[m as usize];
            while i > 1 && i < 8 && c[i] == c[i - 1] { i -= 1; }
            if i == 1 || nodes[m as usize].link.count > 0 { members.push(m); continue; }
            let ch = children(&nodes[m as usize]);
            let k = dist(&cost, ch, i).1;
            open.push((ch[1], i - k));
            open.push((ch[0], k));
        }
        waiting.extend(members.iter().rev());
        families.push(Family { branch, children: members });
    }
    families
}
