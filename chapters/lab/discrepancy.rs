//! How evenly points fill the square, in numbers.

use glam::Vec2;

/// The L₂ star discrepancy, squared: the mean, over all boxes from the origin, of (share of points in it − its area)².
///
/// (L₂*)² = 1/9 − 2/N Σ Π (1 − x²)/2 + 1/N² ΣΣ Π (1 − max(x, x')) (Warnock 1972).
pub fn l2_star_squared(points: &[Vec2]) -> f64 {
    let n = points.len() as f64;
    let single = |p: &Vec2| {
        let p = p.as_dvec2();
        0.25 * (1.0 - p.x * p.x) * (1.0 - p.y * p.y)
    };
    let pair = |p: &Vec2, q: &Vec2| (1.0 - p.as_dvec2().max(q.as_dvec2())).element_product();
    let singles: f64 = points.iter().map(single).sum();
    let pairs: f64 = points
        .iter()
        .map(|p| points.iter().map(|q| pair(p, q)).sum::<f64>())
        .sum();
    1.0 / 9.0 - 2.0 / n * singles + pairs / (n * n)
}

/// The star discrepancy: the largest |share of points in a box from the origin − its area|.
///
/// The largest difference is at a box whose right side and top pass through points, which count or do not count; so N² boxes are
/// compared (Niederreiter 1972).
pub fn star(points: &[Vec2]) -> f64 {
    let n = points.len() as f64;
    let mut by_x: Vec<_> = points.iter().map(|p| p.as_dvec2()).collect();
    by_x.sort_by(|p, q| p.x.total_cmp(&q.x));
    let mut ys: Vec<f64> = Vec::new(); // of all points further left, sorted
    let mut worst: f64 = 0.0;
    let mut all_ys: Vec<_> = by_x.iter().map(|p| p.y).collect();
    all_ys.sort_by(f64::total_cmp);
    all_ys.push(1.0);
    for i in 0..=by_x.len() {
        let x = by_x.get(i).map_or(1.0, |p| p.x);
        // Open boxes, which end before this point …
        let mut below = 0;
        for &y in &all_ys {
            while below < ys.len() && ys[below] < y {
                below += 1;
            }
            worst = worst.max(x * y - below as f64 / n);
        }
        // … and closed ones, with it.
        if let Some(p) = by_x.get(i) {
            let at = ys.partition_point(|&y| y < p.y);
            ys.insert(at, p.y);
        }
        let mut up_to = 0;
        for &y in &all_ys {
            while up_to < ys.len() && ys[up_to] <= y {
                up_to += 1;
            }
            worst = worst.max(up_to as f64 / n - x * y);
        }
    }
    worst
}
