//! Random numbers by a pattern, pair after pair.

use glam::{Vec2, vec2};
use rand::RngExt;
use raybook::math::pcg::{self, Pcg};
use raybook::prelude::*;
use raybook::sample::{padded::Padded, pattern::PATTERNS};

/// Number of samples, and of cells along each axis of the square.
const SAMPLES: usize = 16;
const SIDE: usize = 4;

/// The first pairs of each sample.
fn pairs(rng: &mut Pcg, points: fn(usize, &mut Pcg) -> Vec<Vec2>) -> Vec<[Vec2; 4]> {
    let mut padded = Padded::new(rng, |rng| points(SAMPLES, rng));
    let of_sample = |i| {
        let mut numbers = padded.sample(i);
        std::array::from_fn(|_| vec2(numbers.random(), numbers.random()))
    };
    (0..SAMPLES).map(of_sample).collect()
}

#[test]
fn each_pair_is_uniform_and_says_nothing_about_the_next() {
    for pattern in PATTERNS {
        let pixels = 400;
        let (mut sum, mut product, mut low, mut outside) = (Vec2::ZERO, 0.0, 0, 0);
        for pixel in 0..pixels {
            for pairs in pairs(&mut pcg::stream(5, pixel), pattern.points) {
                outside += pairs
                    .iter()
                    .filter(|p| p.min_element() < 0.0 || p.max_element() >= 1.0)
                    .count();
                low += usize::from(pairs[2].y < 0.1);
                sum += pairs[2] - 0.5;
                product += (pairs[1].x - 0.5) * (pairs[2].x - 0.5);
            }
        }
        let count = (pixels as usize * SAMPLES) as f32;
        assert_eq!(outside, 0, "{}: in [0, 1)²", pattern.name);
        let low = low as f32 / count - 0.1;
        // By chance alone, the mean of a number scatters by 0.29/√n, and a product by 1/12/√n: five times that, at most.
        let (mean, product) = ((sum / count).abs().max_element(), product / count);
        assert!(
            mean < 5.0 * 0.29 / count.sqrt(),
            "{}: f by {mean}",
            pattern.name
        );
        assert!(
            low.abs() < 5.0 * 0.3 / count.sqrt(),
            "{}: the share below 0.1 is off by {low}",
            pattern.name
        );
        assert!(
            product.abs() < 5.0 / 12.0 / count.sqrt(),
            "{}: {product}",
            pattern.name
        );
    }
}

#[test]
fn the_samples_fill_the_square_of_each_pair_as_the_pattern_does() {
    let jittered = raybook::sample::pattern::find("regular-grid").expect("there is a grid");
    for pixel in 0..20 {
        let all = pairs(&mut pcg::stream(6, pixel), jittered.points);
        for k in 0..4 {
            // A grid that is moved has one point in each cell of the grid that is moved with it.
            let corner = all[0][k];
            let cell =
                |p: Vec2| ((p - corner + 1.0 + 0.5 / SIDE as f32).fract() * SIDE as f32).as_uvec2();
            let mut cells: Vec<_> = all.iter().map(|pairs| cell(pairs[k])).collect();
            cells.sort_by_key(|c| (c.x, c.y));
            cells.dedup();
            assert_eq!(cells.len(), SAMPLES, "pair {k} of pixel {pixel}");
        }
    }
}

/// The variance of a soft shadow's pixels, by the samples of a pattern.
#[test]
fn a_patterns_numbers_make_less_noise_in_a_soft_shadow_than_random_ones() {
    let floor = Thing::new(
        Plane::through(Vec3::ZERO, Dir3::Y),
        Lambert { albedo: Rgb::WHITE },
    );
    let board = Thing::new(
        Sphere::new(vec3(0.0, 1.0, 0.0), 0.5),
        Lambert { albedo: Rgb::BLACK },
    );
    let lamp = RectLight::new(
        vec3(-1.0, 3.0, -1.0),
        2.0 * Vec3::X,
        2.0 * Vec3::Z,
        Rgb::gray(5.0),
    );
    let scene = Scene::new(vec![floor, board], vec![Box::new(lamp)]);
    let camera = Pinhole::look_at(
        vec3(0.0, 0.4, 3.0),
        vec3(0.0, 0.0, 0.6),
        Vec3::Y,
        focal_length(20.0),
        1.0,
    )
    .expect("it looks at the shadow");
    let path = Path {
        depth: 1,
        strategy: Strategy::Light,
        ..Path::WHOLE
    };
    let noise = |name: &str| {
        let pattern = raybook::sample::pattern::find(name).expect("a pattern's name");
        let picture = |seed| {
            let film = Film {
                seed,
                ..Film::new(24, 24, SAMPLES)
            };
            film.render(&camera, &Sampler::Pattern(pattern), &path, &scene)
        };
        let (a, b) = (picture(1), picture(2));
        let pairs = a.pixels().iter().zip(b.pixels());
        pairs.map(|(a, b)| (a.g - b.g).powi(2)).sum::<f32>()
    };
    let random = noise("random");
    for name in ["jittered", "multi-jittered", "sobol-owen", "poisson-disk"] {
        let share = noise(name) / random;
        assert!(share < 0.6, "{name}: {share} of the variance by chance");
    }
}
