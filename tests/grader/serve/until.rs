//! Connections with a deadline.

use raybook_grader::inside::Until;
use std::io::{ErrorKind, Read, Write};
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::thread::{sleep, spawn};
use std::time::Duration;

/// Both ends of a connection.
fn connection() -> (TcpStream, TcpStream) {
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).expect("there is a port");
    let address = listener.local_addr().expect("it has an address");
    let near = TcpStream::connect(address).expect("it listens");
    (near, listener.accept().expect("somebody connects").0)
}

#[test]
fn nothing_is_read_or_written_after_the_end_even_if_it_could_be() {
    let (mut browser, server) = connection();
    browser.write_all(b"GET").expect("it is taken");
    let mut over = Until::new(&server, Duration::ZERO);
    let read = over.read(&mut [0; 3]).map_err(|error| error.kind());
    assert_eq!(read, Err(ErrorKind::TimedOut));
    let written = over.write(b"no").map_err(|error| error.kind());
    assert_eq!(written, Err(ErrorKind::TimedOut));
}

#[test]
fn who_sends_a_byte_now_and_then_is_not_waited_for() {
    let (mut browser, server) = connection();
    spawn(move || {
        // Until the other end is closed.
        while browser.write_all(b"x").is_ok() {
            sleep(Duration::from_millis(5));
        }
    });
    let mut all = Vec::new();
    let read = Until::new(&server, Duration::from_millis(50)).read_to_end(&mut all);
    assert!(read.is_err() && !all.is_empty(), "{} bytes", all.len());
}
