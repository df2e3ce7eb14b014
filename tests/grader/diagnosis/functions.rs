//! What a function that is taken by mistake can be taken of.

use raybook_grader::inside::diagnose::{FUNCTIONS, Function};

#[test]
fn a_length_has_no_cosine_and_is_not_in_degrees() {
    let find = |name| -> &Function {
        let found = FUNCTIONS.iter().find(|one| one.name.starts_with(name));
        found.expect("there is such a function")
    };
    for (name, value, unit, has_angles, suits) in [
        ("returns degrees", 2.0, "m", true, false),
        ("returns degrees", 2.5, "", false, false),
        ("returns degrees", 2.5, "", true, true),
        ("returns degrees", 2.0, "", true, false),
        ("returns degrees", 2.0, "rad", true, true),
        ("returns the cosine", 2.0, "m", false, false),
        ("returns the cosine", 2.5, "", false, true),
        ("returns the cosine", 2.0, "", false, false),
        ("returns the arc cosine", 2.5, "", true, false),
        ("returns the arc cosine", 0.5, "", true, true),
        ("returns 1 − cos", 2.0, "m", true, false),
        ("returns 1 − cos", 0.5, "", false, true),
        ("returns the square of", 2.0, "m", false, true),
    ] {
        let told = find(name).suits(&[value], unit, has_angles);
        assert_eq!(told, suits, "{name} of {value} {unit}");
    }
    let constant = FUNCTIONS.iter().filter(|one| one.is_constant());
    let constant: Vec<_> = constant.map(|one| one.name).collect();
    assert_eq!(constant, ["returns 0", "returns 1"]);
}
