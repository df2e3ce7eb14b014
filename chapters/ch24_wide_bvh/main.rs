//! `cargo run --release --bin ch24_wide_bvh` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch24_wide_bvh::main()
}
