//! `raybook present`, asked as a browser asks it, and as another page might try.

use raybook::image::file;
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// The server, which ends with the test.
struct Server {
    process: Child,
    host: String,
    token: String,
    out: TempDir,
}

impl Drop for Server {
    fn drop(&mut self) {
        self.process.kill().expect("it can be ended");
        self.process.wait().expect("it ends");
    }
}

/// What was answered: the status, and the body.
type Answered = (u16, Vec<u8>);

impl Server {
    fn start() -> Self {
        Self::of_width("48")
    }

    fn of_width(width: &str) -> Self {
        let out = tempfile::tempdir().expect("a temporary folder");
        let mut process = Command::new(env!("CARGO_BIN_EXE_raybook"))
            .args(["present", "--no-open", "--width", width, "--samples", "1"])
            .args(["--threads", "1", "--chapter", "sphere", "--out"])
            .env_remove("CARGO") // an installed command
            .arg(out.path())
            .stdout(Stdio::piped())
            .spawn()
            .expect("it starts");
        let mut line = String::new();
        let stdout = process.stdout.take().expect("it is piped");
        BufReader::new(stdout)
            .read_line(&mut line)
            .expect("it says its address");
        let address = line
            .trim()
            .strip_prefix("Open http://")
            .expect("an address");
        let (host, rest) = address.split_once('/').expect("and a path");
        let token = rest
            .strip_suffix("/#ch03_sphere")
            .expect("the chapter to begin with");
        let (host, token) = (host.to_owned(), token.to_owned());
        Self {
            process,
            host,
            token,
            out,
        }
    }

    /// Sends text, and reads the head of what is answered, and the rest.
    fn exchange(&self, text: &str) -> (String, Vec<u8>) {
        let mut stream = TcpStream::connect(&self.host).expect("it listens");
        stream
            .write_all(text.as_bytes())
            .expect("it takes a request");
        let mut bytes = Vec::new();
        stream.read_to_end(&mut bytes).expect("it answers");
        let end = bytes.windows(4).position(|four| four == b"\r\n\r\n");
        let body = bytes.split_off(end.expect("there is a head") + 4);
        (String::from_utf8(bytes).expect("it is text"), body)
    }

    /// Sends text, and reads the status and the rest.
    fn send(&self, text: &str) -> Answered {
        let (head, body) = self.exchange(text);
        let status = head.split(' ').nth(1).and_then(|code| code.parse().ok());
        (status.expect("a status"), body)
    }

    fn get_of(&self, host: &str, path: &str) -> Answered {
        self.send(&format!("GET {path} HTTP/1.1\r\nHost: {host}\r\n\r\n"))
    }

    /// Asks for something below the token.
    fn get(&self, path: &str) -> Answered {
        self.get_of(&self.host, &format!("/{}/{path}", self.token))
    }
}

/// Width and height of a PNG.
fn size(png: &[u8]) -> (usize, usize) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("answer.png");
    fs::write(&path, png).expect("it can be written");
    let picture = file::load(&path).expect("it is a picture");
    (picture.width(), picture.height())
}

#[test]
fn a_page_of_another_host_or_without_the_token_gets_nothing() {
    let server = Server::start();
    assert_eq!(server.token.len(), 32, "a long word");
    let page = format!("/{}/", server.token);
    assert_eq!(server.get("").0, 200, "who knows the address sees the page");
    for (host, path, status) in [
        (server.host.as_str(), "/", 403),
        (&server.host, "/course.json", 403),
        (&server.host, "/00000000000000000000000000000000/", 403),
        ("evil.example", &page, 403),
        ("127.0.0.1", &page, 403),
    ] {
        let (answered, body) = server.get_of(host, path);
        assert_eq!(answered, status, "{host}{path}");
        assert!(!body.starts_with(b"<!doctype"), "{host}{path}: no page");
    }
    let host = &server.host;
    for broken in [
        format!("GET {page} HTTP/1.1\r\n\r\n"),
        format!("GET {page} HTTP/1.1\r\nHost: {host}\r\nHost: evil.example\r\n\r\n"),
        "\r\n\r\n".to_owned(),
    ] {
        assert_eq!(server.send(&broken).0, 400, "{broken}");
    }
    let posted = format!("POST {page} HTTP/1.1\r\nHost: {host}\r\n\r\n");
    assert_eq!(server.send(&posted).0, 405, "only GET is answered");
}

#[test]
fn what_is_not_there_is_not_found_and_no_path_leaves_the_folder() {
    let server = Server::start();
    fs::write(server.out.path().join("secret.png"), "secret").expect("it can be written");
    for path in [
        "nothing",
        "screens/ch99_nothing",
        "screens/../../etc/passwd",
        "picture/ch03_sphere",
        "picture/ch03_sphere/",
        "picture/ch03_sphere/../secret",
        "picture/ch03_sphere/..%2Fsecret",
        "picture/../secret/picture",
        "picture/ch03_sphere/%2e%2e",
        "../course.json",
    ] {
        let (status, body) = server.get(path);
        assert_eq!(status, 404, "{path}: {}", String::from_utf8_lossy(&body));
    }
}

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
fn a_chapter_that_is_drawn_for_good_rests_while_a_knob_is_followed_and_goes_on_then() {
    let server = Server::of_width("480");
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
        let start = Instant::now();
        let (status, _) = server.get("picture/ch22_antialiasing/picture?count=16&quick=1");
        assert_eq!(status, 200);
        // Ten times as long as it takes on a busy machine, and a tenth of what the old picture takes.
        let time = start.elapsed();
        assert!(time < Duration::from_secs(5), "{time:?}");
        let (status, said) = old.join().expect("it is answered");
        let said = String::from_utf8_lossy(&said);
        assert_eq!(
            status, 202,
            "no error, so that a browser complains of none: {said}"
        );
    });
}

#[test]
fn what_the_page_shows_as_command_draws_the_chapter() {
    let out = tempfile::tempdir().expect("a temporary folder");
    let output = Command::new(env!("CARGO_BIN_EXE_raybook"))
        .args(["chapter", "ch03_sphere", "--radius", "0.5", "--width", "32"])
        .args(["--samples", "1", "--out"])
        .arg(out.path())
        .output()
        .expect("it runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    assert!(out.path().join("ch03_sphere/roots.png").exists(), "{said}");
    let output = Command::new(env!("CARGO_BIN_EXE_raybook"))
        .args(["chapter", "3", "--radius", "7"])
        .output()
        .expect("it runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2));
    assert!(said.contains("a number from 0.02 to 0.8"), "{said}");
}

#[test]
fn help_after_a_chapter_tells_its_knobs() {
    let output = Command::new(env!("CARGO_BIN_EXE_raybook"))
        .args(["chapter", "14", "--help"])
        .output()
        .expect("it runs");
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{said}");
    assert!(said.contains("--index <1..3>"), "{said}");
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

#[test]
fn an_unknown_chapter_or_a_port_in_use_is_explained() {
    let server = Server::start();
    let port = server.host.split_once(':').expect("a port").1;
    for (arguments, expected) in [
        (["--chapter", "ch99"], "ch03_sphere"),
        (["--port", port], "any port that is free"),
    ] {
        let output = Command::new(env!("CARGO_BIN_EXE_raybook"))
            .args(["present", "--no-open"])
            .args(arguments)
            .output()
            .expect("it runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(expected), "{said}");
    }
}
