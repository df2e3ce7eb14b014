//! Every material, with the laws that it keeps.

use crate::ch17_rendering_equation::cells::Cells;
use crate::ch17_rendering_equation::{direction, surface};
use glam::{Vec2, Vec3, vec2};
use rand::RngExt;
use raybook::image::{Image, mip::MipMap, rgb::Rgb};
use raybook::material::blinn_phong::BlinnPhong;
use raybook::material::checkered::Checkered;
use raybook::material::conductor::{Conductor, Metal};
use raybook::material::ggx::Ggx;
use raybook::material::glass::{Glass, Medium};
use raybook::material::glowing::Glowing;
use raybook::material::image_texture::ImageTexture;
use raybook::material::lambert::Lambert;
use raybook::material::mirror::{Mirror, reflect};
use raybook::material::modified_phong::ModifiedPhong;
use raybook::material::normalised_blinn_phong::NormalisedBlinnPhong;
use raybook::material::phong::Phong;
use raybook::material::plastic::Plastic;
use raybook::material::{Material, polished::Polished};
use raybook::math::{dir3::Dir3, pcg};
use raybook::shape::{Surface, normal_map::NormalMap};
use std::f64::consts::{PI, TAU};

/// Angles between viewers and the normal, in degrees: closer to each other where much depends on them, towards the horizon.
pub const ANGLES: [f32; 6] = [0.0, 30.0, 55.0, 75.0, 85.0, 89.0];

/// The metals by their names.
const METALS: [(&str, Metal); 4] = [
    ("gold", Metal::GOLD),
    ("silver", Metal::SILVER),
    ("copper", Metal::COPPER),
    ("aluminium", Metal::ALUMINIUM),
];

/// What leaves to a viewer, if light of radiance 1 arrives from everywhere: ∫ f cos θ dω and the shares of the delta lobes.
#[derive(Clone, Copy, Debug)]
pub enum Furnace {
    /// The same for every view.
    Always(f64),
    /// To a viewer straight above; less to others.
    StraightUp(f64),
    /// Light is lost on the way, more from some views than from others.
    AtMost(f64),
}

/// What stays the same if light and viewer change places.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reciprocal {
    /// f: the law of nature (Helmholtz).
    Brdf,
    /// Only f cos θ, the reflected light.
    Reflected,
    /// Neither.
    Nothing,
}

/// A material, a place of it, and its laws.
pub struct Row {
    pub name: String,
    pub furnace: Furnace,
    pub reciprocal: Reciprocal,
    pub material: Box<dyn Material>,
    /// The place where the material is tested.
    pub at: Surface,
}

impl Row {
    /// The same material at another place.
    fn at(self, at: Surface) -> Self {
        Self { at, ..self }
    }

    fn reciprocal(self, reciprocal: Reciprocal) -> Self {
        Self { reciprocal, ..self }
    }

    /// f; of coloured materials, the largest channel.
    pub fn f(&self, view: Dir3, toward: Dir3) -> f32 {
        self.material.eval(&self.at, view, toward).max_channel()
    }

    /// f cos θ: what is reflected of an irradiance of 1; the normal is the one for shading.
    pub fn reflected(&self, view: Dir3, toward: Dir3) -> f32 {
        self.f(view, toward) * self.at.facing(view).dot(*toward).max(0.0)
    }

    /// The delta lobes: each with its direction, and its share of the largest channel.
    pub fn delta_lobes(&self, view: Dir3) -> Vec<(Dir3, f32)> {
        let mut lobes = Vec::new();
        self.material.delta_lobes(&self.at, view, &mut |lobe| {
            lobes.push((lobe.toward, lobe.share.max_channel()));
        });
        lobes
    }

    /// Viewers above the surface, at all of the [`ANGLES`], each on a side by chance. Each material has its own.
    pub fn views(&self) -> [Dir3; ANGLES.len()] {
        let name = self.name.bytes().map(u64::from);
        let stream = name.fold(0, |sum: u64, byte| sum.wrapping_mul(31).wrapping_add(byte));
        let mut rng = pcg::stream(8, stream);
        ANGLES.map(|degrees| {
            let (sin, cos) = degrees.to_radians().sin_cos();
            let around = rng.random_range(0.0..TAU as f32);
            direction(sin * around.cos(), sin * around.sin(), cos)
        })
    }

    /// Cells around the direction where a highlight is expected.
    pub fn cells(&self, view: Dir3) -> Cells {
        Cells::around(reflect(-view, self.at.facing(view)))
    }
}

/// A row of a physical material in a plane.
fn row(name: impl Into<String>, furnace: Furnace, material: impl Material + 'static) -> Row {
    Row {
        name: name.into(),
        furnace,
        reciprocal: Reciprocal::Brdf,
        material: Box::new(material),
        at: surface(Dir3::Z),
    }
}

fn lambert(albedo: f32) -> Lambert {
    Lambert {
        albedo: Rgb::gray(albedo),
    }
}

fn mirror(share: f32) -> Mirror {
    Mirror {
        share: Rgb::gray(share),
    }
}

pub fn modified_phong(diffuse: f32, specular: f32, exponent: f32) -> ModifiedPhong {
    ModifiedPhong {
        diffuse: Rgb::gray(diffuse),
        specular: Rgb::gray(specular),
        exponent,
    }
}

pub fn normalised_blinn_phong(diffuse: f32, specular: f32, exponent: f32) -> NormalisedBlinnPhong {
    NormalisedBlinnPhong {
        diffuse: Rgb::gray(diffuse),
        specular: Rgb::gray(specular),
        exponent,
    }
}

/// Phong's model as the lecture writes it, with k_d and k_s in 1/sr.
fn phong(diffuse: f64, specular: f64, exponent: f64) -> Phong {
    Phong {
        ambient: Rgb::BLACK,
        diffuse: Rgb::gray(diffuse as f32),
        specular: Rgb::gray(specular as f32),
        exponent: exponent as f32,
    }
}

/// The materials of `src/material`, those with a lobe at several exponents or roughnesses.
pub fn materials() -> Vec<Row> {
    use Furnace::{Always, AtMost, StraightUp};
    let squares = || Checkered(lambert(0.2), lambert(0.8));
    let bubble = Glass {
        outside: Medium::GLASS,
        inside: Medium::AIR,
    };
    let radiance = Rgb::WHITE;
    let mut rows = vec![
        row("black", Always(0.0), ()),
        row("glowing", Always(0.0), Glowing { radiance }),
        row("Lambert", Always(0.8), lambert(0.8)),
        row("Lambert, bumpy", Always(0.8), lambert(0.8)).at(bumpy()),
        row("plastic", AtMost(1.0), Plastic::new(Rgb::gray(0.6), 1.5)),
        row("white plastic", Always(1.0), Plastic::new(Rgb::WHITE, 1.5)),
        row("a mirror", Always(0.9), mirror(0.9)),
        row("a mirror, bumpy", Always(0.9), mirror(0.9)).at(bumpy()),
        row("glass", Always(1.0), Glass::of(Medium::GLASS)),
        row("a bubble in glass", Always(1.0), bubble),
        row("polish over Lambert", Always(0.3 + 0.7 * 0.5), {
            let (mirror, below) = (mirror(0.3), lambert(0.5));
            Polished { mirror, below }
        }),
        row("polish over Phong", StraightUp(0.3 + 0.7 * 0.9), {
            let (mirror, below) = (mirror(0.3), modified_phong(0.3, 0.6, 20.0));
            Polished { mirror, below }
        }),
        row("dark square", Always(0.2), squares()).at(place(0.25, 0.5)),
        row("light square", Always(0.8), squares()).at(place(1.25, 0.5)),
        row("dark stripe", Always(0.2), stripes(lambert)).at(place(0.25, 0.5)),
        row("glossy stripe", StraightUp(0.8), {
            stripes(|share| modified_phong(0.0, share, 9.0))
        })
        .at(place(0.75, 0.5)),
    ];
    for n in [0.0, 1.0, 7.0, 50.0] {
        for (kd, ks) in [(0.0, 1.0), (0.3, 0.6)] {
            let most = StraightUp(f64::from(kd + ks));
            let parts = format!("{kd} + {ks}, exponent {n}");
            let phong = modified_phong(kd, ks, n);
            rows.push(row(format!("modified Phong {parts}"), most, phong));
            let blinn = normalised_blinn_phong(kd, ks, n);
            rows.push(row(format!("normalised Blinn-Phong {parts}"), most, blinn));
        }
    }
    for (name, metal) in METALS {
        let smooth = Conductor(metal);
        rows.push(row(format!("smooth {name}"), AtMost(1.0), smooth));
        // What is chosen by chance does not depend on the metal: two roughnesses are enough for the others.
        let alphas: &[f32] = match name {
            "gold" => &[0.05, 0.1, 0.3, 0.6, 1.0],
            _ => &[0.1, 0.6],
        };
        for &alpha in alphas {
            let rough = Ggx { metal, alpha };
            rows.push(row(format!("{name}, GGX {alpha}"), AtMost(1.0), rough));
        }
    }
    let bumps = "modified Phong, bumpy";
    rows.push(row(bumps, StraightUp(0.9), modified_phong(0.3, 0.6, 7.0)).at(bumpy()));
    let gold = Ggx {
        metal: Metal::GOLD,
        alpha: 0.3,
    };
    rows.push(row("GGX, bumpy", AtMost(1.0), gold).at(bumpy()));
    rows.extend(as_the_lecture_writes_them());
    rows
}

/// Phong's and Blinn's models multiply the matte part by the cosine, but not the highlight: f = k_d + k_s (R·V)^α/cos θ. So f is
/// not reciprocal, and for a large k_s more light leaves than arrives. What they keep: the highlight's reflected light is
/// reciprocal, and the most that leaves is known.
fn as_the_lecture_writes_them() -> Vec<Row> {
    let mut rows = Vec::new();
    for (kd, ks, alpha) in [
        (0.8 / PI, 0.0, 7.0),
        (0.5 / PI, 0.05, 7.0),
        (0.0, 0.1, 20.0),
        (0.8 / PI, 1.0, 7.0),
    ] {
        let reciprocal = match (kd, ks) {
            (_, 0.0) => Reciprocal::Brdf,
            (0.0, _) => Reciprocal::Reflected,
            _ => Reciprocal::Nothing,
        };
        let parts = format!("{kd:.2} + {ks}, exponent {alpha}");
        // ∫ cos^α θ dω over the hemisphere is 2π/(α + 1).
        let most = PI * kd + TAU * ks / (alpha + 1.0);
        let brdf = phong(kd, ks, alpha);
        let name = format!("Phong {parts}");
        rows.push(row(name, Furnace::StraightUp(most), brdf).reciprocal(reciprocal));
        // ∫ cos^α(θ/2) dω is 8π/(α + 2) (1 − 2^(−(α + 2)/2)).
        let lobe = 4.0 * TAU / (alpha + 2.0) * (1.0 - (-0.5 * (alpha + 2.0)).exp2());
        let most = PI * kd + lobe * ks;
        let name = format!("Blinn-Phong {parts}");
        rows.push(row(name, Furnace::StraightUp(most), BlinnPhong(brdf)).reciprocal(reciprocal));
    }
    rows
}

/// A place of a texture.
fn place(u: f32, v: f32) -> Surface {
    let texture = vec2(u, v);
    Surface {
        texture,
        ..surface(Dir3::Z)
    }
}

/// A picture of a dark and a light stripe, with the albedos 0.2 and 0.8.
fn stripes<M: Material>(make: impl Fn(f32) -> M + Send + Sync + 'static) -> ImageTexture<M> {
    let picture = Image::from_fn(2, 1, |x, _| Rgb::gray([0.2, 0.8][x]));
    ImageTexture::new(MipMap::new(&picture), move |colour: Rgb| make(colour.g))
}

/// A place whose normal is tilted by a normal map.
fn bumpy() -> Surface {
    let bumps = NormalMap::new(&Image::from_fn(1, 1, |_, _| Rgb::new(0.6, 0.7, 0.9)));
    let at = surface(Dir3::Z);
    let edges = [Vec3::X, Vec3::Y];
    Surface {
        shading_normal: bumps.tilt(at.normal, edges, [Vec2::X, Vec2::Y], Vec2::ZERO),
        ..at
    }
}
