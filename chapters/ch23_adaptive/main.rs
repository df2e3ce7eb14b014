//! `cargo run --release --bin ch23_adaptive` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch23_adaptive::main()
}
