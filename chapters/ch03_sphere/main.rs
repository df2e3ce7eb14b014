//! `cargo run --release --bin ch03_sphere` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch03_sphere::main()
}
