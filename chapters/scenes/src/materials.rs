//! Materials: each has a name, and shapes may share it.

use crate::fields::{Fields, Make};
use crate::lights::picture;
use crate::values::colour;
use crate::wrong::{TextError, no_such, shown};
use raybook::image::{mip::MipMap, rgb::Rgb};
use raybook::material::Material;
use raybook::material::checkered::is_odd;
use raybook::material::conductor::{Conductor, Metal};
use raybook::material::ggx::Ggx;
use raybook::material::glass::{Glass, Medium};
use raybook::material::glowing::Glowing;
use raybook::material::lambert::Lambert;
use raybook::material::mirror::Mirror;
use raybook::material::modified_phong::ModifiedPhong;
use raybook::material::normalised_blinn_phong::NormalisedBlinnPhong;
use raybook::material::phong::Phong;
use raybook::material::plastic::Plastic;
use raybook::material::polished::Polished;
use raybook::material::texture::Texture;
use raybook::shape::Surface;
use std::collections::BTreeMap;
use std::f32::consts::FRAC_1_PI;
use std::ops::RangeInclusive;
use std::sync::Arc;

/// The materials of a scene by their names.
#[derive(Default)]
pub(crate) struct Materials {
    named: BTreeMap<String, Arc<dyn Material>>,
}

impl std::fmt::Debug for Materials {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.debug_set().entries(self.named.keys()).finish()
    }
}

impl Materials {
    pub(crate) fn of(fields: Option<Fields>) -> Result<Self, TextError> {
        let mut named = BTreeMap::new();
        if let Some(fields) = fields {
            for (name, value) in fields.all() {
                let what = format!("the material {}", shown(name));
                named.insert(name.to_owned(), material(fields.of(value, name, &what)?)?);
            }
        }
        Ok(Self { named })
    }

    /// The material that the field `material` of a shape names or describes.
    pub(crate) fn get(&self, shape: &Fields) -> Result<Option<Arc<dyn Material>>, TextError> {
        let Some(value) = shape.value("material") else {
            return Ok(None);
        };
        if value.get_ref().is_table() {
            let fields = shape.of(value, "material", "this material")?;
            return material(fields).map(Some);
        }
        let Some(name) = shape.text("material")? else {
            return Ok(None);
        };
        self.named.get(name).cloned().map(Some).ok_or_else(|| {
            let message = if self.named.is_empty() {
                let name = shown(name);
                format!("there is no material {name}: none is described; write [materials.NAME]")
            } else {
                no_such("material", name, self.named.keys().map(String::as_str))
            };
            shape.wrong("material", message)
        })
    }
}

/// The kinds by their words.
const KINDS: [(&str, Make<Arc<dyn Material>>); 9] = [
    ("matte", matte),
    ("plastic", plastic),
    ("phong", phong),
    ("modified-phong", modified_phong),
    ("blinn-phong", blinn_phong),
    ("metal", metal),
    ("mirror", mirror),
    ("glass", glass),
    ("glowing", glowing),
];

fn material(fields: Fields) -> Result<Arc<dyn Material>, TextError> {
    fields.made("a material", &KINDS)
}

fn matte(fields: &Fields) -> Result<Arc<dyn Material>, TextError> {
    Ok(paint(fields)?.make(|albedo| Lambert { albedo }))
}

fn plastic(fields: &Fields) -> Result<Arc<dyn Material>, TextError> {
    let plastic = Plastic::new(Rgb::BLACK, index(fields)?);
    Ok(paint(fields)?.make(move |albedo| plastic.of(albedo)))
}

/// Phong's material, or the same below a polish.
fn phong(fields: &Fields) -> Result<Arc<dyn Material>, TextError> {
    let (specular, exponent) = highlight(fields)?;
    let phong = move |albedo| Phong {
        ambient: albedo,
        diffuse: albedo * FRAC_1_PI,
        specular: Rgb::gray(specular),
        exponent,
    };
    let paint = paint(fields)?;
    Ok(match fields.share("polish")? {
        Some(share) => paint.make(move |albedo| Polished {
            mirror: Mirror { share },
            below: phong(albedo),
        }),
        None => paint.make(phong),
    })
}

fn modified_phong(fields: &Fields) -> Result<Arc<dyn Material>, TextError> {
    glossy(fields, |diffuse, specular, exponent| ModifiedPhong {
        diffuse,
        specular,
        exponent,
    })
}

fn blinn_phong(fields: &Fields) -> Result<Arc<dyn Material>, TextError> {
    glossy(fields, |diffuse, specular, exponent| NormalisedBlinnPhong {
        diffuse,
        specular,
        exponent,
    })
}

/// What is made of the matte share, the highlight's share and its exponent, where no more light leaves than arrives.
fn glossy<M: Material + 'static>(
    fields: &Fields,
    make: fn(Rgb, Rgb, f32) -> M,
) -> Result<Arc<dyn Material>, TextError> {
    let (share, exponent) = highlight(fields)?;
    let glossy = move |albedo| make(albedo * (1.0 - share), Rgb::gray(share), exponent);
    Ok(paint(fields)?.make(glossy))
}

/// The share of the highlight and its exponent.
fn highlight(fields: &Fields) -> Result<(f32, f32), TextError> {
    let share = fields.number("specular", 0.0..=1.0)?.unwrap_or(0.0);
    let exponent = fields.number("exponent", 0.0..=1e6)?.unwrap_or(50.0);
    Ok((share, exponent))
}

/// The metals by their words.
const METALS: [(&str, Metal); 4] = [
    ("gold", Metal::GOLD),
    ("silver", Metal::SILVER),
    ("copper", Metal::COPPER),
    ("aluminium", Metal::ALUMINIUM),
];

fn metal(fields: &Fields) -> Result<Arc<dyn Material>, TextError> {
    let metal = fields.need("metal", |fields, key| fields.choice(key, &METALS))?;
    let alpha = fields.number("roughness", 0.0..=1.0)?.unwrap_or(0.0);
    Ok(if alpha < Ggx::SMOOTHEST {
        Arc::new(Conductor(metal))
    } else {
        Arc::new(Ggx { metal, alpha })
    })
}

fn mirror(fields: &Fields) -> Result<Arc<dyn Material>, TextError> {
    let share = fields.share("share")?.unwrap_or(Rgb::gray(0.95));
    Ok(Arc::new(Mirror { share }))
}

fn glass(fields: &Fields) -> Result<Arc<dyn Material>, TextError> {
    Ok(Arc::new(Glass {
        outside: Medium::clear(fields.number("outside_index", INDEX)?.unwrap_or(1.0)),
        inside: Medium {
            index: index(fields)?,
            absorption: fields.light("absorption_per_m")?.unwrap_or(Rgb::BLACK),
        },
    }))
}

/// Of all that is transparent; diamond has 2.4.
const INDEX: RangeInclusive<f32> = 1.0..=4.0;

/// The refractive index; without one, that of window glass.
fn index(fields: &Fields) -> Result<f32, TextError> {
    Ok(fields.number("index", INDEX)?.unwrap_or(1.5))
}

fn glowing(fields: &Fields) -> Result<Arc<dyn Material>, TextError> {
    let radiance = fields.need("radiance", Fields::light)?;
    Ok(Arc::new(Glowing { radiance }))
}

/// The colour of a surface, place by place.
enum Paint {
    Plain(Rgb),
    Picture { map: Arc<MipMap>, repeat: f32 },
    Squares { colours: [Rgb; 2], side: f32 },
}

/// A colour, a picture or squares of two colours, in the field `colour`.
fn paint(fields: &Fields) -> Result<Paint, TextError> {
    let value = fields.need("colour", |fields, key| Ok(fields.value(key)))?;
    if !value.get_ref().is_table() {
        return fields.need("colour", Fields::share).map(Paint::Plain);
    }
    let fields = fields.of(value, "colour", "a `colour` that is a table")?;
    let paint = if let Some(squares) = fields.value("squares") {
        let list = squares.get_ref().as_array();
        let colours = list.filter(|list| list.len() == 2).and_then(|list| {
            let mut colours = list.iter().map(|value| colour(value.get_ref(), 1.0));
            Some([colours.next()??, colours.next()??])
        });
        let message =
            "`squares` must be two colours, [[red, green, blue], [red, green, blue]], from 0 to 1";
        let colours = colours.ok_or_else(|| fields.wrong("squares", message))?;
        let side = fields.number("side", 1e-6..=1e6)?.unwrap_or(1.0);
        Paint::Squares { colours, side }
    } else {
        let repeat = fields.number("repeat", 1e-6..=1e6)?.unwrap_or(1.0);
        let map = Arc::new(MipMap::new(&picture(&fields)?));
        Paint::Picture { map, repeat }
    };
    fields.finish()?;
    Ok(paint)
}

impl Paint {
    fn make<M: Material + 'static>(
        self,
        make: impl Fn(Rgb) -> M + Send + Sync + 'static,
    ) -> Arc<dyn Material> {
        match self {
            Self::Plain(colour) => Arc::new(make(colour)),
            paint => Arc::new(Painted { paint, make }),
        }
    }

    fn at(&self, surface: &Surface) -> Rgb {
        match self {
            Self::Plain(colour) => *colour,
            Self::Picture { map, repeat } => {
                let (place, width) = (surface.texture, surface.texture_width);
                let colour = map.at(place * *repeat, width * *repeat);
                colour.map(|v| v.clamp(0.0, 1.0))
            }
            Self::Squares { colours, side } => {
                colours[usize::from(is_odd(surface.texture / *side))]
            }
        }
    }
}

/// A material that is made of the paint's colour, place by place.
struct Painted<F> {
    paint: Paint,
    make: F,
}

impl<M: Material, F: Fn(Rgb) -> M + Send + Sync> Texture for Painted<F> {
    type Material = M;

    fn at(&self, surface: &Surface) -> M {
        (self.make)(self.paint.at(surface))
    }
}
