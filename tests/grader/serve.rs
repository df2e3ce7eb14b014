//! The server for the browser of this machine.

mod server;
mod until;
