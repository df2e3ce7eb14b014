//! `cargo run --release --bin ch18_environment` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch18_environment::main()
}
