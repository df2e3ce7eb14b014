//! Near points, in cells.

use glam::vec2;
use rand::RngExt;
use raybook::inside::{Neighbours, Space};
use raybook::math::pcg;

#[test]
fn no_point_is_looked_at_twice_and_none_near_is_missed() {
    let mut rng = pcg::stream(1, 1);
    for space in [Space::Torus, Space::Square] {
        for cells in 1..12 {
            let reach = 1.0 / (f64::from(cells) + 0.01);
            let mut near = Neighbours::new(reach, space);
            (0..40).for_each(|_| near.push(vec2(rng.random(), rng.random())));
            for rings in 1..2 * cells {
                let p = vec2(rng.random(), rng.random());
                let mut found: Vec<_> = near.squares(p, rings).collect();
                assert!(found.len() <= 40, "{cells} cells, {rings} rings: each once");
                let all = near.points().iter();
                let mut all: Vec<_> = all.map(|q| space.distance_squared(p, *q)).collect();
                let sure = (f64::from(rings) / f64::from(cells)).powi(2);
                for list in [&mut found, &mut all] {
                    list.retain(|square| *square < sure);
                    list.sort_by(f64::total_cmp);
                }
                assert_eq!(found, all, "{space:?}: {cells} cells, {rings} rings");
            }
        }
    }
}
