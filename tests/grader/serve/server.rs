//! Who is answered, and what.

use raybook_grader::serve::{Answer, Server};
use std::io::{Read, Write};
use std::net::TcpStream;
use std::thread::spawn;

/// A server that tells the path and the query that it was asked; its host and its token.
fn start() -> [String; 2] {
    let server = Server::new(0).expect("there is a port");
    let address = server.address();
    let words = address
        .strip_prefix("http://")
        .and_then(|rest| rest.strip_suffix('/')?.split_once('/'));
    let (host, token) = words.expect("a host and a token");
    let told = [host, token].map(str::to_owned);
    spawn(|| {
        server.run(|request| match request.path.as_str() {
            "" => Answer::page("<title>t</title>secret", "go()"),
            "told" => Answer::wrong(&format!("secret {:?}", request.query)),
            _ => Answer::unknown(),
        });
    });
    told
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
