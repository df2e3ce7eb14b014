//! Chapter 22.
use raybook::math::pcg;
use raybook::sample::pattern::{
    PATTERNS, dart_throwing::largest_distance, neighbours::Space, poisson_disk,
};
use std::time::Instant;
#[test]
fn probe() {
    for p in PATTERNS {
        for n in [0, 1, 2, 3, 4, 5, 7, 16, 100, 1000, 100_000, 1_000_000] {
            let t = Instant::now();
            let pts = (p.points)(n, &mut pcg::stream(1, 2));
            let e = t.elapsed().as_secs_f32();
            assert_eq!(pts.len(), n, "{}", p.name);
            assert!(
                pts.iter()
                    .all(|p| p.x >= 0.0 && p.x < 1.0 && p.y >= 0.0 && p.y < 1.0),
                "{} {n}",
                p.name
            );
            if n >= 100_000 {
                println!("{} {n} {e}", p.name);
            }
            if n <= 5 {
                println!("{} {:?}", p.name, pts);
            }
        }
    }
    for n in [4, 9, 16, 64, 256, 1024, 10000] {
        let mut frac = vec![];
        for s in 0..100 {
            frac.push(
                poisson_disk::poisson_disk(
                    largest_distance(n) as f32 * 0.8,
                    Space::Torus,
                    &mut pcg::stream(s, 3),
                )
                .len() as f64
                    / n as f64,
            );
        }
        frac.sort_by(f64::total_cmp);
        println!("n {n}: {} {} {}", frac[0], frac[50], frac[99]);
    }
    for r in [0.3f32, 0.2, 0.1, 0.05, 0.02] {
        let c: Vec<_> = (0..50)
            .map(|s| {
                poisson_disk::poisson_disk(r, Space::Square, &mut pcg::stream(s, 3)).len() as f32
                    * r
                    * r
                    / ((1.0 + r) * (1.0 + r))
            })
            .collect();
        println!(
            "r {r}: {:?}",
            (
                c.iter().copied().fold(9.0, f32::min),
                c.iter().copied().fold(0.0, f32::max)
            )
        );
    }
}
