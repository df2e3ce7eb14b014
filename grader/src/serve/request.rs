//! What a browser asks: a request without a body.

use super::Answer;
use std::io::{BufRead, BufReader, Read};

/// The longest head of a request, in bytes.
const LONGEST: u64 = 16 << 10;

/// What is asked, without the method, which is GET.
#[derive(Debug)]
pub struct Request {
    /// The name by which the server is asked: `127.0.0.1:8000`.
    pub(super) host: String,
    /// The path below the token, as it was sent.
    pub path: String,
    /// What follows the question mark, decoded: names and values.
    pub query: Vec<(String, String)>,
}

impl Request {
    /// Reads a request, or tells why it is refused.
    pub(super) fn read(stream: impl Read) -> Result<Self, Answer> {
        let mut lines = BufReader::new(stream.take(LONGEST)).lines();
        let wrong = || Answer::wrong("a request begins with GET and a path, and names its host");
        let mut line = || lines.next().and_then(Result::ok).ok_or_else(wrong);
        let first = line()?;
        let mut words = first.split(' ');
        let (Some(method), Some(target)) = (words.next(), words.next()) else {
            return Err(wrong());
        };
        if method != "GET" {
            return Err(Answer::method_unknown());
        }
        let mut host = None;
        loop {
            let line = line()?;
            if line.is_empty() {
                break;
            }
            let (name, value) = line.split_once(':').ok_or_else(wrong)?;
            if name.eq_ignore_ascii_case("host") && host.replace(value.trim().to_owned()).is_some()
            {
                return Err(wrong()); // two hosts: one of them is a lie
            }
        }
        let (path, query) = target.split_once('?').unwrap_or((target, ""));
        let pairs = query.split('&').filter_map(|pair| pair.split_once('='));
        let query = pairs
            .map(|(name, value)| (decode(name), decode(value)))
            .collect();
        Ok(Self {
            host: host.ok_or_else(wrong)?,
            path: path.to_owned(),
            query,
        })
    }

    /// The parts of the path between its slashes.
    pub(super) fn parts(&self) -> impl Iterator<Item = &str> {
        let path = self.path.strip_prefix('/').unwrap_or_default();
        path.split('/')
    }

    /// The same request with the path below the token.
    pub(super) fn below(self, token: &str) -> Self {
        let path = self.path.strip_prefix('/').unwrap_or_default();
        let path = path.strip_prefix(token).unwrap_or_default();
        let path = path.strip_prefix('/').unwrap_or_default().to_owned();
        Self { path, ..self }
    }
}

/// A word of a query, in which a space stands as `+`, and other characters than letters may stand as `%` and two digits.
fn decode(text: &str) -> String {
    let mut bytes = Vec::new();
    let mut rest = text.as_bytes();
    while let [first, after @ ..] = rest {
        let digits = after.get(..2).and_then(|two| str::from_utf8(two).ok());
        let code = digits.and_then(|two| u8::from_str_radix(two, 16).ok());
        let (byte, taken) = match (first, code) {
            (b'%', Some(code)) => (code, 3),
            (b'+', _) => (b' ', 1),
            _ => (*first, 1),
        };
        bytes.push(byte);
        rest = &rest[taken..];
    }
    String::from_utf8_lossy(&bytes).into_owned()
}
