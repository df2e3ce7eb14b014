//! `cargo run --release --bin ch17_rendering_equation` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch17_rendering_equation::main()
}
