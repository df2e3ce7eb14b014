//! `cargo run --release --bin ch19_depth_of_field` draws this chapter's pictures.

fn main() -> std::process::ExitCode {
    raybook_chapters::ch19_depth_of_field::main()
}
