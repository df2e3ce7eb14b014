//! `cargo run --release --bin ch07_mesh` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch07_mesh::main()
}
