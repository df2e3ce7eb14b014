//! `cargo run --release --bin ch09_two_level_grid` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch09_two_level_grid::main()
}
