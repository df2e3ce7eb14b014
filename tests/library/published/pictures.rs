//! Pictures that others published: `tests/published/README.md` says whose.

use glam::{Vec3, vec2, vec3};
use raybook::image::tone;
use raybook::material::{Delta, mirror::reflect, refract::refract};
use raybook::prelude::*;
use raybook::scene::cornell;
use raybook_common::project;
use raybook_common::statistics::Mean;
use std::fs;

/// Blocks of 25 × 25 pixels, row by row.
const BLOCK: usize = 25;

/// The sky of the book: white below, blue above.
fn sky(ray: &Ray) -> Rgb {
    Rgb::WHITE.lerp(Rgb::new(0.5, 0.7, 1.0), 0.5 * (ray.direction.y + 1.0))
}

/// Compares a picture byte by byte with a published one: byte = ⌊255.999 v⌋, as the book has it.
fn same_bytes(name: &str, width: usize, height: usize, pixel: impl Fn(usize, usize) -> Rgb) {
    let path = project("tests/published").join(name);
    let published = file::load(&path).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((published.width(), published.height()), (width, height));
    let ours = Image::from_fn(width, height, pixel);
    for (ours, theirs) in ours.pixels().iter().zip(published.pixels()) {
        let ours = ours.channels().map(|v| (255.999 * f64::from(v)) as u8);
        assert_eq!(ours, theirs.channels().map(tone::to_byte), "{name}");
    }
}

/// The first camera of the book: at the origin, a view 2 m high 1 m away.
fn first_camera() -> Pinhole {
    Pinhole {
        focal_length: 1.0,
        plane: vec2(2.0 * 400.0 / 225.0, 2.0),
        ..looking(Vec3::ZERO, -Vec3::Z, 90.0)
    }
}

fn looking(from: Vec3, to: Vec3, degrees: f32) -> Pinhole {
    Pinhole::look_at(from, to, Vec3::Y, focal_length(degrees), 400.0 / 225.0).expect("a camera")
}

#[test]
fn the_first_images_of_ray_tracing_in_one_weekend_are_the_same_byte_for_byte() {
    let shade = |x: usize| x as f32 / 255.0;
    same_bytes("img-1.01-first-ppm-image.png", 256, 256, |x, y| {
        Rgb::new(shade(x), shade(y), 0.0)
    });
    let camera = first_camera();
    let small = Sphere::new(-Vec3::Z, 0.5);
    let ground = Sphere::new(vec3(0.0, -100.5, -1.0), 100.0);
    let ray = |x: usize, y: usize| {
        camera.central_ray(vec2((x as f32 + 0.5) / 400.0, (y as f32 + 0.5) / 225.0))
    };
    let hit = |ray: &Ray, ball: &Sphere| ball.hit(ray, Interval::AHEAD);
    let normal = |ray: &Ray, balls: &[Sphere]| {
        let hits = balls
            .iter()
            .filter_map(|ball| Some((ball, hit(ray, ball)?)));
        let (ball, hit) = hits.min_by(|a, b| a.1.t.total_cmp(&b.1.t))?;
        let n = 0.5 * (*ball.surface(ray, &hit).normal + 1.0);
        Some(Rgb::new(n.x, n.y, n.z))
    };
    same_bytes("img-1.02-blue-to-white.png", 400, 225, |x, y| {
        sky(&ray(x, y))
    });
    same_bytes("img-1.03-red-sphere.png", 400, 225, |x, y| {
        let red = hit(&ray(x, y), &small).map(|_| Rgb::new(1.0, 0.0, 0.0));
        red.unwrap_or_else(|| sky(&ray(x, y)))
    });
    same_bytes("img-1.04-normals-sphere.png", 400, 225, |x, y| {
        normal(&ray(x, y), &[small]).unwrap_or_else(|| sky(&ray(x, y)))
    });
    same_bytes("img-1.05-normals-sphere-ground.png", 400, 225, |x, y| {
        normal(&ray(x, y), &[small, ground]).unwrap_or_else(|| sky(&ray(x, y)))
    });
}

/// The published numbers of a picture's blocks, row by row: the colours from a column of the table on.
fn column(name: &str, column: usize) -> Vec<Rgb> {
    let text = fs::read_to_string(project("tests/published/block_means.csv")).expect("the table");
    let rows = text
        .lines()
        .filter_map(|line| line.strip_prefix(name)?.strip_prefix(','));
    let colour = |row: &str| {
        let v: Vec<f32> = row
            .split(',')
            .map(|v| v.parse().expect("a number"))
            .collect();
        Rgb::new(v[column], v[column + 1], v[column + 2])
    };
    rows.map(colour).collect()
}

/// The published means of a picture's blocks.
fn published(name: &str) -> Vec<Rgb> {
    column(name, 2)
}

/// The standard errors of these means, where they are known.
fn errors(name: &str) -> Vec<Rgb> {
    column(name, 5)
}

fn blocks(picture: &Image) -> Vec<Rgb> {
    let (columns, rows) = (picture.width() / BLOCK, picture.height() / BLOCK);
    let mean = |block: usize| {
        let (left, top) = (block % columns * BLOCK, block / columns * BLOCK);
        let pixels = (0..BLOCK * BLOCK).map(|i| picture.at(left + i % BLOCK, top + i / BLOCK));
        pixels.sum::<Rgb>() / (BLOCK * BLOCK) as f32
    };
    (0..columns * rows).map(mean).collect()
}

fn mean(blocks: &[Rgb]) -> Rgb {
    blocks.iter().copied().sum::<Rgb>() / blocks.len() as f32
}

/// The channel in which two colours differ most, relative to the second where `relative`.
fn apart(a: Rgb, b: Rgb, relative: bool) -> f32 {
    let channels = a.channels().into_iter().zip(b.channels());
    let off = channels.map(|(a, b)| (a - b).abs() / if relative { b } else { 1.0 });
    off.fold(0.0, f32::max)
}

fn lambert(r: f32, g: f32, b: f32) -> Lambert {
    Lambert {
        albedo: Rgb::new(r, g, b),
    }
}

fn metal(r: f32, g: f32, b: f32) -> Mirror {
    Mirror {
        share: Rgb::new(r, g, b),
    }
}

fn ball(x: f32, z: f32, radius: f32, material: impl Material + 'static) -> Thing {
    Thing::new(Sphere::new(vec3(x, 0.0, z), radius), material)
}

fn ground(material: Lambert) -> Thing {
    Thing::new(Sphere::new(vec3(0.0, -100.5, -1.0), 100.0), material)
}

/// The glass of the book: a body of this index relative to its surroundings, with Schlick's approximation by the angle at which
/// light arrives, on both sides.
struct BookGlass(f32);

impl Material for BookGlass {
    fn delta_lobes(&self, at: &Surface, view: Dir3, visit: &mut dyn FnMut(Delta)) {
        let normal = at.facing(view);
        let ratio = if at.normal.dot(*view) < 0.0 {
            self.0
        } else {
            1.0 / self.0
        };
        let cosine = normal.dot(*view).min(1.0);
        let r0 = ((1.0 - ratio) / (1.0 + ratio)).powi(2);
        let refracted = refract(-view, normal, ratio, 1.0);
        let share = refracted.map_or(1.0, |_| r0 + (1.0 - r0) * (1.0 - cosine).powi(5));
        let mut lobe = |toward: Dir3, share: f32| {
            visit(Delta {
                toward,
                share: Rgb::gray(share),
                medium: Medium::AIR,
            });
        };
        lobe(reflect(-view, normal), share);
        if let Some(refracted) = refracted {
            lobe(refracted, 1.0 - share);
        }
    }

    fn scatters(&self, _at: &Surface) -> bool {
        false
    }
}

/// Draws a scene of the book under its sky, and compares the blocks.
#[track_caller]
fn as_in_the_book(name: &str, camera: &dyn Camera, things: Vec<Thing>) {
    let scene = Scene::new(things, vec![]).surrounded_by(Rgb::BLACK, sky);
    let picture = Film::new(400, 225, 16).render(camera, &Sampler::Even, &Path::WHOLE, &scene);
    // The published byte 255 counts as 255.5/256; from 1.13 on bytes are square roots.
    let white: f32 = 255.5 / 256.0;
    let most = if name == "rtw 1.10" {
        white
    } else {
        white * white
    };
    let cut = |v: f32| v.min(most);
    let (ours, theirs) = (blocks(&picture.map(|p| p.map(cut))), published(name));
    assert_eq!(ours.len(), theirs.len(), "{name}");
    let off = apart(mean(&ours), mean(&theirs), true);
    assert!(off < 0.005, "{name}: the means differ by {off}");
    for (i, (a, b)) in ours.iter().zip(&theirs).enumerate() {
        let off = apart(*a, *b, false);
        assert!(off < 0.015, "{name}, block {i}: {a:?}, not {b:?}");
    }
}

#[test]
fn later_images_of_ray_tracing_in_one_weekend_have_the_same_means() {
    let first = first_camera();
    let grey = || lambert(0.5, 0.5, 0.5);
    as_in_the_book(
        "rtw 1.10",
        &first,
        vec![ball(0.0, -1.0, 0.5, grey()), ground(grey())],
    );
    let metals = vec![
        ground(lambert(0.8, 0.8, 0.0)),
        ball(0.0, -1.0, 0.5, lambert(0.7, 0.3, 0.3)),
        ball(-1.0, -1.0, 0.5, metal(0.8, 0.8, 0.8)),
        ball(1.0, -1.0, 0.5, metal(0.8, 0.6, 0.2)),
    ];
    as_in_the_book("rtw 1.13", &first, metals);
    let glass = || {
        vec![
            ground(lambert(0.8, 0.8, 0.0)),
            ball(0.0, -1.0, 0.5, lambert(0.1, 0.2, 0.5)),
            ball(-1.0, -1.0, 0.5, BookGlass(1.5)),
            ball(-1.0, -1.0, 0.4, BookGlass(1.0 / 1.5)),
            ball(1.0, -1.0, 0.5, metal(0.8, 0.6, 0.2)),
        ]
    };
    as_in_the_book("rtw 1.18", &first, glass());
    let r = std::f32::consts::FRAC_1_SQRT_2;
    let touching = vec![
        ball(-r, -1.0, r, lambert(0.0, 0.0, 1.0)),
        ball(r, -1.0, r, lambert(1.0, 0.0, 0.0)),
    ];
    as_in_the_book("rtw 1.19", &looking(Vec3::ZERO, -Vec3::Z, 90.0), touching);
    let from = vec3(-2.0, 2.0, 1.0);
    as_in_the_book("rtw 1.20", &looking(from, -Vec3::Z, 90.0), glass());
    let far = looking(from, -Vec3::Z, 20.0);
    as_in_the_book("rtw 1.21", &far, glass());
    let diameter = 2.0 * 3.4 * 5_f32.to_radians().tan();
    let lens = ThinLens::with_view(&far, diameter, 3.4, Aperture::Round).expect("a lens");
    as_in_the_book("rtw 1.22", &lens, glass());
}

/// The camera of the Cornell box: a film of 25 mm at 35 mm.
fn box_camera() -> Pinhole {
    let length = cornell::ZOOM * raybook::camera::pinhole::PLANE_HEIGHT;
    let to = vec3(cornell::EYE.x, cornell::EYE.y, 0.0);
    Pinhole::look_at(cornell::EYE, to, Vec3::Y, length, 1.0).expect("a camera")
}

/// Number of pictures of a box, each with random numbers of its own, by which the noise of their mean is known.
const SEEDS: u64 = 16;

/// The standard deviation of what rounding to five digits after the point adds to a published number.
const ROUNDED: f64 = 3e-6;

/// The largest mean of z²: by chance alone it is 1.15, the variance of Student's t with 15 degrees of freedom. The channels of a block are
/// noisy together, so that the mean over 64 blocks is known to 0.25.
const NOISE: f64 = 2.0;

/// How many standard errors a block may be away: by 16 pictures, chance alone makes this once in 40 000 times (Student's t with 15
/// degrees of freedom).
const LIMIT: f64 = 6.0;

/// Draws a box with these samples per pixel in all, and compares each channel of each block with the published one by the noise of
/// both. A sum over all blocks sees what each of them hides in its noise.
#[track_caller]
fn as_by_mitsuba(name: &str, scene: &Scene, samples: usize) {
    let draw = |seed| {
        let film = Film {
            seed,
            ..Film::new(200, 200, samples / SEEDS as usize)
        };
        blocks(&film.render(&box_camera(), &Sampler::Even, &Path::WHOLE, scene))
    };
    let ours: Vec<_> = (0..SEEDS).map(draw).collect();
    let (theirs, known_to) = (published(name), errors(name));
    let (mut squares, mut most) = (0.0, 0.0_f64);
    for (i, (their, to)) in theirs.iter().zip(&known_to).enumerate() {
        for channel in 0..3 {
            let of = |colour: Rgb| f64::from(colour.channels()[channel]);
            let got = Mean::of(&ours.iter().map(|all| of(all[i])).collect::<Vec<_>>());
            let z = (got.mean - of(*their)) / got.error.hypot(of(*to)).hypot(ROUNDED);
            assert!(
                z.abs() < LIMIT,
                "{name}, block {i}, channel {channel}: {got:?}, not {their:?}: {z:.1} standard errors"
            );
            squares += z * z;
            most = most.max(z.abs());
        }
    }
    let square = squares / (3 * theirs.len()) as f64;
    println!("{name}: z² is {square:.2} on average, |z| is {most:.2} at most");
    assert!(square < NOISE, "{name}: z² is {square} on average");
    let all: Vec<_> = ours.iter().map(|picture| mean(picture)).collect();
    let off = apart(mean(&all), mean(&theirs), true);
    assert!(off < 0.005, "{name}: the means differ by {off}");
}

#[test]
fn each_block_of_the_cornell_box_is_as_bright_as_mitsubas() {
    as_by_mitsuba("cornell", &cornell::cornell_box(), 32);
}

/// A box of painted walls, open in front.
fn room() -> Vec<Thing> {
    let corner = |x: f32, y: f32, z: f32| vec3(0.556 * x, 0.5488 * y, 0.56 * z);
    let wall = |corners: [Vec3; 4], albedo: Rgb| {
        let mesh = Mesh::new(corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]], None, None);
        let mesh = Meshed::new(mesh.expect("a wall"), WideBvh::new);
        Thing::new(mesh, Lambert { albedo })
    };
    let [a, b, c, d] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let level = |y: f32| [a, b, c, d].map(|[x, z]| corner(x, y, z));
    let side = |x: f32| [a, b, c, d].map(|[y, z]| corner(x, y, z));
    vec![
        wall(level(0.0), cornell::WHITE),
        wall(level(1.0), cornell::WHITE),
        wall([a, b, c, d].map(|[x, y]| corner(x, y, 1.0)), cornell::WHITE),
        wall(side(0.0), cornell::GREEN),
        wall(side(1.0), cornell::RED),
    ]
}

#[test]
fn each_block_of_the_cornell_box_with_mirror_and_glass_is_as_bright_as_mitsubas() {
    let ball = |x: f32, z: f32| Sphere::new(vec3(x, 0.1, z), 0.1);
    let mut things = room();
    things.push(Thing::new(ball(0.40, 0.38), metal(0.95, 0.95, 0.95)));
    things.push(Thing::new(ball(0.16, 0.20), Glass::of(Medium::GLASS)));
    let scene = Scene::new(things, vec![Box::new(cornell::lamp())]);
    as_by_mitsuba("cornell balls", &scene, 64);
}
