//! What nobody wants is not drawn, and costs nothing.

use super::{run, small};
use raybook_chapters::LESSONS;
use raybook_chapters::kit::stage::{Stage, progress_bar};
use raybook_chapters::lesson::find;

#[test]
fn the_pictures_before_the_wanted_one_are_named_and_not_drawn() {
    let out = tempfile::tempdir().expect("a temporary folder");
    let chapter = find("ch11_bvh").expect("there is this chapter");
    let stage = Stage::new(chapter.name, small(out.path()), false, progress_bar()).until("heat");
    chapter.draw(&stage).expect("it can be drawn");
    let passed = stage.passed().join(" ");
    let all = "picture letters stages organisations builders growth levels heat";
    assert_eq!(passed, all, "each is named, once");
    assert_eq!(stage.into_outputs().len(), 1);
}

#[test]
fn what_is_not_wanted_costs_no_pixel() {
    for lesson in LESSONS {
        let out = tempfile::tempdir().expect("a temporary folder");
        let bar = progress_bar();
        let stage = Stage::new(lesson.name, small(out.path()), false, bar.clone()).until("none");
        lesson.draw(&stage).expect("it can be drawn");
        let named = !stage.passed().is_empty();
        assert!(named, "{} names its pictures", lesson.name);
        assert_eq!(bar.position(), 0, "{} draws no pixel", lesson.name);
        let drawn = stage.into_outputs();
        assert!(
            drawn.is_empty(),
            "{} asks before each: {drawn:?}",
            lesson.name
        );
    }
}

#[test]
fn what_is_not_wanted_is_not_drawn() {
    let sphere = find("ch03_sphere").expect("there is this chapter");
    let out = tempfile::tempdir().expect("a temporary folder");
    let stage = Stage::new(sphere.name, small(out.path()), false, progress_bar());
    stage
        .stopper()
        .store(true, std::sync::atomic::Ordering::Relaxed);
    sphere
        .draw(&stage)
        .expect("that it was stopped is no fault");
    assert!(
        stage.into_outputs().is_empty(),
        "nothing half drawn is written"
    );
}

#[test]
fn one_picture_is_drawn_alone() {
    let (code, said, out) = run("ch14_refraction", &["--picture", "fresnel", "--index", "3"]);
    assert_eq!(code, Some(0), "{said}");
    let folder = out.path().join("ch14_refraction");
    let files = std::fs::read_dir(&folder).expect("there is the chapter's folder");
    let mut names: Vec<_> = files
        .map(|file| file.expect("it can be listed").file_name())
        .collect();
    names.sort();
    assert_eq!(names, ["fresnel.png", "fresnel.svg"], "{said}");
    let (code, said, _) = run("ch14_refraction", &["--picture", "roof"]);
    let expected =
        "there are picture, letters, parts, beams, fresnel, prism, nested, depth, absorption";
    assert!(
        code == Some(2) && said.contains(expected),
        "{code:?} {said}"
    );
}
