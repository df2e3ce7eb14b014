//! `cargo run --release --bin ch25_capstone` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch25_capstone::main()
}
