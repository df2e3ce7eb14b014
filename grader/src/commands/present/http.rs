//! As much of HTTP as a page on this machine needs: a request without a body, an answer, and good-bye.

use serde_json::Value;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::time::Duration;

/// A request's head may be so long, in bytes.
const LONGEST: u64 = 16 << 10;

/// What is asked, without the method, which is GET.
#[derive(Debug)]
pub(super) struct Request {
    /// The name by which the server is asked: `127.0.0.1:8000`.
    pub host: String,
    /// The path, as it was sent.
    pub path: String,
    /// What follows the question mark, decoded: names and values.
    pub query: Vec<(String, String)>,
}

/// What is answered.
#[derive(Debug)]
pub(super) struct Answer {
    status: &'static str,
    kind: &'static str,
    body: Vec<u8>,
    /// A picture's caption, if it was drawn for this answer.
    caption: Option<String>,
}

impl Answer {
    pub(super) fn page(text: &str) -> Self {
        Self::of("200 OK", "text/html; charset=utf-8", text)
    }

    pub(super) fn json(value: &Value) -> Self {
        Self::of("200 OK", "application/json", &value.to_string())
    }

    pub(super) fn png(body: Vec<u8>) -> Self {
        let (status, kind, caption) = ("200 OK", "image/png", None);
        Self {
            status,
            kind,
            body,
            caption,
        }
    }

    pub(super) fn captioned(self, caption: &str) -> Self {
        Self {
            caption: Some(caption.to_owned()),
            ..self
        }
    }

    /// The request makes no sense; why.
    pub(super) fn wrong(why: &str) -> Self {
        Self::of("400 Bad Request", TEXT, why)
    }

    pub(super) fn refused(why: &str) -> Self {
        Self::of("403 Forbidden", TEXT, why)
    }

    pub(super) fn unknown() -> Self {
        Self::of("404 Not Found", TEXT, "there is no such thing here")
    }

    /// Another picture was asked for before this one was drawn.
    pub(super) fn outdated() -> Self {
        Self::of("409 Conflict", TEXT, "another picture is wanted now")
    }

    /// What it says, for people.
    pub(super) fn text(&self) -> String {
        String::from_utf8_lossy(&self.body).into_owned()
    }

    fn of(status: &'static str, kind: &'static str, text: &str) -> Self {
        let body = text.as_bytes().to_vec();
        Self {
            status,
            kind,
            body,
            caption: None,
        }
    }
}

const TEXT: &str = "text/plain; charset=utf-8";

/// What a browser may do with the page: run what is in it, ask this server, and nothing else.
const POLICY: &str = "default-src 'none'; img-src 'self' blob:; connect-src 'self'; style-src 'unsafe-inline'; script-src 'unsafe-inline'";

/// Answers one request. A browser that goes away is no fault.
pub(super) fn serve(mut stream: TcpStream, answer: impl FnOnce(&Request) -> Answer) {
    let patience = Some(Duration::from_secs(10));
    if stream.set_read_timeout(patience).is_err() || stream.set_write_timeout(patience).is_err() {
        return;
    }
    let answer = match read(&stream) {
        Some(request) => answer(&request),
        None => Answer::wrong("a request that begins with GET, and names its host"),
    };
    let Answer {
        status,
        kind,
        body,
        caption,
    } = answer;
    let caption = caption.map_or_else(String::new, |text| {
        format!("Caption: {}\r\n", encode(&text))
    });
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {}\r\nContent-Security-Policy: {POLICY}\r\n\
         X-Content-Type-Options: nosniff\r\nReferrer-Policy: no-referrer\r\nCache-Control: no-store\r\nConnection: close\r\n{caption}\r\n",
        body.len()
    );
    let _ = stream
        .write_all(head.as_bytes())
        .and_then(|()| stream.write_all(&body));
}

/// The request, if it is one of those that are answered.
fn read(stream: &TcpStream) -> Option<Request> {
    let mut lines = BufReader::new(stream.take(LONGEST)).lines();
    let first = lines.next()?.ok()?;
    let target = first.strip_prefix("GET ")?.split(' ').next()?.to_owned();
    let mut host = None;
    loop {
        let line = lines.next()?.ok()?;
        if line.is_empty() {
            break;
        }
        let (name, value) = line.split_once(':')?;
        if name.eq_ignore_ascii_case("host") && host.replace(value.trim().to_owned()).is_some() {
            return None; // two hosts: one of them is a lie
        }
    }
    let (path, query) = target.split_once('?').unwrap_or((&target, ""));
    let pairs = query.split('&').filter_map(|pair| pair.split_once('='));
    let query = pairs
        .map(|(name, value)| (decode(name), decode(value)))
        .collect();
    Some(Request {
        host: host?,
        path: path.to_owned(),
        query,
    })
}

/// Text of letters alone: every other byte as `%` and two digits.
fn encode(text: &str) -> String {
    let code = |byte: u8| match byte {
        byte if byte.is_ascii_alphanumeric() => char::from(byte).to_string(),
        byte => format!("%{byte:02X}"),
    };
    text.bytes().map(code).collect()
}

/// Text in which other characters than letters may stand as `%` and two digits.
fn decode(text: &str) -> String {
    let mut bytes = Vec::new();
    let mut rest = text.as_bytes();
    while let [first, after @ ..] = rest {
        let digits = after.get(..2).and_then(|two| str::from_utf8(two).ok());
        let code = digits.and_then(|two| u8::from_str_radix(two, 16).ok());
        let (byte, taken) = match (first, code) {
            (b'%', Some(code)) => (code, 3),
            _ => (*first, 1),
        };
        bytes.push(byte);
        rest = &rest[taken..];
    }
    String::from_utf8_lossy(&bytes).into_owned()
}
