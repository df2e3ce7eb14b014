//! A whole picture: raybook's path tracer against that of the crate `rpt`, at the same scene, size, samples and depth, on one thread.
//!
//! The scene is the Cornell box, all matte. Neither is asked about the lamp itself, which `rpt` does not show.

use clap::Parser;
use raybook::prelude::*;
use raybook::scene::cornell::{EYE, GREEN, LAMP, RED, WHITE};
use raybook::store;
use rpt::{SceneAdd, glm};
use rustix::time::{ClockId, clock_gettime};
use std::error::Error;
use std::fmt::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// Edge of the picture, in pixels.
const EDGE: u32 = 96;
/// Samples per pixel of a picture that races.
const SAMPLES: u32 = 16;
/// Number of surfaces over which light is followed.
const DEPTH: u32 = 6;
/// The film of the published camera is 25 mm high, at 35 mm.
const HALF_VIEW: f32 = 12.5 / 35.0;
/// The exponent that both encode a channel with.
const GAMMA: f32 = 1.0 / 2.2;

/// A quad and its albedo; seen from its front, its corners are counter-clockwise.
type Quad = ([Vec3; 4], Rgb);

/// Races raybook's path tracer against that of the crate rpt
#[derive(Parser)]
struct Options {
    /// Few rounds, and fewer samples in the converged pictures
    #[arg(long)]
    quick: bool,
    /// Rounds; the median of them counts
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    rounds: Option<u16>,
    /// Where pictures.csv goes
    #[arg(long, value_name = "FOLDER", default_value = "target/peers")]
    out: PathBuf,
}

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<(), Box<dyn Error>> {
    let (rounds, reference) = if options.quick { (5, 1024) } else { (21, 4096) };
    let rounds = options.rounds.map_or(rounds, usize::from);
    let race = race(rounds, reference)?;
    let how = [
        format!("processor: {}, one thread", processor()),
        format!(
            "{rounds} rounds; {reference} samples per pixel in the converged pictures; processor time"
        ),
    ];
    let text = race.csv(&how);
    print!("{text}");
    let file = options.out.join("pictures.csv");
    store::write(&file, text.as_bytes())?;
    println!("wrote {}", file.display());
    Ok(())
}

/// What the system calls the processor.
fn processor() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let field = |name: &str| {
        let line = text.lines().find(|line| line.starts_with(name));
        let value = line.and_then(|line| line.split_once(": "));
        value.map_or("unknown", |(_, value)| value).to_owned()
    };
    format!(
        "{}, family {}, model {}",
        field("model name"),
        field("cpu family"),
        field("model\t")
    )
}

/// How many times as long as ours the other one takes for a picture with the same error; and what that is made of.
struct Race {
    /// The ratios of all rounds.
    ratios: Vec<f64>,
    /// Seconds and mean square errors of all rounds: ours, and the other's.
    runs: [Vec<(f64, f64)>; 2],
    /// The mean of the other's converged picture over that of ours: 1 if both draw the same.
    same: f64,
}

/// Races for a number of rounds; `reference` is the number of samples of the converged pictures.
fn race(rounds: usize, reference: u32) -> Result<Race, Box<dyn Error>> {
    let (quads, lamp) = room();
    let (ours, theirs) = (Ours::new(&quads, lamp), Theirs::new(&quads, lamp)?);
    let truths = [ours.draw(reference, 1), theirs.draw(reference)];
    // Where the lamp is seen, ours is white and the other's is not.
    let counts: Vec<_> = truths[0].iter().map(|v| *v < 0.999).collect();
    let mean = |picture: &[f32]| -> f64 {
        let seen = picture.iter().zip(&counts).filter(|(_, counts)| **counts);
        seen.map(|(v, _)| f64::from(*v)).sum()
    };
    let same = mean(&truths[1]) / mean(&truths[0]);
    let error = |picture: &[f32], truth: &[f32]| {
        let all = picture.iter().zip(truth).zip(&counts);
        let squares = all
            .filter(|(_, counts)| **counts)
            .map(|((a, e), _)| f64::from(a - e).powi(2));
        squares.sum::<f64>() / counts.iter().filter(|counts| **counts).count() as f64
    };
    let (mut ratios, mut runs) = (Vec::new(), [Vec::new(), Vec::new()]);
    for round in 0..rounds {
        let run = |other: bool| {
            let begun = seconds();
            let picture = if other {
                theirs.draw(SAMPLES)
            } else {
                ours.draw(SAMPLES, 2 + round as u64)
            };
            (
                seconds() - begun,
                error(&picture, &truths[usize::from(other)]),
            )
        };
        // Who begins, changes.
        let first = round % 2 == 1;
        let pair = [run(first), run(!first)];
        let [of_ours, of_theirs] = if first { [pair[1], pair[0]] } else { pair };
        ratios.push(of_theirs.0 * of_theirs.1 / (of_ours.0 * of_ours.1));
        runs[0].push(of_ours);
        runs[1].push(of_theirs);
    }
    Ok(Race { ratios, runs, same })
}

impl Race {
    /// The median ratio, and below which a tenth and nine tenths of the rounds are.
    fn ratio(&self) -> [f64; 3] {
        [0.5, 0.1, 0.9].map(|part| quantile(self.ratios.clone(), part))
    }

    /// The rows of `pictures.csv`; `how` says where it was measured.
    fn csv(&self, how: &[String]) -> String {
        let mut text = how
            .iter()
            .fold(String::new(), |text, line| text + "# " + line + "\n");
        text.push_str(
            "scene,edge,samples,depth,path_tracer,seconds,rms_error,mean,ratio,ratio_10,ratio_90\n",
        );
        for (name, runs, mean, [ratio, low, high]) in [
            ("raybook", &self.runs[0], 1.0, [1.0; 3]),
            ("rpt", &self.runs[1], self.same, self.ratio()),
        ] {
            let time = median(runs.iter().map(|run| run.0).collect());
            let error = median(runs.iter().map(|run| run.1.sqrt()).collect());
            let _ = writeln!(
                text,
                "Cornell box,{EDGE},{SAMPLES},{DEPTH},{name},{time:.4},{error:.5},{mean:.4},{ratio:.3},{low:.3},{high:.3}"
            );
        }
        text
    }
}

fn median(numbers: Vec<f64>) -> f64 {
    quantile(numbers, 0.5)
}

/// The number below which this part of all is; between two of them, on the line from one to the other.
fn quantile(mut numbers: Vec<f64>, part: f64) -> f64 {
    numbers.sort_by(f64::total_cmp);
    let at = part * (numbers.len() - 1) as f64;
    let (low, high) = (numbers[at.floor() as usize], numbers[at.ceil() as usize]);
    low + at.fract() * (high - low)
}

/// Seconds of processor time that this program has had.
fn seconds() -> f64 {
    let now = clock_gettime(ClockId::ProcessCPUTime);
    now.tv_sec as f64 + 1e-9 * now.tv_nsec as f64
}

/// The box with its two blocks, in metres, and its lamp, which faces down.
fn room() -> (Vec<Quad>, [Vec3; 4]) {
    let (low, high) = (Vec3::ZERO, vec3(0.556, 0.5488, 0.5592));
    let middle = 0.5 * (low + high);
    let mut quads = Vec::new();
    // A wall for each face of the box but the one before the eye.
    for (axis, at, albedo) in [
        (0, low, GREEN),
        (0, high, RED),
        (1, low, WHITE),
        (1, high, WHITE),
        (2, high, WHITE),
    ] {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let corners = [(low, low), (high, low), (high, high), (low, high)].map(|(of_u, of_v)| {
            let mut corner = at;
            (corner[u], corner[v]) = (of_u[u], of_v[v]);
            corner
        });
        quads.push((facing(corners, middle), albedo));
    }
    // Height, and the corners on the floor, of the published blocks, in millimetres.
    for (height, corners) in [
        (
            165.0,
            [[130.0, 65.0], [82.0, 225.0], [240.0, 272.0], [290.0, 114.0]],
        ),
        (
            330.0,
            [
                [423.0, 247.0],
                [265.0, 296.0],
                [314.0, 456.0],
                [472.0, 406.0],
            ],
        ),
    ] {
        let corner = |i: usize, y: f32| vec3(corners[i % 4][0], y, corners[i % 4][1]) / 1000.0;
        let inside = 0.5 * (corner(0, 0.0) + corner(2, height));
        let mut add = |quad: [Vec3; 4]| {
            let outside = (quad[0] + quad[2]) - inside;
            quads.push((facing(quad, outside), WHITE));
        };
        add([0, 1, 2, 3].map(|i| corner(i, height)));
        for i in 0..4 {
            add([
                corner(i, 0.0),
                corner(i, height),
                corner(i + 1, height),
                corner(i + 1, 0.0),
            ]);
        }
    }
    let lamp = [
        (0.213, 0.227),
        (0.343, 0.227),
        (0.343, 0.332),
        (0.213, 0.332),
    ];
    let lamp = lamp.map(|(x, z)| vec3(x, 0.5483, z));
    (quads, facing(lamp, middle))
}

/// The quad with its front to a point.
fn facing([a, b, c, d]: [Vec3; 4], point: Vec3) -> [Vec3; 4] {
    let normal = (b - a).cross(c - a);
    if normal.dot(point - a) > 0.0 {
        [a, b, c, d]
    } else {
        [d, c, b, a]
    }
}

/// The quads of each colour.
fn by_colour(quads: &[Quad]) -> [(Rgb, Vec<[Vec3; 4]>); 3] {
    [WHITE, RED, GREEN].map(|colour| {
        let own = quads.iter().filter(|(_, albedo)| *albedo == colour);
        (colour, own.map(|(quad, _)| *quad).collect())
    })
}

/// A channel as both encode it.
fn encoded(v: f32) -> f32 {
    (v.clamp(0.0, 1.0).powf(GAMMA) * 255.0).floor() / 255.0
}

/// raybook's.
struct Ours {
    scene: Scene,
    camera: Pinhole,
}

impl Ours {
    fn new(quads: &[Quad], lamp: [Vec3; 4]) -> Self {
        let things = by_colour(quads).map(|(albedo, quads)| {
            let triangles = (0..quads.len() as u32).flat_map(|i| {
                let [a, b, c, d] = [0, 1, 2, 3].map(|corner| 4 * i + corner);
                [[a, b, c], [a, c, d]]
            });
            let mesh = Mesh::new(quads.concat(), triangles.collect(), None, None);
            let mesh = mesh.expect("the box is a mesh");
            Thing::new(Meshed::new(mesh, WideBvh::new), Lambert { albedo })
        });
        let [a, b, _, d] = lamp;
        let lamp = RectLight::new(a, b - a, d - a, LAMP);
        let camera = Pinhole::look_at(EYE, EYE + Vec3::Z, Vec3::Y, focal_length(degrees()), 1.0);
        Self {
            scene: Scene::new(things.into(), vec![Box::new(lamp)]),
            camera: camera.expect("it looks along z"),
        }
    }

    fn draw(&self, samples: u32, seed: u64) -> Vec<f32> {
        let film = Film {
            threads: 1,
            seed,
            ..Film::new(EDGE as usize, EDGE as usize, samples as usize)
        };
        let path = Path {
            depth: DEPTH,
            ..Path::WHOLE
        };
        let picture = film.render(&self.camera, &Sampler::Even, &path, &self.scene);
        picture
            .pixels()
            .iter()
            .flat_map(|pixel| pixel.channels().map(encoded))
            .collect()
    }
}

/// The height of the view.
fn degrees() -> f32 {
    2.0 * HALF_VIEW.atan().to_degrees()
}

/// That of the crate.
struct Theirs {
    scene: rpt::Scene,
    camera: rpt::Camera,
    threads: rayon::ThreadPool,
}

impl Theirs {
    fn new(quads: &[Quad], lamp: [Vec3; 4]) -> Result<Self, Box<dyn Error>> {
        let at = |p: Vec3| glm::vec3(f64::from(p.x), f64::from(p.y), f64::from(p.z));
        let colour = |c: Rgb| glm::vec3(f64::from(c.r), f64::from(c.g), f64::from(c.b));
        let mut scene = rpt::Scene::new();
        for (albedo, quads) in by_colour(quads) {
            let triangles = quads.iter().flat_map(|quad| {
                let [a, b, c, d] = quad.map(at);
                [[a, b, c], [a, c, d]].map(|[a, b, c]| rpt::Triangle::from_vertices(a, b, c))
            });
            // Without a coat: its index is that of air.
            let matte = rpt::Material {
                index: 1.0,
                ..rpt::Material::diffuse(colour(albedo))
            };
            scene.add(rpt::Object::new(rpt::Mesh::new(triangles.collect())).material(matte));
        }
        let shine = rpt::Material::light(colour(LAMP), 1.0);
        let lamp = rpt::Object::new(rpt::polygon(&lamp.map(at))).material(shine);
        scene.add(rpt::Light::Object(lamp));
        let fov = f64::from(degrees()).to_radians();
        let camera = rpt::Camera::look_at(at(EYE), at(EYE + Vec3::Z), at(Vec3::Y), fov);
        let threads = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
        Ok(Self {
            scene,
            camera,
            threads,
        })
    }

    fn draw(&self, samples: u32) -> Vec<f32> {
        let renderer = rpt::Renderer::new(&self.scene, self.camera)
            .width(EDGE)
            .height(EDGE)
            .max_bounces(DEPTH - 1)
            .num_samples(samples);
        let picture = self.threads.install(|| renderer.render());
        picture
            .into_raw()
            .iter()
            .map(|v| f32::from(*v) / 255.0)
            .collect()
    }
}
