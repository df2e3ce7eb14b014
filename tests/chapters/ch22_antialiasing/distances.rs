//! Distances to nearest neighbours.

use super::points;
use glam::vec2;
use raybook_chapters::lab::distances::{nearest, relative};

#[test]
fn distances_are_measured_over_the_edges() {
    let near = nearest(&[vec2(0.02, 0.5), vec2(0.97, 0.5), vec2(0.5, 0.5)]);
    assert!(
        (near[0] - 0.05).abs() < 1e-6 && near[0] == near[1],
        "not 0.47: {near:?}"
    );
    assert!((near[2] - 0.47).abs() < 1e-6, "to the left one: {near:?}");
}

#[test]
fn random_points_have_the_mean_distance_of_clark_and_evans() {
    const RUNS: u64 = 200;
    let mean = |seed| relative(&points("random", 256, seed))[1];
    let got = (0..RUNS).map(mean).sum::<f64>() / RUNS as f64;
    // (1/(2√n)) / √(2/(√3·n))
    let exact = 0.5 / (2.0 / 3.0_f64.sqrt()).sqrt();
    assert!((got / exact - 1.0).abs() < 0.02, "{got}, exactly {exact}");
}

#[test]
fn a_grid_has_one_distance_and_a_poisson_disk_a_large_one() {
    let [least, mean] = relative(&points("regular-grid", 64, 0));
    let exact = (3.0_f64.sqrt() / 2.0).sqrt();
    assert!(
        (least - exact).abs() < 1e-6 && (mean - exact).abs() < 1e-6,
        "{least} {mean}"
    );
    let [least, mean] = relative(&points("poisson-disk", 256, 1));
    assert!(
        (0.6..0.95).contains(&least) && mean > least,
        "{least} {mean}"
    );
    assert_eq!(
        relative(&[vec2(0.5, 0.5)]),
        [0.0; 2],
        "a point alone has no neighbour"
    );
}
