//! `cargo run --release --bin ch01_rays` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch01_rays::main()
}
