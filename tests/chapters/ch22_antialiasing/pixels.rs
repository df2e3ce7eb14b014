//! Whether neighbouring pixels make the same error.

use super::subject;
use raybook::math::pcg;
use raybook_chapters::lab::blue_noise::BLUE_NOISE;
use raybook_chapters::lab::integrands::CLASSES;
use raybook_chapters::lab::pixels::correlation;
use raybook_chapters::lab::subject::Subject;

#[test]
fn grids_repeat_themselves_and_random_patterns_do_not() {
    let edges = CLASSES[1].members(600, &mut pcg::stream(1, 1));
    for name in ["regular-grid", "rotated-grid"] {
        let same = correlation(&subject(name), 16, &edges);
        assert!((same - 1.0).abs() < 1e-9, "{name}: {same}");
    }
    for name in ["random", "jittered", "sobol-owen"] {
        let chance = correlation(&subject(name), 16, &edges);
        // 600 pairs: 1/√600 = 0.04, and more because edges differ.
        assert!(chance.abs() < 0.2, "{name}: {chance}");
    }
    let moved = correlation(&Subject::of(&BLUE_NOISE), 16, &edges);
    assert!(moved.abs() < 0.2, "moved by chance: {moved}");
}
