//! A page for the browser of this machine, and for nobody else: on 127.0.0.1, under an address that cannot be guessed.
//!
//! The browser asks every second whether the page is another one, and lays its new text in where the old one was.

use raybook::store;
use std::hash::{BuildHasher, RandomState};
use std::io::{self, Read, Write};
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread::{sleep, spawn};
use std::time::Duration;

/// A browser that says nothing for so long is not waited for.
const PATIENCE: Duration = Duration::from_secs(5);
/// Longer requests are none of a browser's.
const LONGEST: u64 = 1 << 14;

/// What is sent instead of a page that is not there yet.
const NOTHING_YET: &str = "<!DOCTYPE html><html lang=\"en\"><title>raybook</title><main><h1>raybook</h1><p>The first check is not done yet.</p></main></html>";

/// Asks for the page again and again, and shows what has changed; places where the reader has opened something stay open.
const RENEW: &str = "
let shown = null;
async function renew() {
  try {
    const text = await (await fetch(location.href, { cache: 'no-store' })).text();
    if (shown !== null && text !== shown) {
      const open = [...document.querySelectorAll('details')].map((d) => d.open);
      const page = new DOMParser().parseFromString(text, 'text/html');
      document.title = page.title;
      document.body.replaceChildren(...page.body.childNodes);
      document.querySelectorAll('details').forEach((d, i) => { d.open = open[i] || false; });
    }
    shown = text;
  } catch {}
  setTimeout(renew, 1000);
}
renew();
";

/// A file that is served.
#[derive(Debug)]
struct Served {
    file: PathBuf,
    host: String,
    path: String,
}

/// Serves a page as it is in its file at any time, until the command ends; returns its address.
///
/// # Errors
/// If the system gives no port.
pub fn serve(file: &Path) -> io::Result<String> {
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0))?;
    let host = listener.local_addr()?.to_string();
    // The keys of the two hashes come from the system's random numbers.
    let part = || RandomState::new().hash_one(std::process::id());
    let path = format!("/{:016x}{:016x}/", part(), part());
    let address = format!("http://{host}{path}");
    let file = file.to_owned();
    let served = Arc::new(Served { file, host, path });
    spawn(move || {
        for browser in listener.incoming() {
            match browser {
                Ok(browser) => {
                    let served = Arc::clone(&served);
                    // One that keeps silent must not keep the others waiting; and one that goes away has lost nothing.
                    spawn(move || drop(served.answer(&browser)));
                }
                // No more files can be open for now.
                Err(_) => sleep(Duration::from_millis(100)),
            }
        }
    });
    Ok(address)
}

impl Served {
    fn answer(&self, mut browser: &TcpStream) -> io::Result<()> {
        browser.set_read_timeout(Some(PATIENCE))?;
        browser.set_write_timeout(Some(PATIENCE))?;
        let Some(head) = head(browser)? else {
            return Ok(());
        };
        let (status, page) = match self.refusal(&head) {
            Some(status) => (status, String::new()),
            None => ("200 OK", self.page()),
        };
        let length = page.len();
        // The page fetches nothing but itself, and no script runs but the one above.
        let text = format!(
            "HTTP/1.1 {status}\r\nContent-Type: text/html; charset=utf-8\r\nContent-Length: {length}\r\nConnection: close\r\n\
             Cache-Control: no-store\r\nReferrer-Policy: no-referrer\r\nX-Content-Type-Options: nosniff\r\nX-Frame-Options: DENY\r\n\
             Content-Security-Policy: default-src 'none'; img-src data:; style-src 'unsafe-inline'; connect-src 'self'; script-src 'nonce-{}'\r\n\
             \r\n{page}",
            self.nonce()
        );
        browser.write_all(text.as_bytes())
    }

    /// Why a request is refused; none if it asks for the page at its address.
    fn refusal(&self, head: &str) -> Option<&'static str> {
        let mut lines = head.lines();
        let mut words = lines.next().unwrap_or_default().split(' ');
        let [method, path] = [(); 2].map(|()| words.next().unwrap_or_default());
        let is_host = |line: &str| {
            let (name, value) = line.split_once(':').unwrap_or_default();
            (name.eq_ignore_ascii_case("host")).then(|| value.trim() == self.host)
        };
        let hosts: Vec<_> = lines.filter_map(is_host).collect();
        // Another site's name that leads here would make its scripts the page's own.
        if hosts != [true] {
            Some("421 Misdirected Request")
        } else if path != self.path {
            Some("404 Not Found")
        } else if method != "GET" {
            Some("405 Method Not Allowed")
        } else {
            None
        }
    }

    /// The page in its file, with the script that renews it.
    fn page(&self) -> String {
        let page = store::read_text(&self.file).unwrap_or_else(|_| NOTHING_YET.to_owned());
        let script = format!("<script nonce=\"{}\">{RENEW}</script>", self.nonce());
        // In the head, which stays where it is.
        page.replacen("</title>", &format!("</title>{script}"), 1)
    }

    /// What only the page's own script has.
    fn nonce(&self) -> &str {
        self.path.trim_matches('/')
    }
}

/// The head of a request; none if there is no whole one.
fn head(browser: &TcpStream) -> io::Result<Option<String>> {
    let mut bytes = Vec::new();
    let mut limited = browser.take(LONGEST);
    let mut part = [0; 1 << 10];
    while !bytes.windows(4).any(|end| end == b"\r\n\r\n") {
        match limited.read(&mut part)? {
            0 => return Ok(None),
            n => bytes.extend_from_slice(&part[..n]),
        }
    }
    Ok(Some(String::from_utf8_lossy(&bytes).into_owned()))
}

#[cfg(test)]
mod tests {
    use super::serve;
    use raybook::store;
    use std::io::{Read, Write};
    use std::net::TcpStream;

    /// What is answered to a request.
    fn ask(host: &str, request: &str) -> String {
        let mut server = TcpStream::connect(host).expect("it listens");
        server.write_all(request.as_bytes()).expect("it reads");
        let mut answer = String::new();
        server.read_to_string(&mut answer).expect("it answers");
        answer
    }

    #[test]
    fn only_who_knows_the_address_sees_the_page() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let file = folder.path().join("page.html");
        let address = serve(&file).expect("there is a port");
        let (host, path) = address["http://".len()..].split_once('/').expect("a path");
        assert!(
            host.starts_with("127.0.0.1:") && path.len() == 33,
            "{address}"
        );
        let get = |path: &str, host_line: &str| {
            ask(
                host,
                &format!("GET /{path} HTTP/1.1\r\nHost: {host_line}\r\n\r\n"),
            )
        };
        assert!(get(path, host).contains("not done yet"), "no page yet");
        store::write(&file, b"<title>t</title>one").expect("it can be written");
        let answer = get(path, host);
        assert!(
            answer.starts_with("HTTP/1.1 200") && answer.ends_with("</script>one"),
            "{answer}"
        );
        store::write(&file, b"<title>t</title>two").expect("it can be written");
        assert!(get(path, host).ends_with("two"), "it is read each time");
        for (path, host_line, status) in [
            ("", host, "404"),
            ("0/", host, "404"),
            (path, "evil.example", "421"),
            (path, "localhost", "421"),
        ] {
            let answer = get(path, host_line);
            assert!(
                answer.starts_with(&format!("HTTP/1.1 {status}")),
                "{answer}"
            );
            assert!(!answer.contains("two"), "nothing is told: {answer}");
        }
        let posted = ask(
            host,
            &format!("POST /{path} HTTP/1.1\r\nHost: {host}\r\n\r\n"),
        );
        assert!(posted.starts_with("HTTP/1.1 405"), "{posted}");
    }
}
