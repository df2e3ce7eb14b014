//! Less noise in a picture of random samples: each pixel becomes a mean of those around it that differ by no more than noise.

use crate::image::{Image, rgb::Rgb};
use crate::threads;

/// How far, in pixels, alike pixels are looked for in each direction.
const WINDOW: isize = 5;

/// How far, in pixels, the patches reach by which two pixels are compared.
const PATCH: isize = 1;

/// The square of how far two pixels may differ, in units of the variance of their difference, beyond what noise explains.
const STRENGTH: f32 = 0.2;

/// Differences of radiance, squared, that nobody sees.
const UNSEEN: f32 = 1e-6;

/// A pixel may be brighter than all that the other picture has around it by this factor; more is a path that very few find.
const BRIGHTEST: f32 = 2.0;

// ANCHOR: denoise
/// The mean of two pictures of the same view by different random numbers, with less noise and with its edges.
///
/// Non-local means (Rousselle, Knaus and Zwicker, "Adaptive rendering with non-local means filtering", 2012): a pixel p becomes
/// Σ w(p, q)·q/Σ w(p, q) over the pixels q around it, with w = exp(−max(0, d²)), where d² is the mean over the patches around
/// p and q of ((p − q)² − (V(p) + min(V(p), V(q))))/(k²·(V(p) + V(q))). V is the variance of a pixel, which the difference of
/// the two pictures tells. Each picture is averaged with the weights of the other one, so that noise does not choose its own weights.
///
/// The result is a little too dark where few paths bring very much: what only one of the pictures has, and nothing around it,
/// counts no more than twice the brightest of its surroundings.
///
/// # Panics
/// If the pictures differ in size.
pub fn denoise(pictures: &[Image; 2]) -> Image {
    let [a, b] = pictures;
    let size = |picture: &Image| (picture.width, picture.height);
    assert_eq!(size(a), size(b), "both pictures have one size");
    let halves = [clamped(a, b), clamped(b, a)];
    let [a, b] = &halves;
    let variance = variance(a, b);
    let (a, b) = threads::join(|| averaged(a, b, &variance), || averaged(b, a, &variance));
    let pixels = a.into_iter().zip(b).map(|(a, b)| (a + b) * 0.5);
    Image {
        pixels: pixels.collect(),
        ..halves[0]
    }
}

/// The pixels of `picture`, each averaged with those around it, by the weights of `other`.
fn averaged(picture: &Image, other: &Image, variance: &Image) -> Vec<Rgb> {
    let mut sums = vec![(Rgb::BLACK, 0.0); picture.pixels.len()];
    for step in around(WINDOW) {
        let distances = distances(other, variance, step);
        for (i, (sum, weights)) in sums.iter_mut().enumerate() {
            let Some(q) = picture.stepped(i, step) else {
                continue;
            };
            let patch = around(PATCH).filter_map(|step| distances[other.index(i, step)?]);
            let (sum_of_patch, count) = patch.fold((0.0, 0.0), |(sum, n), d| (sum + d, n + 1.0));
            let weight = (-(sum_of_patch / count).max(0.0)).exp();
            *sum += q * weight;
            *weights += weight;
        }
    }
    sums.into_iter()
        .map(|(sum, weights)| sum / weights)
        .collect()
}
// ANCHOR_END: denoise

/// How much more each pixel differs from the one a step away than by noise; none where that is outside of the picture.
fn distances(picture: &Image, variance: &Image, step: (isize, isize)) -> Vec<Option<f32>> {
    let pairs = picture.pixels.iter().zip(&variance.pixels).enumerate();
    let distance = |(i, (p, of_p)): (usize, (&Rgb, &Rgb))| {
        let at = picture.index(i, step)?;
        let (q, of_q) = (picture.pixels[at], variance.pixels[at]);
        let noise = |p: f32, q: f32, of_p: f32, of_q: f32| {
            ((p - q).powi(2) - (of_p + of_p.min(of_q))) / (UNSEEN + STRENGTH * (of_p + of_q))
        };
        let channels = noise(p.r, q.r, of_p.r, of_q.r)
            + noise(p.g, q.g, of_p.g, of_q.g)
            + noise(p.b, q.b, of_p.b, of_q.b);
        Some(channels / 3.0)
    };
    pairs.map(distance).collect()
}

/// The variance of each pixel of one of two pictures: half of their difference's square, which is averaged over the neighbours.
fn variance(a: &Image, b: &Image) -> Image {
    let squares = a.pixels.iter().zip(&b.pixels);
    let pixels = squares.map(|(a, b)| {
        let difference = *a + *b * -1.0;
        difference * difference * 0.5
    });
    let noisy = Image {
        pixels: pixels.collect(),
        ..*a
    };
    neighbours(&noisy, |around| {
        let count = around.len() as f32;
        around.into_iter().sum::<Rgb>() / count
    })
}

/// The picture, nowhere brighter than [`BRIGHTEST`] times the brightest that the other one has around the pixel.
fn clamped(picture: &Image, other: &Image) -> Image {
    let most = neighbours(other, |around| {
        let brighter = |a: Rgb, b: Rgb| Rgb::new(a.r.max(b.r), a.g.max(b.g), a.b.max(b.b));
        around.into_iter().fold(Rgb::BLACK, brighter) * BRIGHTEST
    });
    let pairs = picture.pixels.iter().zip(&most.pixels);
    let pixels = pairs.map(|(p, most)| Rgb::new(p.r.min(most.r), p.g.min(most.g), p.b.min(most.b)));
    Image {
        pixels: pixels.collect(),
        ..*picture
    }
}

/// A picture of f of each pixel and the eight around it.
fn neighbours(picture: &Image, f: impl Fn(Vec<Rgb>) -> Rgb) -> Image {
    let pixels = (0..picture.pixels.len()).map(|i| {
        let near = around(1).filter_map(|step| picture.stepped(i, step));
        f(near.collect())
    });
    Image {
        pixels: pixels.collect(),
        ..*picture
    }
}

/// The steps to all pixels that are at most `reach` away along each axis.
fn around(reach: isize) -> impl Iterator<Item = (isize, isize)> {
    (-reach..=reach).flat_map(move |dy| (-reach..=reach).map(move |dx| (dx, dy)))
}

impl Image {
    /// The number of the pixel a step to the right and downwards from that of number i; none outside of the picture.
    fn index(&self, i: usize, (dx, dy): (isize, isize)) -> Option<usize> {
        let x = (i % self.width).checked_add_signed(dx)?;
        let y = (i / self.width).checked_add_signed(dy)?;
        (x < self.width && y < self.height).then_some(y * self.width + x)
    }

    /// That pixel.
    fn stepped(&self, i: usize, step: (isize, isize)) -> Option<Rgb> {
        Some(self.pixels[self.index(i, step)?])
    }
}

#[cfg(test)]
mod tests {
    use super::denoise;
    use crate::image::{Image, rgb::Rgb};
    use crate::math::pcg;
    use rand::RngExt;

    /// A step from dark to bright in the middle, with noise of a tenth.
    fn step(seed: u64) -> Image {
        let mut rng = pcg::stream(seed, 3);
        Image::from_fn(48, 24, |x, _| {
            let radiance = if x < 24 { 0.2 } else { 1.0 };
            Rgb::gray(radiance * rng.random_range(0.7..1.3))
        })
    }

    #[test]
    fn noise_falls_and_the_edge_stays() {
        let pictures = [step(1), step(2)];
        let clean = denoise(&pictures);
        let error = |picture: &Image, x: usize, true_value: f32| {
            let off = |y| (picture.at(x, y).g / true_value - 1.0).powi(2);
            (0..24).map(off).sum::<f32>() / 24.0
        };
        for (x, value) in [(12, 0.2), (36, 1.0), (23, 0.2), (24, 1.0)] {
            let before = 0.5 * error(&pictures[0], x, value);
            let after = error(&clean, x, value);
            assert!(after < 0.25 * before, "column {x}: {before} and {after}");
        }
        let mean = |from: usize| {
            let row = |y| (from..from + 24).map(|x| clean.at(x, y).g).sum::<f32>();
            (0..24).map(row).sum::<f32>() / 576.0
        };
        assert!((mean(0) / 0.2 - 1.0).abs() < 0.02 && (mean(24) - 1.0).abs() < 0.02);
    }

    #[test]
    fn a_pixel_that_only_one_picture_has_is_no_pixel_of_the_view() {
        let mut pictures = [step(1), step(2)];
        pictures[0].set(40, 10, Rgb::gray(500.0));
        let clean = denoise(&pictures);
        for (x, y) in [(40, 10), (41, 10), (38, 12)] {
            assert!(clean.at(x, y).g < 1.2, "{}", clean.at(x, y).g);
        }
    }
}
