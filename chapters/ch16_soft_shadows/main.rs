//! `cargo run --release --bin ch16_soft_shadows` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch16_soft_shadows::main()
}
