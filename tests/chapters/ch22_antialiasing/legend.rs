//! Numbers as people write them.

use raybook_chapters::lab::legend::{number, power_of_ten};

#[test]
fn numbers_have_a_minus_sign_and_nothing_has_none() {
    let written = [number(-0.501, 2), number(-0.001, 2), number(2.0, 0)];
    assert_eq!(written, ["−0.50", "0.00", "2"], "as people write them");
}

#[test]
fn exponents_are_raised() {
    assert_eq!(power_of_ten(1e-12), "10⁻¹²", "below one");
    assert_eq!(power_of_ten(1000.0), "10³", "above");
    assert_eq!(power_of_ten(0.02), "2·10⁻²", "between");
}
