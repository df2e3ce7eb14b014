//! `cargo run --release --bin ch15_shadows` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch15_shadows::main()
}
