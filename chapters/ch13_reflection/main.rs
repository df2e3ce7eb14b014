//! `cargo run --release --bin ch13_reflection` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch13_reflection::main()
}
