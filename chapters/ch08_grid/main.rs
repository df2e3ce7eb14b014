//! `cargo run --release --bin ch08_grid` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch08_grid::main()
}
