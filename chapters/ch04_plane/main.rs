//! `cargo run --release --bin ch04_plane` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch04_plane::main()
}
