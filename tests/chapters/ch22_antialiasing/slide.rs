//! What is measured of patterns, for a slide.

use raybook_chapters::lab::slide::measure::Measure;

#[test]
fn who_is_hardly_better_does_not_win() {
    let measure = |numbers: &[f64]| Measure {
        name: "error".to_owned(),
        digits: 0,
        numbers: numbers.to_vec(),
    };
    assert_eq!(measure(&[3.0, 1.0, 2.0]).winner(), Some(1), "the smallest");
    assert_eq!(measure(&[2.0, 1.99, 3.0]).winner(), None, "half a per cent");
}
