//! What a browser shows of a graded class.

use super::exports::{NAME, class};
use super::{Course, RIGHT, text, visible_only, wrong_sign};
use raybook_common::project;

#[test]
fn a_page_shows_the_picture_of_wrong_answers_and_stays_small() {
    let course = Course::new("[[chapter]]\nchapter = 'ch03'\nexercises = ['sphere_hit']\n");
    let solution = text(&project("tests/solutions/python/ch03_sphere.py"));
    let (first, rest) = solution.split_at(solution.find("def sphere_hit").expect("a function"));
    let (head, body) = rest.split_once('\n').expect("a body");
    let wrong = format!("{first}{head}\n    radius = 1.2 * radius\n{body}");
    for (student, answers) in [("right", solution.clone()), ("wrong", wrong)] {
        let folder = format!("hand-ins/{student}");
        let (code, said) = course.say(&["new", &folder, "--language", "python"]);
        assert_eq!(code, Some(0), "{said}");
        course.hand_in(&format!("{student}/ch03_sphere.py"), &answers);
    }
    let (code, said) = course.grade(&[]);
    assert_eq!(code, Some(0), "{said}");
    let page =
        |student: &str| text(&course.path(&format!("results/students/{student}/index.html")));
    assert!(!page("right").contains("<img"), "what is right needs none");
    let page = page("wrong");
    let alts: Vec<_> = page
        .split(" alt=\"")
        .skip(1)
        .map(|rest| rest.split('"').next())
        .collect();
    let [Some(drawing), Some(picture)] = alts[..] else {
        panic!("a drawing and a picture: {alts:?}");
    };
    assert!(
        !drawing.is_empty() && picture.ends_with("pixels are wrong"),
        "{alts:?}"
    );
    assert!(
        page.contains("src=\"data:image/png;base64,iVBORw0KGgo"),
        "it is in the page"
    );
    let journal = text(&course.path("results/run.jsonl"));
    println!(
        "{} bytes of a page, {} of the journal",
        page.len(),
        journal.len()
    );
    assert!(page.len() < 40_000, "{} bytes of a page", page.len());
    assert!(
        journal.len() < 16_000,
        "{} bytes of a journal",
        journal.len()
    );
}

#[test]
fn pages_tell_what_belongs_together_and_who_reaches_for_more() {
    let course = Course::new("[[chapter]]\nchapter = 1\nexercises = ['ray_at']\n");
    // The first visible case has another fault than all others.
    let two = wrong_sign().replace(
        "        print('=', *",
        "        print('= 7 7 7', flush=True) if n[6] == 0 else print('=', *",
    );
    course.hand_in("two.py", &two);
    course.hand_in("memory.py", &visible_only());
    course.hand_in("spy.py", &format!("import subprocess\n{RIGHT}"));
    let (code, said) = course.grade(&[]);
    assert_eq!(code, Some(0), "{said}");
    let page = text(&course.path("results/students/two/index.html"));
    let (_, told) = page.split_once("cases are right").expect("some are wrong");
    assert!(
        told.contains("along x from the world's origin:") && told.contains("goes backwards"),
        "the case is one of the mistake: {told}"
    );
    let page = text(&course.path("results/students/memory/index.html"));
    assert!(
        page.contains("For other questions it seems that your function returns 0"),
        "{page}"
    );
    let page = text(&course.path("results/index.html"));
    for remark in [
        "its text seems to try to start programs",
        "right on the visible cases only: ray_at",
    ] {
        assert_eq!(page.matches(remark).count(), 1, "{remark}: {page}");
    }
}

#[test]
fn no_text_of_a_stranger_means_anything_to_a_browser() {
    let course = class();
    for page in [
        "index.html",
        "students/evil/index.html",
        &format!("students/{NAME}/index.html"),
    ] {
        let page = text(&course.path(&format!("results/{page}")));
        for evil in ["<script", "\u{1b}", "\0", "\u{202e}", "<b>", "<now>"] {
            assert!(!page.contains(evil), "{evil:?}: {page}");
        }
        let [all, within] = ["src=", "src=\"data:image/"].map(|of| page.matches(of).count());
        assert!(
            all == within && !page.contains("http"),
            "a page needs no other file"
        );
    }
    let evil = text(&course.path("results/students/evil/index.html"));
    assert!(
        evil.contains("&lt;script&gt;"),
        "it is shown, though: {evil}"
    );
    let class = text(&course.path("results/index.html"));
    let link = "students/%3Dcmd%7C%27%20%3Cb%3E%22x%22%2C%20%26%20y%3F%23%E2%80%AE%2541/index.html";
    assert!(class.contains(link), "the link leads to the page: {class}");
}
