//! Numbers by name: a factor of 3.1416 is π.

use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, FRAC_PI_4, LN_2, PI, SQRT_2, TAU};

const NAMES: &[(f64, &str)] = &[
    (PI, "π"),
    (FRAC_1_PI, "1/π: π is missing, or divides once too often"),
    (TAU, "2π"),
    (1.0 / TAU, "1/2π"),
    (4.0 * PI, "4π"),
    (0.25 * FRAC_1_PI, "1/4π"),
    (FRAC_PI_2, "π/2"),
    (2.0 * FRAC_1_PI, "2/π"),
    (FRAC_PI_4, "π/4"),
    (4.0 * FRAC_1_PI, "4/π"),
    (4.0 / 3.0 * PI, "4π/3"),
    (PI * PI, "π²"),
    (180.0 / PI, "180/π: degrees for radians"),
    (PI / 180.0, "π/180: radians for degrees"),
    (SQRT_2, "√2"),
    (0.5 * SQRT_2, "1/√2"),
    (1.732_050_807_568_877_2, "√3"),
    (0.5, "a half"),
    (1.0 / 3.0, "a third"),
    (2.0 / 3.0, "two thirds"),
    (0.25, "a quarter"),
    (1.0 / 6.0, "a sixth"),
    (0.125, "an eighth"),
    (1e3, "a thousand: millimetres for metres"),
    (1e-3, "a thousandth: metres for millimetres"),
    (100.0, "a hundred: centimetres for metres, or per cent"),
    (0.01, "a hundredth"),
    (255.0, "255: as for a byte"),
    (1.0 / 255.0, "1/255: as for a byte"),
    (256.0, "256"),
    (1.0 / 256.0, "1/256"),
    (LN_2, "ln 2"),
    (1.0 / LN_2, "1/ln 2"),
    (2.2, "2.2: a display's gamma"),
    (1.0 / 2.2, "1/2.2: a display's gamma"),
    (2.4, "2.4"),
    (1.0 / 2.4, "1/2.4"),
    (683.0, "683: lumens for watts"),
];

/// The number, with its name if it has one.
pub fn named(v: f64) -> String {
    let close = |name: &&(f64, &str)| (name.0 - v.abs()).abs() <= 1e-3 * name.0;
    let sign = if v < 0.0 { "−" } else { "" };
    let digits = short(v.abs());
    match NAMES.iter().find(close) {
        Some((_, name)) => format!("{sign}{digits} ({name})"),
        None => format!("{sign}{digits}"),
    }
}

/// Whether it is a number that stands in formulas.
pub fn is_known(v: f64) -> bool {
    let v = v.abs();
    let simple = |v: f64| (v - v.round()).abs() <= 1e-3 * v && v.round() >= 1.0 && v < 16.5;
    simple(v)
        || simple(1.0 / v)
        || NAMES
            .iter()
            .any(|(name, _)| (name - v).abs() <= 1e-3 * name)
}

/// A number with at most five digits that count.
pub fn short(v: f64) -> String {
    let rounded: f64 = format!("{v:.4e}").parse().unwrap_or(v);
    if (1e-4..1e6).contains(&rounded.abs()) || rounded == 0.0 {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}
