//! Bar charts.

use raybook_chapters::kit::bars::{Bars, bars};

#[test]
fn a_small_number_is_not_shown_as_zero() {
    for (value, expected) in [
        (0.0, "0.0"),
        (0.0041, "0.0041"),
        (0.44, "0.44"),
        (1.0, "1.0"),
        (283.14, "283.1"),
    ] {
        let chart = Bars {
            title: "",
            unit: "ms",
            rows: &[("bar", value)],
            note: "",
        };
        let svg = bars(&[chart]).expect("it is drawn").svg;
        assert!(svg.contains(&format!(">{expected} ms<")), "{value}: {svg}");
    }
}
