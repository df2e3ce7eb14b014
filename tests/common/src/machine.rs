//! The machine on which something is measured: every table and picture of a benchmark names it.

/// What the system says of the processor: "processor: AMD EPYC, family 26, model 2 (2 of them), with avx2, fma, avx512f".
pub fn processor() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let field = |name: &str| {
        let line = text.lines().find(|line| line.starts_with(name));
        let value = line.and_then(|line| line.split_once(": "));
        value.map_or("unknown", |(_, value)| value)
    };
    let has = |one: &&str| field("flags").split(' ').any(|flag| flag == *one);
    let has: Vec<_> = ["avx2", "fma", "avx512f"].into_iter().filter(has).collect();
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    format!(
        "processor: {}, family {}, model {} ({cores} of them), with {}",
        field("model name"),
        field("cpu family"),
        field("model\t"),
        has.join(", ")
    )
}

/// The head of a table: each line as a comment.
pub fn comments(lines: &[String]) -> String {
    let add = |text: String, line: &String| text + "# " + line + "\n";
    lines.iter().fold(String::new(), add)
}
