//! Answer programs in awk.

/// Right for every pattern but the Poisson disk, which is not written yet.
pub const RIGHT: &str = r#"
function put(x, y) { row = row sprintf(" %.7f %.7f", x, y) }
function say(n) { print "= " n row; row = "" }
$1 == "regular_grid" {
    for (j = 0; j < $5; j++) for (i = 0; i < $4; i++) put($2 + (i + 0.5) / $4, $3 + (j + 0.5) / $5)
    say($4 * $5)
}
$1 == "rotated_grid" {
    n = 0; r = int(1 / $2) + 3
    for (j = -r; j <= r; j++) for (i = -r; i <= r; i++) {
        a = i + $3; b = j + $4
        x = 0.5 + $2 * (2 * a - b) / sqrt(5); y = 0.5 + $2 * (a + 2 * b) / sqrt(5)
        if (x >= 0 && x < 1 && y >= 0 && y < 1) { put(x, y); n++ }
    }
    say(n)
}
$1 == "random_pattern" { srand($3 + 7); for (i = 0; i < $2; i++) put(rand(), rand()); say($2) }
$1 == "jittered" {
    srand($4 + 7)
    for (j = 0; j < $3; j++) for (i = 0; i < $2; i++) put((i + rand()) / $2, (j + rand()) / $3)
    say($2 * $3)
}
$1 == "poisson_disk" { print "= todo poisson_disk" }
"#;

/// Jittered points that stay in the first quarter of their cells.
pub const CLUMPED: &str = r#"
{
    srand($4); row = ""
    for (j = 0; j < $3; j++) for (i = 0; i < $2; i++)
        row = row " " (int(i / 4) * 4 + 0.3 * rand()) / $2 " " (int(j / 4) * 4 + 0.3 * rand()) / $3
    print "= " $2 * $3 row
}
"#;

/// A Poisson disk by darts: until `misses` in a row have missed, and with distances `times` times as large as asked.
pub fn darts(misses: u32, times: f32) -> String {
    format!(
        r#"{{
    srand($3 + 1); n = 0; miss = 0; row = ""; d = {times} * $2
    while (miss < {misses}) {{
        x = rand(); y = rand(); miss++; free = 1
        for (i = 0; i < n && free; i++) if ((x - X[i]) ^ 2 + (y - Y[i]) ^ 2 < d * d) free = 0
        if (free) {{ X[n] = x; Y[n] = y; n++; miss = 0; row = row " " x " " y }}
    }}
    print "= " n row
}}"#
    )
}
