//! The picture's size, its samples, and how light is followed.
//!
//! ```
//! use raybook_scenes::gallery::CORNELL;
//!
//! let picture = CORNELL.shot(64)?.picture;
//! let half = picture.of_width(32);
//! assert_eq!([picture.height, half.height], [64, 32]);
//! # Ok::<(), raybook_scenes::wrong::TextError>(())
//! ```

use crate::fields::{Fields, Make};
use crate::wrong::TextError;
use rand::Rng;
use raybook::image::{Image, tone};
use raybook::math::ray::Ray;
use raybook::render::adaptive::Limits;
use raybook::render::caustics::Caustics;
use raybook::render::clamped::Clamped;
use raybook::render::cone::Cone;
use raybook::render::followed::Followed;
use raybook::render::local::{Local, NO_SHADOWS};
use raybook::render::needs_more::StoppingRule;
use raybook::render::photons::Photons;
use raybook::render::sampler::{Integrator, Sampler};
use raybook::render::{path::Path, shadow, whitted::Whitted};
use raybook::sample::filter::Filter;
use raybook::sample::pattern::{PATTERNS, Pattern};
use raybook::scene::world::Scene;
use std::fmt;
use std::sync::OnceLock;

/// The widest and highest picture, in pixels.
pub const WIDEST: u64 = 8192;

/// The size of a picture, and how it is displayed.
#[derive(Clone, Copy, Debug)]
pub struct Picture {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Samples per pixel.
    pub samples: usize,
    /// Seed of all random numbers.
    pub seed: u64,
    /// The filter by which the samples become pixels.
    pub filter: Filter,
    /// Stops by which the picture is brightened for the display.
    pub exposure: f32,
    /// Whether bright colours fade to white as on film; else they are cut off.
    pub film_like: bool,
}

impl Picture {
    /// Width over height.
    pub fn aspect(&self) -> f32 {
        self.width as f32 / self.height as f32
    }

    /// The same at another width; the height follows.
    #[must_use]
    pub fn of_width(self, width: usize) -> Self {
        let height = (width as f32 / self.aspect()).round() as usize;
        Self {
            width,
            height: height.clamp(1, WIDEST as usize),
            ..self
        }
    }

    /// Radiance as a display shows it.
    pub fn developed(&self, radiance: &Image) -> Image {
        let exposed = radiance.map(|pixel| tone::expose(pixel, self.exposure));
        if self.film_like {
            exposed.map(tone::aces)
        } else {
            exposed
        }
    }
}

pub(crate) fn picture(fields: Option<Fields>) -> Result<Picture, TextError> {
    let usual = Picture {
        width: 640,
        height: 480,
        samples: 64,
        seed: 1,
        filter: Filter::BOX,
        exposure: 0.0,
        film_like: false,
    };
    let Some(fields) = fields else {
        return Ok(usual);
    };
    let size = |v: Option<u64>, usual: usize| v.map_or(usual, |v| v as usize);
    let film_like = fields.choice("tone", &[("clamp", false), ("aces", true)])?;
    let picture = Picture {
        width: size(fields.whole("width", 1..=WIDEST)?, usual.width),
        height: size(fields.whole("height", 1..=WIDEST)?, usual.height),
        samples: size(fields.whole("samples", 1..=1_000_000)?, usual.samples),
        seed: fields
            .whole("seed", 0..=i64::MAX as u64)?
            .unwrap_or(usual.seed),
        filter: fields.choice("filter", &FILTERS)?.unwrap_or(usual.filter),
        exposure: fields
            .number("exposure_stops", -30.0..=30.0)?
            .unwrap_or(0.0),
        film_like: film_like.unwrap_or(usual.film_like),
    };
    fields.finish()?;
    Ok(picture)
}

/// The filters by their words.
const FILTERS: [(&str, Filter); 4] = [
    ("box", Filter::BOX),
    ("tent", Filter::TENT),
    ("gaussian", Filter::GAUSSIAN),
    ("mitchell", Filter::MITCHELL),
];

/// The integrator, which follows light, and the sampler, which places the samples.
pub struct Rendering {
    /// How light is followed.
    pub integrator: Box<dyn Integrator>,
    /// Where the samples are.
    pub sampler: Sampler<'static>,
}

impl fmt::Debug for Rendering {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("Rendering")
            .field("sampler", &self.sampler)
            .finish_non_exhaustive()
    }
}

pub(crate) fn rendering(scene: &Fields) -> Result<Rendering, TextError> {
    let integrator = scene.table("integrator", "the integrator")?;
    let sampler = scene.table("sampler", "the sampler")?;
    Ok(Rendering {
        integrator: match integrator {
            Some(fields) => fields.made("an integrator", &INTEGRATORS)?,
            None => Box::new(Path::WHOLE),
        },
        sampler: match sampler {
            Some(fields) => self::sampler(fields)?,
            None => Sampler::Even,
        },
    })
}

/// The largest `depth` of a scene file, in surfaces along one path: between two mirrors a path would never end.
const DEEPEST: u64 = 1000;

/// The integrators by their words.
const INTEGRATORS: [(&str, Make<Box<dyn Integrator>>); 3] =
    [("path", path), ("whitted", whitted), ("direct", direct)];

fn path(fields: &Fields) -> Result<Box<dyn Integrator>, TextError> {
    let depth = fields.whole("depth", 1..=DEEPEST)?;
    let path = Path {
        depth: depth.unwrap_or(DEEPEST) as u32,
        ..Path::WHOLE
    };
    let brightest = fields.number("brightest_sample", 1e-6..=1e12)?;
    let photons = fields.whole("photons", 1..=MOST_PHOTONS)?;
    let radius = fields.number("photon_radius_m", 1e-6..=1e3)?;
    match (photons, radius) {
        (None, None) => {}
        (Some(count), Some(radius)) => {
            return Ok(Box::new(WithPhotons {
                path,
                brightest: brightest.unwrap_or(f32::INFINITY),
                count: count as usize,
                radius,
                caustics: OnceLock::new(),
            }));
        }
        (Some(_), None) => {
            let message = "photons light what is near them; give `photon_radius_m` too";
            return Err(fields.wrong("photons", message));
        }
        (None, Some(_)) => {
            let message = "only photons have this; give `photons` too";
            return Err(fields.wrong("photon_radius_m", message));
        }
    }
    Ok(match brightest {
        Some(brightest) => Box::new(Clamped {
            integrator: path,
            brightest,
        }),
        None => Box::new(path),
    })
}

/// The largest number of photons from each light: if all land, they take about half a gigabyte.
const MOST_PHOTONS: u64 = 10_000_000;

/// Paths with photons, which are shot when the first path is followed: only then the scene is known.
struct WithPhotons {
    path: Path,
    brightest: f32,
    /// Number of photons from each light.
    count: usize,
    /// Distance up to which photons light a point, in metres.
    radius: f32,
    caustics: OnceLock<Caustics>,
}

impl Integrator for WithPhotons {
    fn follow(&self, scene: &Scene, ray: &Ray, cone: Cone, numbers: &mut dyn Rng) -> Followed {
        let caustics = self.caustics.get_or_init(|| Caustics {
            path: self.path,
            photons: Photons::shot(scene, self.count, self.radius, 0),
            brightest: self.brightest,
        });
        caustics.follow(scene, ray, cone, numbers)
    }
}

fn whitted(fields: &Fields) -> Result<Box<dyn Integrator>, TextError> {
    // Glass makes two rays of one, so that a tree of rays may not be as deep as a path.
    let depth = fields.whole("depth", 1..=32)?.unwrap_or(8);
    Ok(Box::new(Whitted {
        local: local(fields)?,
        depth: depth as u32,
    }))
}

fn direct(fields: &Fields) -> Result<Box<dyn Integrator>, TextError> {
    Ok(Box::new(local(fields)?))
}

/// How the light of the light sources is gathered, where it is not a path that finds it.
fn local(fields: &Fields) -> Result<Local, TextError> {
    let shadows = fields.yes("shadows")?.unwrap_or(true);
    let samples = fields.whole("light_samples", 1..=1024)?.unwrap_or(1);
    Ok(Local {
        samples: samples as u32,
        arrives: if shadows {
            Some(shadow::lit as _)
        } else {
            NO_SHADOWS
        },
    })
}

/// How the samples of a table are placed: by a rule, or by a pattern, which has no fields.
#[derive(Clone, Copy)]
enum Placed {
    By(Make<Sampler<'static>>),
    In(&'static Pattern),
}

/// The rules by their words; each pattern goes by its name.
const RULES: [(&str, Placed); 4] = [
    ("even", Placed::By(|_| Ok(Sampler::Even))),
    ("refined", Placed::By(|_| Ok(Sampler::Refined))),
    ("adaptive", Placed::By(adaptive)),
    ("budget", Placed::By(budget)),
];

fn sampler(mut fields: Fields) -> Result<Sampler<'static>, TextError> {
    let patterns = PATTERNS.iter().map(|one| (one.name, Placed::In(one)));
    let kinds: Vec<_> = RULES.into_iter().chain(patterns).collect();
    let sampler = match fields.kind("a sampler", &kinds)? {
        Placed::By(rule) => rule(&fields)?,
        Placed::In(pattern) => Sampler::Pattern(pattern),
    };
    fields.finish()?;
    Ok(sampler)
}

fn adaptive(fields: &Fields) -> Result<Sampler<'static>, TextError> {
    let first = first(fields)?;
    let most = fields.whole("most", 2..=1_000_000)?.unwrap_or(256) as usize;
    let error = fields.number("error", 0.0..=1e9)?;
    let enough = error.map_or(StoppingRule::BY_CONTRAST, StoppingRule::by_variance);
    Ok(Sampler::Adaptive(Limits { first, most }, enough))
}

fn budget(fields: &Fields) -> Result<Sampler<'static>, TextError> {
    let first = first(fields)?;
    Ok(Sampler::Budget { first })
}

/// The samples that each pixel has first.
fn first(fields: &Fields) -> Result<usize, TextError> {
    Ok(fields.whole("first", 2..=1024)?.unwrap_or(4) as usize)
}
