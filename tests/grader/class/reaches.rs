//! What hand-ins reach for.

use raybook_grader::cases;
use raybook_grader::class::reaches::reaches;
use raybook_grader::examine::Examiner;
use raybook_grader::language::Language;
use raybook_grader::starter;

#[test]
fn what_students_write_reaches_for_nothing() {
    assert!(reaches("Frame coordinate_system(const Vec3& n);\nroad_to_skill(3)").is_empty());
    for language in Language::ALL {
        for name in cases::all().into_iter().map(<dyn Examiner>::name) {
            let reference = starter::place(language, name);
            let reference = reference.and_then(|file| starter::reference_file(language, &file));
            let text = reference.expect("every exercise has one");
            assert!(reaches(&text).is_empty(), "{name}: {:?}", reaches(&text));
        }
    }
}
