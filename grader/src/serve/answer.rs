//! What a browser is answered: a status, what it may do with the answer, and the answer.

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use raybook_chapters::kit::address;
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::io::{self, Write};

/// What is answered to a request.
#[derive(Clone, Debug)]
pub struct Answer {
    status: &'static str,
    kind: &'static str,
    body: Vec<u8>,
    /// The source of the only script that may run, in the words of a content security policy.
    script: String,
    /// A picture's caption, if it was drawn for this answer.
    caption: Option<String>,
}

const TEXT: &str = "text/plain; charset=utf-8";

impl Answer {
    /// A page with its script, which runs when the page is read. No other script runs, whatever is in the page.
    pub fn page(text: &str, script: &str) -> Self {
        let element = format!("</title><script type=\"module\">{script}</script>");
        let text = text.replacen("</title>", &element, 1);
        Self {
            script: format!(
                "'sha256-{}'",
                BASE64_STANDARD.encode(Sha256::digest(script))
            ),
            ..Self::of("200 OK", "text/html; charset=utf-8", text)
        }
    }

    /// A part of a page, to be put in its place by the page's script.
    pub fn part(html: String) -> Self {
        Self::of("200 OK", "text/html; charset=utf-8", html)
    }

    /// A value as JSON.
    pub fn json(value: &Value) -> Self {
        Self::of("200 OK", "application/json", value.to_string())
    }

    /// The bytes of a PNG file.
    pub fn png(body: Vec<u8>) -> Self {
        Self::of("200 OK", "image/png", body)
    }

    /// The bytes of an SVG file.
    pub fn svg(body: Vec<u8>) -> Self {
        Self::of("200 OK", "image/svg+xml", body)
    }

    /// The same with a caption, in a header of this name.
    #[must_use]
    pub fn captioned(self, caption: &str) -> Self {
        Self {
            caption: Some(caption.to_owned()),
            ..self
        }
    }

    /// The request makes no sense; why.
    pub fn wrong(why: &str) -> Self {
        Self::of("400 Bad Request", TEXT, why)
    }

    /// Something that is not there.
    pub fn unknown() -> Self {
        let why = "there is no such thing here";
        Self::of("404 Not Found", TEXT, why)
    }

    /// Another picture was asked for before this one was drawn. This is no fault: who still wants this one asks again.
    pub fn outdated() -> Self {
        let why = "another picture is wanted now";
        Self::of("202 Accepted", TEXT, why)
    }

    /// What it says, for people.
    pub fn text(&self) -> String {
        String::from_utf8_lossy(&self.body).into_owned()
    }

    pub(super) fn refused(why: &str) -> Self {
        Self::of("403 Forbidden", TEXT, why)
    }

    pub(super) fn method_unknown() -> Self {
        Self::of("405 Method Not Allowed", TEXT, "only GET is answered")
    }

    fn of(status: &'static str, kind: &'static str, body: impl Into<Vec<u8>>) -> Self {
        Self {
            status,
            kind,
            body: body.into(),
            script: "'none'".to_owned(),
            caption: None,
        }
    }

    /// Sends it.
    pub(super) fn write(&self, stream: &mut impl Write) -> io::Result<()> {
        let Self {
            status,
            kind,
            body,
            script,
            caption,
        } = self;
        let caption = caption.as_deref().map_or_else(String::new, |text| {
            format!("Caption: {}\r\n", address::encoded(text))
        });
        let head = format!(
            "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {}\r\nConnection: close\r\nCache-Control: no-store\r\n\
             Content-Security-Policy: default-src 'none'; img-src 'self' blob: data:; connect-src 'self'; style-src 'unsafe-inline'; \
             script-src {script}\r\n\
             Referrer-Policy: no-referrer\r\nX-Content-Type-Options: nosniff\r\nX-Frame-Options: DENY\r\n{caption}\r\n",
            body.len()
        );
        stream.write_all(head.as_bytes())?;
        stream.write_all(body)
    }
}
