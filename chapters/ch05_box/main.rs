//! `cargo run --release --bin ch05_box` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch05_box::main()
}
