//! Phong's model, into which tests put a slip.

use glam::DVec3;

/// What the model is made of, at a point that is lit.
#[derive(Clone, Copy)]
pub struct Phong {
    /// L·N.
    pub height: f64,
    /// (R·V)^α.
    pub shine: f64,
    /// The light's radiance.
    pub i: DVec3,
    /// The colour of the diffuse part.
    pub k_d: DVec3,
    /// The colour of the highlight.
    pub k_s: DVec3,
}

/// The answer to a question of `phong`; `sum` is made of the diffuse part and the highlight, for a light of 1.
pub fn phong(q: &[f64], sum: impl Fn(Phong) -> DVec3) -> Vec<f64> {
    let [n, v, l, i, k_d, k_s] = [0, 3, 6, 9, 12, 15].map(|from| DVec3::from_slice(&q[from..]));
    let height = n.dot(l);
    let cosine = (2.0 * height * n - l).dot(v);
    let shine = if cosine > 0.0 {
        cosine.powf(q[18])
    } else {
        0.0
    };
    let at = Phong {
        height,
        shine,
        i,
        k_d,
        k_s,
    };
    let light = if height > 0.0 {
        sum(at) * i
    } else {
        DVec3::ZERO
    };
    light.to_array().to_vec()
}
