//! `cargo run --release --bin ch22_antialiasing` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch22_antialiasing::main()
}
