//! A server for the browser of this machine, and for nobody else: on 127.0.0.1, under an address that cannot be guessed.
//!
//! The address begins with a random word, so that no other page can guess it. A request under another host's name is refused, so
//! that no other page can borrow it. A page may run its own script, fetch from this server, and nothing else.

mod answer;
mod request;
mod until;

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

#[cfg(test)]
mod tests {
    use super::{Answer, Server};
    use std::io::{Read, Write};
    use std::net::TcpStream;
    use std::thread::spawn;

    /// A server that tells the path and the query that it was asked; its host and its token.
    fn start() -> [String; 2] {
        let server = Server::new(0).expect("there is a port");
        let [host, token] = [server.host.clone(), server.token.clone()];
        assert_eq!(server.address(), format!("http://{host}/{token}/"));
        spawn(|| {
            server.run(|request| match request.path.as_str() {
                "" => Answer::page("<title>t</title>secret", "go()"),
                "told" => Answer::wrong(&format!("secret {:?}", request.query)),
                _ => Answer::unknown(),
            });
        });
        [host, token]
    }

    /// What is answered to a request.
    fn ask(host: &str, request: &str) -> String {
        let mut server = TcpStream::connect(host).expect("it listens");
        server.write_all(request.as_bytes()).expect("it reads");
        let mut answer = String::new();
        server.read_to_string(&mut answer).expect("it answers");
        answer
    }

    #[test]
    fn the_page_is_for_who_knows_its_address() {
        let [host, token] = start();
        assert!(host.starts_with("127.0.0.1:"), "{host} is this machine");
        assert_eq!(token.len(), 32, "{token} is a long word");
        let page = ask(&host, &get(&format!("/{token}/"), &host));
        assert!(page.starts_with("HTTP/1.1 200 OK\r\n"), "{page}");
        assert!(page.ends_with("secret"), "{page}");
        for (path, name) in [
            ("/", host.as_str()),
            ("/told", &host),
            ("/0/", &host),
            ("/00000000000000000000000000000000/", &host),
            (&format!("//{token}/"), &host),
            (&format!("/{token}/"), "evil.example"),
            (&format!("/{token}/"), "localhost"),
            (&format!("/{token}/"), "127.0.0.1"),
        ] {
            let answer = ask(&host, &get(path, name));
            assert!(answer.starts_with("HTTP/1.1 403"), "{name}{path}: {answer}");
            assert!(!answer.contains("secret"), "{name}{path}: {answer}");
        }
    }

    #[test]
    fn only_whole_requests_by_get_are_answered() {
        let [host, token] = start();
        for (request, status) in [
            (
                format!("POST /{token}/ HTTP/1.1\r\nHost: {host}\r\n\r\n"),
                405,
            ),
            ("HEAD / HTTP/1.1\r\nHost: h\r\n\r\n".to_owned(), 405),
            (format!("GET /{token}/ HTTP/1.1\r\n\r\n"), 400),
            (
                format!("GET /{token}/ HTTP/1.1\r\nHost: {host}\r\nHost: evil.example\r\n\r\n"),
                400,
            ),
            (
                format!("GET /{token}/ HTTP/1.1\r\nHost {host}\r\n\r\n"),
                400,
            ),
            ("\r\n\r\n".to_owned(), 400),
            (
                format!(
                    "GET /{token}/ HTTP/1.1\r\nX: {}",
                    "x".repeat((16 << 10) - 60)
                ),
                400,
            ),
        ] {
            // The head is cut off where no more is to come.
            let mut server = TcpStream::connect(&host).expect("it listens");
            server.write_all(request.as_bytes()).expect("it reads");
            server
                .shutdown(std::net::Shutdown::Write)
                .expect("it is open");
            let mut answer = String::new();
            server.read_to_string(&mut answer).expect("it answers");
            let expected = format!("HTTP/1.1 {status} ");
            assert!(answer.starts_with(&expected), "{request:.99}: {answer}");
            assert!(!answer.contains("secret"), "{request:.99}: {answer}");
        }
    }

    #[test]
    fn paths_are_taken_as_they_are_and_queries_are_decoded() {
        let [host, token] = start();
        let below = |path: &str| ask(&host, &get(&format!("/{token}/{path}"), &host));
        for path in [
            "nothing",
            "../told",
            "%74old",
            "told/",
            "/told",
            ".",
            "..%2Ftold",
        ] {
            let answer = below(path);
            assert!(answer.starts_with("HTTP/1.1 404"), "{path}: {answer}");
        }
        let answer = below("told?a=%C3%A4%20b&c=%&d&e=1+2%2B3");
        assert!(
            answer.ends_with("secret [(\"a\", \"ä b\"), (\"c\", \"%\"), (\"e\", \"1 2+3\")]"),
            "{answer}"
        );
    }

    #[test]
    fn a_page_runs_its_own_script_and_fetches_from_here_only() {
        let [host, token] = start();
        let page = ask(&host, &get(&format!("/{token}/"), &host));
        for part in [
            "default-src 'none';",
            "connect-src 'self';",
            // printf 'go()' | openssl dgst -sha256 -binary | base64
            "script-src 'sha256-5KYv+PUboo5h+0+YAtGRPbwv5d/QxzHslP4YGnUaxRw='",
            "Cache-Control: no-store",
            "X-Frame-Options: DENY",
            "</title><script type=\"module\">go()</script>",
        ] {
            assert!(page.contains(part), "`{part}` is in {page}");
        }
        let other = ask(&host, &get(&format!("/{token}/told"), &host));
        assert!(other.contains("script-src 'none'"), "{other}");
    }

    fn get(path: &str, host: &str) -> String {
        format!("GET {path} HTTP/1.1\r\nHost: {host}\r\n\r\n")
    }
}
