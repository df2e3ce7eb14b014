//! What a whole picture costs: camera, sampler, paths, materials, lights and accelerators together. `cargo bench --bench pictures`
//!
//! Five small pictures on one thread, eight paths per pixel; the figure is paths per second. `benches/accel.rs` and
//! `benches/hits.rs` measure the parts. Then two lines: the share of the accelerator in the Cornell box, and how much faster two
//! threads are than one.

use cpu_time::ProcessTime;
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use rand::RngExt;
use raybook::inside::scene::things;
use raybook::light::{LightHit, LightSample};
use raybook::material::Material;
use raybook::math::pcg;
use raybook::prelude::*;
use raybook::render::shadow::shadow_ray;
use raybook::scene::cornell;
use raybook::shape::teapot;
use raybook_scenes::gallery;
use std::hint::black_box;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Edge of a picture in pixels.
const EDGE: usize = 64;
/// Paths per pixel.
const SAMPLES: usize = 8;

/// The time of one picture.
fn bench(criterion: &mut Criterion, name: &str, camera: &dyn Camera, scene: &Scene) {
    let film = Film {
        threads: 1,
        ..Film::new(EDGE, EDGE, SAMPLES)
    };
    let draw = || film.render(camera, &Sampler::Even, &Path::WHOLE, scene);
    let picture = draw();
    assert!(
        picture.pixels().iter().any(|pixel| *pixel != Rgb::BLACK),
        "{name} is not black"
    );
    let mut group = criterion.benchmark_group("pictures");
    group.throughput(Throughput::Elements((EDGE * EDGE * SAMPLES) as u64));
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(4));
    group.bench_function(name, |bencher| bencher.iter(draw));
    group.finish();
}

/// A camera for a square picture, 40 degrees wide.
fn view(from: Vec3, to: Vec3) -> Pinhole {
    Pinhole::look_at(from, to, Vec3::Y, focal_length(40.0), 1.0).expect("from, to and up differ")
}

fn matte(gray: f32) -> Lambert {
    Lambert {
        albedo: Rgb::gray(gray),
    }
}

fn floor() -> Thing {
    Thing::new(Plane::through(Vec3::ZERO, Dir3::Y), matte(0.4))
}

/// A ball that lies on the floor.
fn ball(x: f32, z: f32, radius: f32) -> Sphere {
    Sphere::new(vec3(x, radius, z), radius)
}

/// The Cornell box, and the same with a mirror and a glass ball: many bounces between matte walls, and a caustic.
fn boxes(criterion: &mut Criterion) {
    let camera = view(cornell::EYE, vec3(0.278, 0.273, 0.0));
    bench(criterion, "Cornell box", &camera, &cornell::cornell_box());
    let balls = gallery::CORNELL.shot(EDGE).expect("a scene");
    bench(criterion, "glass ball", &camera, &balls.scene);
}

/// Hundreds of balls through a lens, under a round sun: a tree of spheres, and materials that take turns. It stays as it is, unlike the
/// example, so that figures can be compared.
fn many_balls(criterion: &mut Criterion) {
    let mut random = pcg::stream(7, 0);
    let mut things = vec![floor()];
    for place in (0..400).map(|i| vec2((i % 20) as f32 - 10.0, (i / 20) as f32 - 14.0)) {
        let place = place + 0.6 * Vec2::from(random.random::<[f32; 2]>());
        let shape = ball(place.x, place.y, 0.2);
        let [r, g, b] = random.random::<[f32; 3]>();
        let albedo = Rgb::new(r, g, b);
        things.push(match random.random_range(0..10) {
            0..4 => Thing::new(shape, Lambert { albedo }),
            4..8 => Thing::new(shape, Plastic::new(albedo, 1.5)),
            8 => Thing::new(shape, Conductor(Metal::SILVER)),
            _ => Thing::new(shape, Glass::of(Medium::GLASS)),
        });
    }
    let sun = SphereLight {
        sphere: Sphere::new(vec3(30.0, 50.0, 30.0), 6.0),
        radiance: Rgb::gray(80.0),
        choose: LightSampling::BySolidAngle,
    };
    let scene = Scene::new(things, vec![Box::new(sun)]).surrounded_by(Rgb::BLACK, |ray| {
        Rgb::gray(0.5 + 0.5 * ray.direction.y.abs())
    });
    let view = view(vec3(2.5, 2.2, 12.0), vec3(0.0, 0.6, 0.0));
    let camera = ThinLens::with_view(&view, 0.15, 11.8, Aperture::Round).expect("a lens");
    bench(criterion, "many balls", &camera, &scene);
}

/// Metals and glass on grey ground, in the light of an environment map with a sun: importance sampling of its texels.
fn outdoors(criterion: &mut Criterion) {
    let sky = Image::from_fn(256, 128, |x, y| {
        let sun = (80..83).contains(&x) && (30..33).contains(&y);
        let dome = if y < 64 { 0.6 } else { 0.2 };
        Rgb::gray(if sun { 3000.0 } else { dome })
    });
    let copper = Ggx {
        metal: Metal::COPPER,
        alpha: 0.3,
    };
    let things = vec![
        floor(),
        Thing::new(ball(-2.2, 0.0, 1.0), Conductor(Metal::SILVER)),
        Thing::new(ball(0.0, 0.0, 1.0), Glass::of(Medium::GLASS)),
        Thing::new(ball(2.2, 0.0, 1.0), copper),
    ];
    let scene = Scene::new(things, vec![Box::new(Environment::new(sky))]);
    let camera = view(vec3(0.0, 2.0, 9.0), vec3(0.0, 0.9, 0.0));
    bench(criterion, "outdoors", &camera, &scene);
}

/// The teapot on a plane, below a square lamp: a mesh with smooth normals.
fn teapot(criterion: &mut Criterion) {
    let mesh = teapot::mesh(10);
    let (bounds, size) = (mesh.bounds(), mesh.bounds().size().length());
    let ground = Plane::through(vec3(0.0, bounds.min.y, 0.0), Dir3::Y);
    let things = vec![
        Thing::new(ground, matte(0.5)),
        Thing::new(Meshed::new(mesh, WideBvh::new), matte(0.75)),
    ];
    let corner = bounds.center() + size * vec3(-0.5, 1.2, -0.5);
    let lamp = RectLight::new(corner, size * Vec3::X, size * Vec3::Z, Rgb::gray(8.0))
        .choosing(LightSampling::BySolidAngle);
    let scene = Scene::new(things, vec![Box::new(lamp)]);
    let eye = bounds.center() + size * vec3(0.4, 0.5, 1.2);
    bench(criterion, "teapot", &view(eye, bounds.center()), &scene);
}

/// Rounds of what is measured without criterion; the medians count.
const ROUNDS: usize = 15;

/// Time on the wall and processor time of all threads, in seconds.
fn time<T>(work: impl FnOnce() -> T) -> [f64; 2] {
    let (processor, wall) = (ProcessTime::now(), Instant::now());
    black_box(work());
    let times = [wall.elapsed(), processor.elapsed()];
    times.map(|time| time.as_secs_f64())
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Two threads against one, at the Cornell box. The figure says something only where two processors were free: where the second
/// picture took twice as much processor time as time on the wall.
fn two_threads(_: &mut Criterion) {
    let camera = view(cornell::EYE, vec3(0.278, 0.273, 0.0));
    let scene = cornell::cornell_box();
    let draw = |threads| {
        let film = Film {
            threads,
            ..Film::new(4 * EDGE, 4 * EDGE, SAMPLES)
        };
        time(|| film.render(&camera, &Sampler::Even, &Path::WHOLE, &scene))
    };
    let rounds: Vec<_> = (0..ROUNDS).map(|_| [1, 2].map(draw)).collect();
    let figure = |of: fn(&[[f64; 2]; 2]) -> f64| median(rounds.iter().map(of).collect());
    println!(
        "two threads: {:.2} times as fast as one, with {:.2} processors at work",
        figure(|[[one, _], [two, _]]| one / two),
        figure(|[_, [wall, processor]]| processor / wall),
    );
}

/// The rays to surfaces, and those to lights.
type Rays = Arc<Mutex<(Vec<Ray>, Vec<(Ray, Interval)>)>>;

/// A lamp or a paint that keeps the rays which it is asked about.
struct Keeping<T>(T, Rays);

impl Light for Keeping<RectLight> {
    fn sample(&self, at: Vec3, u: Vec2) -> Option<LightSample> {
        self.0.sample(at, u)
    }

    fn seen(&self, ray: &Ray, farthest: f32) -> Option<LightHit> {
        self.1
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .0
            .push(*ray);
        self.0.seen(ray, farthest)
    }
}

impl Material for Keeping<Arc<dyn Material>> {
    fn eval(&self, at: &Surface, view: Dir3, toward: Dir3) -> Rgb {
        self.0.eval(at, view, toward)
    }

    fn lit(&self, at: &Surface, view: Dir3, light: &LightSample) -> Rgb {
        let lit = self.0.lit(at, view, light);
        if lit != Rgb::BLACK {
            let mut rays = self.1.lock().unwrap_or_else(PoisonError::into_inner);
            rays.1.push(shadow_ray(at, light));
        }
        lit
    }
}

/// What a path of the Cornell box costs, against the searches for its rays alone.
fn beside_the_accelerator(_: &mut Criterion) {
    let camera = view(cornell::EYE, vec3(0.278, 0.273, 0.0));
    let (scene, rays) = (cornell::cornell_box(), Rays::default());
    let film = Film {
        threads: 1,
        ..Film::new(EDGE, EDGE, SAMPLES)
    };
    let draw = |scene: &Scene| film.render(&camera, &Sampler::Even, &Path::WHOLE, scene);
    let keeping = things(&scene).shapes().iter().map(|thing| Thing {
        shape: thing.shape.clone(),
        material: Arc::new(Keeping(thing.material.clone(), rays.clone())),
    });
    let lamp = Box::new(Keeping(cornell::lamp(), rays.clone()));
    let kept = draw(&Scene::new(keeping.collect(), vec![lamp]));
    assert!(
        kept.same_bits(&draw(&scene)),
        "the rays are those of the scene"
    );

    let rays = rays.lock().unwrap_or_else(PoisonError::into_inner);
    let search = || {
        for ray in &rays.0 {
            black_box(things(&scene).closest(ray, Interval::AHEAD));
        }
        for (ray, within) in &rays.1 {
            black_box(things(&scene).any(ray, *within));
        }
    };
    let ratio = |_| time(|| draw(&scene))[1] / time(search)[1];
    let ratio = median((0..ROUNDS).map(ratio).collect());
    let paths = (EDGE * EDGE * SAMPLES) as f64;
    println!(
        "Cornell box: a path, with {:.2} rays to surfaces and {:.2} to the lamp, costs {ratio:.2} times as much as their searches",
        rays.0.len() as f64 / paths,
        rays.1.len() as f64 / paths,
    );
}

criterion_group!(
    benches,
    boxes,
    many_balls,
    outdoors,
    teapot,
    two_threads,
    beside_the_accelerator
);
criterion_main!(benches);
