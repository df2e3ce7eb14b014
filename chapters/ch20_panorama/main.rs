//! `cargo run --release --bin ch20_panorama` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch20_panorama::main()
}
