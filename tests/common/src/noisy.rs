//! Whether two noisy pictures show the same: each difference is measured by how much chance moves it.
//!
//! A picture is given as independent batches, that is, as pictures with other seeds; how much they differ among each other
//! is how much chance does. One bound per pixel would be too lax for what is small but everywhere, and with thousands of
//! pixels some right one always falls through. So whole regions are compared, whose noise averages out: everything,
//! squares of 8 × 8, rows and columns; and single pixels only for what is grossly wrong.

use raybook::image::{Image, rgb::Rgb};

/// Number of batches that is needed to know the noise.
pub const BATCHES: usize = 16;

/// Standard deviations by which regions may differ. There are a few hundred of them in a small picture, and one is so far
/// off by chance once in 10⁹ times if the noise is normal; that of a region, a sum over many pixels, nearly is.
const REGION: f64 = 6.0;

/// The same of the two tests of everything at once: by chance once in a million times.
const GLOBAL: f64 = 5.0;

/// The same of a single pixel, whose noise is known from 16 numbers only and has longer tails: right pictures have shown
/// up to 3.1 …
const PIXEL: f64 = 7.0;

/// … beyond this share of the mean of the picture, by which every pixel may differ: rare light in a dark corner.
const PIXEL_SHARE: f64 = 0.05;

/// Edge of a square, in pixels.
const SQUARE: usize = 8;

/// A picture's mean, and the variance of that mean, of each channel of each pixel.
#[derive(Clone, Debug)]
pub struct Noisy {
    width: usize,
    height: usize,
    mean: Vec<[f64; 3]>,
    variance: Vec<[f64; 3]>,
}

/// What differs.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Where: "everywhere", "column 30".
    pub place: String,
    /// By how much, in units of what chance may do at most.
    pub excess: f64,
}

impl Noisy {
    /// From independent batches of equal size.
    pub fn of(batches: &[&Image]) -> Self {
        assert!(
            batches.len() >= BATCHES,
            "too few batches to know the noise"
        );
        let (width, height) = (batches[0].width(), batches[0].height());
        let n = batches.len() as f64;
        let (mut mean, mut variance) = (Vec::new(), Vec::new());
        for pixel in 0..width * height {
            let value = |batch: &&Image, c: usize| f64::from(batch.pixels()[pixel].channels()[c]);
            let means = [0, 1, 2].map(|c| batches.iter().map(|b| value(b, c)).sum::<f64>() / n);
            let square = |b, c: usize| (value(b, c) - means[c]).powi(2);
            let sum = |c| batches.iter().map(|b| square(b, c)).sum::<f64>();
            mean.push(means);
            variance.push([0, 1, 2].map(|c| sum(c) / (n - 1.0) / n));
        }
        Self {
            width,
            height,
            mean,
            variance,
        }
    }

    /// The mean picture.
    pub fn image(&self) -> Image {
        Image::from_fn(self.width, self.height, |x, y| {
            let [r, g, b] = self.mean[y * self.width + x].map(|v| v as f32);
            Rgb::new(r, g, b)
        })
    }

    /// The worst difference of a picture that is the mean of as many samples, if it is more than chance makes.
    pub fn compare(&self, picture: &Image) -> Result<(), Difference> {
        let size = (picture.width(), picture.height()) == (self.width, self.height);
        let finite = |p: &Rgb| p.channels().iter().all(|v| v.is_finite());
        if !size || !picture.pixels().iter().all(finite) {
            return Err(different("size, or not a number", f64::INFINITY));
        }
        let mut worst = different("nowhere", 0.0);
        let mut region = |name: String, limit: f64, xs: [usize; 2], ys: [usize; 2]| {
            let z = self.deviations(picture, xs, ys);
            if z / limit > worst.excess {
                worst = different(&name, z / limit);
            }
        };
        let (w, h) = (self.width, self.height);
        region("everywhere".into(), GLOBAL, [0, w], [0, h]);
        for x in 0..w {
            region(format!("column {x}"), REGION, [x, x + 1], [0, h]);
        }
        for y in 0..h {
            region(format!("row {y}"), REGION, [0, w], [y, y + 1]);
        }
        for y in (0..h).step_by(SQUARE) {
            for x in (0..w).step_by(SQUARE) {
                let (right, bottom) = ((x + SQUARE).min(w), (y + SQUARE).min(h));
                let name = format!("square at ({x}, {y})");
                region(name, REGION, [x, right], [y, bottom]);
            }
        }
        let z = self.brightness(picture);
        if z / GLOBAL > worst.excess {
            worst = different("brightness", z / GLOBAL);
        }
        for (x, y) in (0..h).flat_map(|y| (0..w).map(move |x| (x, y))) {
            let z = self.pixel(picture, x, y) / PIXEL;
            if z > worst.excess {
                worst = different(&format!("pixel ({x}, {y})"), z);
            }
        }
        if worst.excess > 1.0 {
            Err(worst)
        } else {
            Ok(())
        }
    }

    /// Difference of the sums over a region, in standard deviations; of the channel that is worst.
    fn deviations(&self, picture: &Image, xs: [usize; 2], ys: [usize; 2]) -> f64 {
        let mut difference = [0.0; 3];
        let mut variance = [0.0; 3];
        for i in (ys[0]..ys[1]).flat_map(|y| (xs[0]..xs[1]).map(move |x| y * self.width + x)) {
            let got = picture.pixels()[i].channels();
            for c in 0..3 {
                difference[c] += f64::from(got[c]) - self.mean[i][c];
                // The picture's own noise, and that of what it is compared with.
                variance[c] += 2.0 * self.variance[i][c];
            }
        }
        let z = |c: usize| difference[c].abs() / (variance[c].sqrt() + self.rounding(xs, ys, c));
        z(0).max(z(1)).max(z(2))
    }

    /// By how many standard deviations the picture is brighter or darker as a whole: the mean difference, in which a pixel
    /// weighs the more, the brighter and the less noisy it and its neighbours are.
    fn brightness(&self, picture: &Image) -> f64 {
        let of = |c: usize| {
            let (mut sum, mut variance) = (0.0, 0.0);
            for (i, got) in picture.pixels().iter().enumerate() {
                let (mean, own) = (self.mean[i][c], self.variance[i][c]);
                let noise = self.around(i % self.width, i / self.width, c) + 1e-10 * mean * mean;
                let weight = mean / noise.max(1e-20);
                sum += weight * (f64::from(got.channels()[c]) - mean);
                variance += weight * weight * 2.0 * own;
            }
            sum.abs() / (variance.sqrt() + 1e-12)
        };
        of(0).max(of(1)).max(of(2))
    }

    /// What `f32` may round in the sum of a region: without it, a region without noise could not be compared.
    fn rounding(&self, xs: [usize; 2], ys: [usize; 2], c: usize) -> f64 {
        let pixels = (ys[0]..ys[1]).flat_map(|y| (xs[0]..xs[1]).map(move |x| y * self.width + x));
        1e-6 * pixels.map(|i| self.mean[i][c].abs()).sum::<f64>() + 1e-12
    }

    /// A pixel's difference, in standard deviations of the noisiest of it and its neighbours.
    fn pixel(&self, picture: &Image, x: usize, y: usize) -> f64 {
        let global: f64 = self.mean.iter().flatten().sum::<f64>() / (3 * self.mean.len()) as f64;
        let got = picture.at(x, y).channels();
        let of = |c: usize| {
            let difference = (f64::from(got[c]) - self.mean[y * self.width + x][c]).abs();
            let noise = (2.0 * self.around(x, y, c)).sqrt() + 1e-12;
            (difference - PIXEL_SHARE * global).max(0.0) / noise
        };
        of(0).max(of(1)).max(of(2))
    }

    /// The largest variance among a pixel and its neighbours.
    fn around(&self, x: usize, y: usize, c: usize) -> f64 {
        let variances = self.near(x, y).map(|i| self.variance[i][c]);
        variances.fold(0.0, f64::max)
    }

    /// A pixel and its neighbours.
    fn near(&self, x: usize, y: usize) -> impl Iterator<Item = usize> + Clone {
        let range = |v: usize, end: usize| v.saturating_sub(1)..(v + 2).min(end);
        let (width, columns) = (self.width, range(x, self.width));
        range(y, self.height).flat_map(move |j| columns.clone().map(move |i| j * width + i))
    }
}

fn different(place: &str, excess: f64) -> Difference {
    Difference {
        place: place.to_owned(),
        excess,
    }
}
