//! Which of several pictures is drawn first, and which no more.

use super::{Server, size};
use std::fs;
use std::thread;
use std::time::Duration;

#[test]
fn a_chapter_that_is_drawn_for_good_rests_while_a_knob_is_followed_and_goes_on_then() {
    // So wide that the rest of the chapter takes longer than the turn, on a busy machine too.
    let server = Server::of_width("960");
    let folder = server.out.path().join("ch07_mesh");
    thread::scope(|scope| {
        let last = scope.spawn(|| server.get("picture/ch07_mesh/tessellation"));
        while !folder.join("picture.png").exists() && !last.is_finished() {
            thread::sleep(Duration::from_millis(5));
        }
        let (status, turned) = server.get("picture/ch07_mesh/picture?cells=2&quick=1");
        assert_eq!((status, size(&turned).0), (200, 240), "at once");
        assert!(
            !folder.join("tessellation.png").exists(),
            "before the rest of the chapter"
        );
        let (status, tessellation) = last.join().expect("it answers");
        assert_eq!(status, 200, "nothing was stopped");
        let kept = fs::read(folder.join("tessellation.png"));
        assert_eq!(tessellation, kept.expect("it is drawn"), "it went on");
    });
    let (status, _) = server.get("screens/ch07_mesh");
    assert_eq!(status, 200, "its captions are written");
}

#[test]
fn a_picture_that_is_no_longer_wanted_holds_up_nothing() {
    let server = Server::of_width("1920");
    let slow = "picture/ch22_antialiasing/picture?pattern=poisson-disk&filter=mitchell";
    thread::scope(|scope| {
        let old = scope.spawn(|| server.get(slow));
        let mut left = 600;
        while server.get("progress.json").1 == b"{\"share\":null}" {
            left -= 1;
            assert!(left > 0 && !old.is_finished(), "it is being drawn");
            thread::sleep(Duration::from_millis(20));
        }
        let (status, _) = server.get("picture/ch22_antialiasing/picture?count=16&quick=1");
        assert_eq!(status, 200);
        // Had it been waited for, it would be a picture.
        let (status, said) = old.join().expect("it is answered");
        let said = String::from_utf8_lossy(&said);
        assert_eq!(
            status, 202,
            "no error, so that a browser complains of none: {said}"
        );
    });
}
