//! Numbers by which mistakes are told apart.

use glam::{DVec2, dvec2};
use proptest::prelude::*;
use raybook_grader::traits::nearest;

proptest! {
    #[test]
    fn the_nearest_point_is_the_nearest_of_all(points in prop::collection::vec(((0..20_u32), any::<f64>()), 0..60)) {
        let points: Vec<_> = points.iter().map(|(x, y)| dvec2(f64::from(*x) / 20.0, y.fract())).collect();
        let near = |p: &DVec2| {
            let own = points.iter().filter(|q| p == *q).count();
            let others = points.iter().filter(|q| p != *q).map(|q| p.distance(*q));
            if own > 1 { 0.0 } else { others.fold(1.0, f64::min) }
        };
        let mean = points.iter().map(near).sum::<f64>() / points.len().max(1) as f64;
        prop_assert!((nearest(&points) - mean).abs() < 1e-12);
    }
}

#[test]
fn what_is_no_number_is_far_from_everything() {
    let nan = DVec2::splat(f64::NAN);
    assert_eq!(nearest(&[nan, nan]), 1.0);
    assert_eq!(
        nearest(&[nan, dvec2(0.25, 0.5), -nan, dvec2(0.5, 0.5)]),
        0.625
    );
    assert_eq!(nearest(&[]), 0.0);
}
