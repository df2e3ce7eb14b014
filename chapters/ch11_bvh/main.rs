//! `cargo run --release --bin ch11_bvh` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch11_bvh::main()
}
