//! `raybook present`, asked as a browser asks it, and as another page might try.

mod access;
mod command;
mod pictures;
mod turns;

use raybook::image::file;
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};
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
