//! The layers without which nothing is started.

use raybook_grader::inside::sandbox::suffices;

#[test]
fn each_necessary_layer_is_missed_by_its_name() {
    for (landlock, seccomp, filters, missed) in [
        (0, true, true, "landlock"),
        (1, false, true, "CONFIG_SECCOMP_FILTER"),
        (1, true, false, "processor"),
    ] {
        let missing = suffices(landlock, seccomp, filters)
            .expect_err(missed)
            .to_string();
        assert!(
            missing.contains(missed) && missing.contains("--trust"),
            "{missing}"
        );
    }
    assert_eq!(suffices(1, true, true), Ok(()), "the rest is an extra");
}
