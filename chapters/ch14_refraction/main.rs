//! `cargo run --release --bin ch14_refraction` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch14_refraction::main()
}
