//! `cargo run --release --bin ch12_phong` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch12_phong::main()
}
