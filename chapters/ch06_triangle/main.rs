//! `cargo run --release --bin ch06_triangle` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch06_triangle::main()
}
