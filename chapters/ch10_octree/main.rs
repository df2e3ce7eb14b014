//! `cargo run --release --bin ch10_octree` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch10_octree::main()
}
