//! `raybook render --preview`: the picture gets better, is drawn again when the file is saved, and stays when the file is wrong.

use crate::common::command::raybook;
use crate::render::{REMARK, SCENE, folder, folder_with_remark};
use raybook::image::{Image, file};
use serde_json::Value;
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// A preview, which ends with the test.
struct Preview {
    process: Child,
    address: String,
}

impl Drop for Preview {
    fn drop(&mut self) {
        self.process.kill().expect("it can be ended");
        self.process.wait().expect("it ends");
    }
}

impl Preview {
    fn start(folder: &Path) -> Self {
        let mut process = Command::new(env!("CARGO_BIN_EXE_raybook"))
            .args(["render", "scene.toml", "--out", "out.png", "--preview"])
            .current_dir(folder)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("it starts");
        let mut line = String::new();
        let stdout = process.stdout.take().expect("it is piped");
        let read = BufReader::new(stdout).read_line(&mut line);
        read.expect("it says its address");
        let address = line.trim().strip_prefix("Open http://");
        let address = address.expect("an address").to_owned();
        Self { process, address }
    }

    /// What is answered to a request below the address.
    fn get(&self, path: &str) -> Vec<u8> {
        let (host, token) = self.address.split_once('/').expect("and a path");
        let mut stream = TcpStream::connect(host).expect("it listens");
        let request = format!("GET /{token}{path} HTTP/1.1\r\nHost: {host}\r\n\r\n");
        stream.write_all(request.as_bytes()).expect("it reads");
        let mut bytes = Vec::new();
        stream.read_to_end(&mut bytes).expect("it answers");
        let end = bytes.windows(4).position(|four| four == b"\r\n\r\n");
        bytes.split_off(end.expect("there is a head") + 4)
    }

    /// Waits until the page says something; returns the number of the picture.
    fn wait_for(&self, key: &str, part: &str) -> u64 {
        // A machine that is busy with other tests is slow.
        let deadline = Instant::now() + Duration::from_secs(300);
        loop {
            let state: Value = serde_json::from_slice(&self.get("state.json")).expect("JSON");
            if state[key].as_str().is_some_and(|said| said.contains(part)) {
                return state["number"].as_u64().expect("a number");
            }
            assert!(Instant::now() < deadline, "`{part}` is said: {state}");
            sleep(Duration::from_millis(20));
        }
    }
}

fn picture(folder: &Path, bytes: &[u8]) -> Image {
    let copy = folder.join("copy.png");
    fs::write(&copy, bytes).expect("written");
    file::load(&copy).expect("a picture")
}

#[test]
fn the_last_picture_of_a_preview_is_the_one_that_is_written_without() {
    let folder = folder(SCENE);
    let preview = Preview::start(folder.path());
    let page = String::from_utf8(preview.get("")).expect("text");
    assert!(page.contains("picture.png?number="), "{page}");
    let number = preview.wait_for("says", "wrote out.png: 20 × 10 pixels, 4 samples");
    assert_eq!(
        number, 3,
        "coarse, with a sample per pixel, and with all four"
    );
    let shown = preview.get("picture.png");
    let (code, said) = raybook(
        folder.path(),
        &["render", "scene.toml", "--out", "alone.png"],
    );
    assert_eq!(code, 0, "{said}");
    let alone = fs::read(folder.path().join("alone.png")).expect("written");
    assert!(shown == alone, "byte for byte");
    assert!(fs::read(folder.path().join("out.png")).expect("written") == alone);
}

#[test]
fn a_saved_file_is_drawn_again_at_once_and_a_wrong_one_leaves_the_picture() {
    let folder = folder(&SCENE.replace("samples = 4", "samples = 1000000"));
    let scene = folder.path().join("scene.toml");
    let preview = Preview::start(folder.path());
    // The last picture would take hours; only who is stopped draws the next scene.
    let before = preview.wait_for("says", "of 1000000 samples per pixel");
    fs::write(&scene, SCENE.replace("radius_m", "radios_m")).expect("written");
    let stayed = preview.wait_for("error", "scene.toml:13:1: a shape of the kind `sphere`");
    assert!(stayed >= before, "{before} pictures, then {stayed}");
    assert_eq!(
        picture(folder.path(), &preview.get("picture.png")).height() % 2,
        0
    );
    fs::remove_file(&scene).expect("it was there");
    preview.wait_for("error", "scene.toml: cannot");
    fs::write(&scene, SCENE.replace("width = 20", "width = 30")).expect("written");
    let after = preview.wait_for("says", "wrote out.png: 30 × 10 pixels");
    assert!(after > stayed, "{stayed} pictures, then {after}");
    let shown = picture(folder.path(), &preview.get("picture.png"));
    assert_eq!((shown.width(), shown.height()), (30, 10));
}

#[test]
fn a_preview_shows_what_a_models_files_have_and_the_picture_has_not() {
    let folder = folder_with_remark();
    let preview = Preview::start(folder.path());
    preview.wait_for("says", "wrote out.png");
    preview.wait_for("remarks", REMARK);
    let page = String::from_utf8(preview.get("")).expect("text");
    assert!(page.contains("id=\"remarks\""), "{page}");
    // A scene without the model has no remark.
    fs::write(folder.path().join("scene.toml"), SCENE).expect("written");
    let deadline = Instant::now() + Duration::from_secs(300);
    loop {
        let state: Value = serde_json::from_slice(&preview.get("state.json")).expect("JSON");
        if state["remarks"] == "" {
            break;
        }
        assert!(Instant::now() < deadline, "the remark goes: {state}");
        sleep(Duration::from_millis(20));
    }
}

#[test]
fn a_preview_in_a_terminal_needs_one() {
    let folder = folder(SCENE);
    let (code, said) = raybook(
        folder.path(),
        &["render", "scene.toml", "--preview=terminal"],
    );
    assert_eq!(code, 2, "{said}");
    assert!(said.contains("standard output is not a terminal"), "{said}");
}

#[cfg(unix)]
#[test]
fn an_interrupted_preview_ends_while_it_draws() {
    let folder = folder(&SCENE.replace("samples = 4", "samples = 1000000"));
    let mut preview = Preview::start(folder.path());
    preview.wait_for("says", "of 1000000 samples per pixel");
    let process = preview.process.id().to_string();
    let sent = Command::new("kill").args(["-s", "INT", &process]).status();
    assert!(sent.is_ok_and(|sent| sent.success()), "the signal is sent");
    let ended = preview.process.wait().expect("it ends");
    assert_eq!(ended.code(), Some(130));
    let left = folder.path().read_dir().expect("the folder").count();
    assert_eq!(left, 1, "only the scene is left");
}
