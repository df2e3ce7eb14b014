//! `raybook watch`: saves, errors, files that go, bursts; and nothing is left.

use super::{new, there_is};
use raybook_common::project;
use raybook_grader::language::Language;
use std::fs;
use std::io::{Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::{Arc, Mutex};
use std::thread::{sleep, spawn};
use std::time::{Duration, Instant};

/// What a running watch has said, on both outputs.
#[derive(Clone, Default)]
struct Heard(Arc<Mutex<String>>);

impl Heard {
    fn listen(&self, mut output: impl Read + Send + 'static) {
        let heard = self.clone();
        spawn(move || {
            let mut bytes = [0; 1 << 12];
            while let Ok(n @ 1..) = output.read(&mut bytes) {
                let text = String::from_utf8_lossy(&bytes[..n]).into_owned();
                heard.0.lock().expect("nobody panics").push_str(&text);
            }
        });
    }

    /// Waits until something is said, and then until the watch waits again; returns what was said until then, and forgets it.
    fn wait_for(&self, part: &str) -> String {
        let mut all = String::new();
        for part in [part, "Ctrl-C ends"] {
            // A machine that is busy with other tests is slow.
            let deadline = Instant::now() + Duration::from_secs(300);
            loop {
                let mut said = self.0.lock().expect("nobody panics");
                if let Some(at) = said.find(part) {
                    all.extend(said.drain(..at + part.len()));
                    break;
                }
                assert!(Instant::now() < deadline, "`{part}` is said: {said}");
                drop(said);
                sleep(Duration::from_millis(20));
            }
        }
        all
    }
}

/// What the watch's page shows.
fn page(address: &str) -> String {
    let (host, path) = address["http://".len()..].split_once('/').expect("a path");
    let mut server = TcpStream::connect(host).expect("it listens");
    let request = format!("GET /{path} HTTP/1.1\r\nHost: {host}\r\n\r\n");
    server.write_all(request.as_bytes()).expect("it reads");
    let mut answer = String::new();
    server.read_to_string(&mut answer).expect("it answers");
    answer
}

fn watch(folder: &Path) -> (Child, Heard) {
    // One pipe for both outputs: what is said first is heard first.
    let (output, both) = std::io::pipe().expect("there is a pipe");
    let child = Command::new(env!("CARGO_BIN_EXE_raybook"))
        .args(["watch", "--plain", "--page"])
        .current_dir(folder)
        .stdin(Stdio::null())
        .stdout(both.try_clone().expect("it has two ends"))
        .stderr(both)
        .spawn()
        .expect("the command starts");
    let heard = Heard::default();
    heard.listen(output);
    (child, heard)
}

/// Whether a process has this folder as its own.
#[cfg(target_os = "linux")]
fn is_anybody_in(folder: &Path) -> bool {
    let folder = folder.canonicalize().expect("it is there");
    let entries = fs::read_dir("/proc").into_iter().flatten().flatten();
    let mut folders = entries.filter_map(|entry| fs::read_link(entry.path().join("cwd")).ok());
    folders.any(|of_process| of_process == folder)
}

#[cfg(target_os = "linux")]
#[test]
fn a_watch_follows_saves_and_survives_errors() {
    if !there_is("python3") {
        return;
    }
    let home = tempfile::tempdir().expect("a temporary folder");
    let folder = new(home.path(), "rays", Language::Python);
    let (mut child, heard) = watch(&folder);
    let said = heard.wait_for("not started camera_ray");
    let (_, address) = said.split_once("The page: ").expect("it is told");
    let address = address.lines().next().expect("an address");
    let first = page(address);
    assert!(first.contains("camera_ray</code>: not started"), "{first}");

    let file = folder.join("ch01_rays.py");
    let solution = project("tests/solutions/python/ch01_rays.py");
    let solution = fs::read_to_string(solution).expect("there is a solution");
    fs::write(&file, &solution).expect("it can be written");
    heard.wait_for("right       camera_ray");
    let right = page(address);
    for part in [
        "href=\"#ch01_rays\"",
        "1 Rays: 2 of 2 right",
        "2 High dynamic range: 0 of 3 right",
        "camera_ray</code>: right",
    ] {
        assert!(right.contains(part), "`{part}` is in {right}");
    }
    assert!(!right.contains("role=\"alert\""), "{right}");
    // A pixel of a picture is explained in the page.
    assert!(right.contains("data-exercise=\"camera_ray\" data-explained"));
    for (asked, status, told) in [
        ("camera_ray/6,4", 200, "the pixel in column 6 of row 4"),
        ("camera_ray/9999,4", 400, "there is no pixel 9999,4"),
        ("camera_ray/4", 400, "column and its row"),
        ("ray_at/0,0", 400, "has no picture"),
        ("nothing/0,0", 404, "no such thing"),
    ] {
        let answer = page(&format!("{address}explain/{asked}"));
        let expected = format!("HTTP/1.1 {status}");
        assert!(answer.starts_with(&expected), "{asked}: {answer}");
        assert!(answer.contains(told), "{asked}: {answer}");
    }
    fs::write(&file, "def ray_at(:\n").expect("it can be written");
    heard.wait_for("SyntaxError");
    fs::remove_file(&file).expect("it can be removed");
    heard.wait_for("No module named 'ch01_rays'");
    for i in 0..50 {
        let text = format!("{solution}# save {i}\n");
        fs::write(&file, text).expect("it can be written");
    }
    heard.wait_for("right       camera_ray");
    // A wrong recipe is told, and mended while the watch goes on.
    let recipe = folder.join("raybook.toml");
    let right = fs::read_to_string(&recipe).expect("there is a recipe");
    fs::write(&recipe, "run = 1\n").expect("it can be written");
    heard.wait_for("`run` must be a command");
    let wrong = page(address);
    for part in [
        "role=\"alert\"",
        "`run` must be a command",
        "camera_ray</code>: right",
    ] {
        assert!(wrong.contains(part), "`{part}` is in {wrong}");
    }
    fs::write(&recipe, right).expect("it can be written");
    // Chapter 1 is right: the next is the current one.
    heard.wait_for("not started expose");
    let mended = page(address);
    assert!(mended.contains("id=\"ch02_hdr\""), "{mended}");
    assert!(!mended.contains("role=\"alert\""), "{mended}");

    let sent = Command::new("kill").arg(child.id().to_string()).status();
    assert!(sent.is_ok_and(|sent| sent.success()), "a signal is sent");
    let ended = child.wait().expect("it can be waited for");
    assert_eq!(ended.code(), Some(130), "the signal ends the watch");
    let deadline = Instant::now() + Duration::from_secs(60);
    while is_anybody_in(&folder) {
        assert!(Instant::now() < deadline, "no process is left");
        sleep(Duration::from_millis(20));
    }
}
