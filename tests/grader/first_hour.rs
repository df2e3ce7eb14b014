//! A student's first hour, by the command: new, check, write, check, hint, solve.

use crate::common::command::raybook;
use raybook_grader::library::place;
use std::fs;
use std::path::Path;

/// Writes an exercise: replaces its stub.
fn write(folder: &Path, exercise: &str, body: &str) {
    let path = folder.join(place(exercise).expect("the exercise has a place"));
    let text = fs::read_to_string(&path).expect("the file is there");
    let stub = format!("todo!(\"{exercise}\")");
    assert!(text.contains(&stub), "{exercise} is not written yet");
    fs::write(path, text.replace(&stub, body)).expect("the file can be written");
}

#[test]
#[expect(clippy::too_many_lines, reason = "one hour, told in order")]
fn the_first_hour() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let (code, said) = raybook(home.path(), &["new", "my-rays"]);
    assert_eq!(code, 0, "{said}");
    assert!(
        said.contains("raybook check") && said.contains("sphere_hit"),
        "it shows the map and the next step: {said}"
    );
    let rays = home.path().join("my-rays");
    let readme = fs::read_to_string(rays.join("README.md")).expect("there is a README");
    let (tasks, map) = readme
        .split_once("## The course")
        .expect("it has the course map");
    assert!(
        (8..=12).contains(&tasks.lines().count()) && map.contains("sphere_hit"),
        "ten lines, and the map"
    );

    let (code, said) = raybook(&rays, &["check", "--plain"]);
    assert_eq!(code, 1, "not everything is right: {said}");
    assert!(
        said.contains("not started ray_at") && !said.contains("wrong "),
        "everything is not started: {said}"
    );
    assert!(
        said.contains("Next: write ray_at in src/math/ray.rs"),
        "and the next step is said: {said}"
    );

    write(&rays, "ray_at", "self.origin + t * *self.direction");
    write(
        &rays,
        "camera_ray",
        "let x = (film.x - 0.5) * self.plane.x;
        let y = (0.5 - film.y) * self.plane.y;
        let toward = self.focal_length * *self.forward + x * *self.right + y * *self.up;
        Ray::new(self.focal_point, Dir3::new_or(toward, self.forward))",
    );
    write(
        &rays,
        "sphere_hit",
        "println!(\"radius {}\", self.radius);
        let from = ray.origin - self.center;
        let b = from.dot(*ray.direction);
        let root = (b * b - from.length_squared() + self.radius * self.radius).sqrt();
        let t = -b + root;
        within.contains(t).then_some(Hit { t, uv: Vec2::ZERO, id: 0 })",
    );
    let (code, said) = raybook(&rays, &["check", "ch01"]);
    assert_eq!(code, 0, "chapter 1 is right: {said}");
    assert!(
        said.contains("reference solution: compare yours"),
        "then the reference is shown: {said}"
    );
    assert!(
        rays.join(".raybook/ch01_rays_reference.rs").is_file(),
        "where it says"
    );
    assert!(
        rays.join(".raybook/camera_ray.png").is_file(),
        "and a picture is made of the answers"
    );

    // From above, the folder is named; the exercise alone is enough of a name.
    let (code, said) = raybook(home.path(), &["check", "sphere_hit", "my-rays", "--plain"]);
    assert_eq!(code, 1, "it is wrong: {said}");
    for part in [
        "takes the far root",
        "| radius 1",
        "Hint: ",
        "sphere_hit.png",
        "--case 1",
        "m too large",
    ] {
        assert!(said.contains(part), "the feedback tells `{part}`: {said}");
    }
    let (code, said) = raybook(&rays, &["check", "sphere_hit", "--case", "1"]);
    assert!(
        code == 1 && said.contains("case 1: head on"),
        "one case alone: {said}"
    );
    let (_, said) = raybook(&rays, &["hint", "sphere_hit"]);
    assert!(
        said.contains("which of the two does the eye see"),
        "the hint is the mistake's: {said}"
    );
    let (code, said) = raybook(&rays, &[]);
    assert!(
        code == 0
            && said.contains("[2 of 2]")
            && said.contains("wrong: sphere_hit")
            && said.contains("Next: write expose"),
        "progress is kept: {said}"
    );

    let key = home.path().join("key");
    fs::write(&key, "secret, and long enough\n").expect("a file");
    let (code, said) = raybook(
        &rays,
        &[
            "check",
            "ray_at",
            "--key-file",
            key.to_str().expect("its path is text"),
            "--student",
            "7",
            "--json",
        ],
    );
    assert_eq!(code, 0, "the hidden cases are right too: {said}");
    let json = said
        .split_once('{')
        .map(|(_, rest)| format!("{{{rest}"))
        .expect("it is JSON");
    let json: serde_json::Value = serde_json::Deserializer::from_str(&json)
        .into_iter()
        .next()
        .expect("a value")
        .expect("valid");
    assert_eq!(
        (&json["version"], &json["exercises"][0]["state"]),
        (&1.into(), &"right".into()),
        "of version 1"
    );

    let (code, said) = raybook(&rays, &["solve", "ch03"]);
    assert_eq!(code, 0, "{said}");
    assert!(
        rays.join(".raybook/yours/src/shape/sphere.rs").is_file(),
        "the student's own file is kept: {said}"
    );
    let (code, said) = raybook(&rays, &["check", "3"]);
    assert_eq!(code, 0, "the reference is right: {said}");

    fs::write(rays.join("src/math/ray.rs"), "fn broken(").expect("the file can be written");
    let (code, said) = raybook(&rays, &["check"]);
    assert!(
        code == 2 && said.contains("does not compile") && said.contains("src/math/ray.rs"),
        "the compiler is heard: {said}"
    );
}
