//! A server for the browser of this machine, and for nobody else: on 127.0.0.1, under an address that cannot be guessed.
//!
//! The address begins with a random word, so that no other page can guess it. A request under another host's name is refused, so
//! that no other page can borrow it. A page may run its own script, fetch from this server, and nothing else.

mod answer;
mod request;
pub(crate) mod until;

pub use answer::Answer;
pub use request::Request;

use std::collections::hash_map::RandomState;
use std::hash::{BuildHasher, Hasher};
use std::io;
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::sync::Arc;
use std::thread::{Builder, sleep};
use std::time::Duration;
use until::Until;

/// How long a browser may take to send its request, and to take the answer.
const PATIENCE: Duration = Duration::from_secs(10);
/// Answers under way at most: a browser asks for a few.
const MOST: usize = 64;

/// How long to wait when no more connections can be open.
const PAUSE: Duration = Duration::from_millis(100);

/// A port of this machine, and the random word that a browser must know.
#[derive(Debug)]
pub struct Server {
    listener: TcpListener,
    /// The only name under which the server may be asked: 127.0.0.1 and its port.
    host: String,
    /// The first part of every path.
    token: String,
}

impl Server {
    /// Takes a port; 0 is any that is free.
    ///
    /// # Errors
    /// If the port is not free.
    pub fn new(port: u16) -> io::Result<Self> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
        let host = listener.local_addr()?.to_string();
        Ok(Self {
            listener,
            host,
            token: random_word(),
        })
    }

    /// The address of the first page: `http://127.0.0.1:8000/TOKEN/`.
    pub fn address(&self) -> String {
        format!("http://{}/{}/", self.host, self.token)
    }

    /// Answers requests until the command ends, each in a thread of its own: a silent browser keeps no other waiting.
    pub fn run(self, answer: impl Fn(&Request) -> Answer + Send + Sync + 'static) {
        let Self {
            listener,
            host,
            token,
        } = self;
        let answer =
            Arc::new(
                move |stream: &TcpStream| match Request::read(Until::new(stream, PATIENCE)) {
                    Ok(request) => refusal(&request, &host, &token)
                        .unwrap_or_else(|| answer(&request.below(&token))),
                    Err(refused) => refused,
                },
            );
        for stream in listener.incoming() {
            let Ok(stream) = stream else {
                sleep(PAUSE);
                continue;
            };
            if Arc::strong_count(&answer) > MOST {
                continue; // that many answers are under way: who asks again is answered
            }
            let answer = Arc::clone(&answer);
            let told = Builder::new().spawn(move || -> io::Result<()> {
                answer(&stream).write(&mut Until::new(&stream, PATIENCE))
            });
            if told.is_err() {
                sleep(PAUSE); // no thread can be had
            }
        }
    }
}

/// Why a request is refused; none if it comes under the right name and begins with the token.
fn refusal(request: &Request, host: &str, token: &str) -> Option<Answer> {
    // Of the port that pages have by default, browsers are silent.
    let is_host = request.host == host || host.strip_suffix(":80") == Some(&request.host);
    if !is_host {
        let why = "this page is on this machine only, and has another name";
        Some(Answer::refused(why))
    } else if request.parts().next() != Some(token) {
        let why = "the address is not complete: the command in the terminal printed it";
        Some(Answer::refused(why))
    } else {
        None
    }
}

/// 32 digits that nobody foresees: hashes under keys that the system chose at random.
fn random_word() -> String {
    let half = || RandomState::new().build_hasher().finish();
    format!("{:016x}{:016x}", half(), half())
}
