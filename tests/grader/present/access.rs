//! Who gets something from the page's server, and what.

use super::Server;
use std::fs;

#[test]
fn a_page_of_another_host_or_without_the_token_gets_nothing() {
    let server = Server::start();
    assert_eq!(server.token.len(), 32, "a long word");
    let page = format!("/{}/", server.token);
    assert_eq!(server.get("").0, 200, "who knows the address sees the page");
    for (host, path, status) in [
        (server.host.as_str(), "/", 403),
        (&server.host, "/course.json", 403),
        (&server.host, "/00000000000000000000000000000000/", 403),
        ("evil.example", &page, 403),
        ("127.0.0.1", &page, 403),
    ] {
        let (answered, body) = server.get_of(host, path);
        assert_eq!(answered, status, "{host}{path}");
        assert!(!body.starts_with(b"<!doctype"), "{host}{path}: no page");
    }
    let host = &server.host;
    for broken in [
        format!("GET {page} HTTP/1.1\r\n\r\n"),
        format!("GET {page} HTTP/1.1\r\nHost: {host}\r\nHost: evil.example\r\n\r\n"),
        "\r\n\r\n".to_owned(),
    ] {
        assert_eq!(server.send(&broken).0, 400, "{broken}");
    }
    let posted = format!("POST {page} HTTP/1.1\r\nHost: {host}\r\n\r\n");
    assert_eq!(server.send(&posted).0, 405, "only GET is answered");
}

#[test]
fn what_is_not_there_is_not_found_and_no_path_leaves_the_folder() {
    let server = Server::start();
    fs::write(server.out.path().join("secret.png"), "secret").expect("it can be written");
    for path in [
        "nothing",
        "screens/ch99_nothing",
        "screens/../../etc/passwd",
        "picture/ch03_sphere",
        "picture/ch03_sphere/",
        "picture/ch03_sphere/../secret",
        "picture/ch03_sphere/..%2Fsecret",
        "picture/../secret/picture",
        "picture/ch03_sphere/%2e%2e",
        "../course.json",
    ] {
        let (status, body) = server.get(path);
        assert_eq!(status, 404, "{path}: {}", String::from_utf8_lossy(&body));
    }
}
