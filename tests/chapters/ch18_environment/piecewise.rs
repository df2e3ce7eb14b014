//! The choice among weighted cells.

use raybook::math::piecewise::Piecewise;

#[test]
fn the_piecewise_density_is_the_weights() {
    let weights = [1.0, 2.0, 0.0, 7.0, 3.0, 1.0, 2.0, 0.0];
    let piecewise = Piecewise::new(weights);
    assert_eq!(piecewise.total() / 8.0, 2.0, "its integral over [0, 1]");
    for (cell, weight) in weights.into_iter().enumerate() {
        assert_eq!(piecewise.probability(cell), weight / 16.0, "cell {cell}");
    }
    assert_eq!(piecewise.probability(8), 0.0, "there is no cell 8");
    let mut counts = [0; 8];
    for i in 0..1600 {
        let u = (i as f32 + 0.5) / 1600.0;
        let choice = piecewise.choose(u).expect("there is weight");
        assert!(
            (0.0..1.0).contains(&choice.within),
            "what is left of {u} is in [0, 1)"
        );
        counts[choice.cell] += 1;
    }
    assert_eq!(
        counts,
        weights.map(|w| (100.0 * w) as i32),
        "even numbers choose evenly"
    );
}

#[test]
fn cells_without_weight_are_never_chosen() {
    let piecewise = Piecewise::new([0.0, 0.0, 1.0, 0.0, f64::NAN, -1.0, 0.0]);
    for u in [0.0, 0.5, 1.0 - f32::EPSILON / 2.0] {
        let choice = piecewise.choose(u).expect("one cell has weight");
        assert_eq!(choice.cell, 2, "u = {u}");
        assert_eq!(piecewise.probability(2), 1.0, "it has all the weight");
    }
    for empty in [vec![], vec![0.0; 5]] {
        assert_eq!(Piecewise::new(empty).choose(0.3), None, "nothing to choose");
    }
}

#[test]
fn millions_of_cells_are_all_chosen() {
    // In f32 the sum of these ones would stand still at 2²⁴.
    let n = 18_000_000;
    let piecewise = Piecewise::new((0..n).map(|_| 1.0));
    assert_eq!(piecewise.total(), n as f64, "every cell counts");
    let last = piecewise.choose(1.0 - f32::EPSILON / 2.0);
    let cell = last.expect("there is weight").cell;
    assert!(cell >= n - 4, "the end is reached, not {cell}");
}
