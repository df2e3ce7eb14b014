//! `cargo run --release --bin ch21_black_hole` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch21_black_hole::main()
}
