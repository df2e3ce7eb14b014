//! `cargo run --release --bin ch02_hdr` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch02_hdr::main()
}
