//! What a lecturer sees: a chapter's pictures in their order, by the knobs, sharp, with captions that fit.

use super::{Server, size};
use std::fs;
use std::thread;
use std::time::Duration;

#[test]
fn a_chapter_is_shown_and_a_knob_redraws_its_picture() {
    let server = Server::start();
    let (_, course) = server.get("course.json");
    let course = String::from_utf8(course).expect("it is text");
    for expected in [
        "ch25_capstone",
        "\"focal-length\"",
        "\"unit\":\"mm\"",
        "\"instead\":[\"field-of-view\"]",
        "\"instead\":[\"focal-length\"]",
        "\"most\":500",
        "\"picture\":\"patterns\"",
        "\"command\":\"raybook chapter ch03_sphere\"",
    ] {
        assert!(course.contains(expected), "{expected}: {course}");
    }
    assert!(
        !course.contains("\"mesh\""),
        "files are for the command line"
    );

    let rest = (200, b"{\"share\":null}".to_vec());
    assert_eq!(server.get("progress.json"), rest, "nothing is being drawn");
    let (status, first) = server.get("screens/ch03_sphere?first=1");
    let first = String::from_utf8(first).expect("it is text");
    assert_eq!(status, 200, "{first}");
    assert!(
        !first.contains("roots") && first.contains("\"all\":false"),
        "one at once: {first}"
    );
    let (status, screens) = server.get("screens/ch03_sphere");
    let screens = String::from_utf8(screens).expect("it is text");
    assert_eq!(status, 200, "{screens}");
    let place = |name: &str| {
        screens
            .find(name)
            .unwrap_or_else(|| panic!("{name}: {screens}"))
    };
    assert!(place("\"picture\"") < place("\"roots\""), "in their order");
    assert!(
        place("\"roots\"") < place("\"cancellation\""),
        "in their order"
    );

    let (status, sketch) = server.get("picture/ch03_sphere/picture?quick=1");
    assert_eq!(
        (status, size(&sketch)),
        (200, (240, 135)),
        "a sketch at first"
    );
    let (status, usual) = server.get("picture/ch03_sphere/picture");
    assert_eq!(
        (status, size(&usual)),
        (200, (48, 27)),
        "then as wide as wanted"
    );
    let kept = server.out.path().join("ch03_sphere/picture.png");
    assert_eq!(
        fs::read(kept).expect("it is the tour's"),
        usual,
        "it is kept"
    );

    let (status, turned) = server.get("picture/ch03_sphere/picture?radius=0.5&quick=1");
    assert_eq!((status, size(&turned)), (200, (240, 135)), "quickly");
    assert!(turned != sketch, "another radius, another picture");
    let (_, fresh) = server.get("picture/ch03_sphere/picture?quick=1&fresh=1");
    assert_eq!(
        fresh, sketch,
        "although the tour's is there: what a knob changes is seen beside it"
    );
    let (status, half) = server.get("picture/ch03_sphere/picture?radius=0.5&half=1");
    assert_eq!((status, size(&half).0), (200, 24), "better, half as wide");
    let (status, turned) = server.get("picture/ch03_sphere/picture?radius=0.5");
    assert_eq!((status, size(&turned)), (200, (48, 27)), "and well");
    assert!(turned != usual, "another radius, another picture");

    // The chapter's other pictures are still drawn for good.
    let mut left = 600;
    while server.get("progress.json") != rest {
        left -= 1;
        assert!(left > 0, "all is drawn, within a minute");
        thread::sleep(Duration::from_millis(100));
    }
    for (query, why) in [
        ("radius=7", "a number from 0.02 to 0.8"),
        ("radius=%22%3E", "a number from 0.02 to 0.8"),
        ("speed=1", "has no knob `speed`"),
    ] {
        let (status, body) = server.get(&format!("picture/ch03_sphere/picture?{query}"));
        let said = String::from_utf8_lossy(&body);
        assert!(
            status == 400 && said.contains(why),
            "{query}: {status} {said}"
        );
    }
    let (status, _) = server.get("picture/ch07_mesh/picture?mesh=/etc/passwd");
    assert_eq!(status, 400, "a page chooses no files");
}

#[test]
fn a_drawing_is_sharp_on_every_projector() {
    let server = Server::start();
    let (status, _) = server.get("screens/ch14_refraction");
    assert_eq!(status, 200);
    for query in ["?quick=1", "", "?index=3&quick=1", "?index=3"] {
        let path = format!("/{}/picture/ch14_refraction/fresnel{query}", server.token);
        let host = &server.host;
        let (head, body) = server.exchange(&format!("GET {path} HTTP/1.1\r\nHost: {host}\r\n\r\n"));
        assert!(
            head.contains("Content-Type: image/svg+xml\r\n"),
            "{query}: {head}"
        );
        assert!(body.starts_with(b"<svg"), "{query}: it is an SVG");
    }
    let (_, course) = server.get("course.json");
    let course = String::from_utf8(course).expect("it is text");
    let unscaled = "\"unscaled\":[\"zone_plates\"]";
    assert!(course.contains(unscaled), "rings are not scaled: {course}");
}

#[test]
fn a_caption_tells_of_the_picture_that_is_shown() {
    let server = Server::start();
    let (_, screens) = server.get("screens/ch22_antialiasing?first=1");
    let screens = String::from_utf8(screens).expect("it is text");
    assert!(
        screens.contains("1 and 2 rays per pixel"),
        "a sketch: {screens}"
    );
    for _ in ["while the rest is being drawn", "again"] {
        let path = format!("/{}/picture/ch22_antialiasing/picture", server.token);
        let host = &server.host;
        let (head, _) = server.exchange(&format!("GET {path} HTTP/1.1\r\nHost: {host}\r\n\r\n"));
        assert!(head.contains("1%20and%201%20rays%20per%20pixel"), "{head}");
    }
}
