//! MTL files: the materials of a Wavefront OBJ, one line for each property.
//!
//! ```
//! use raybook::material::mtl;
//!
//! let materials = mtl::parse("newmtl brick\nKd 0.6 0.2 0.1\nmap_Kd wall.png\n")?;
//! assert_eq!((materials[0].name.as_str(), materials[0].diffuse.r), ("brick", 0.6));
//! assert_eq!(materials[0].diffuse_map.as_deref(), Some("wall.png"));
//! # Ok::<(), raybook::shape::word::Wrong>(())
//! ```

use crate::image::{mip::MipMap, rgb::Rgb};
use crate::material::glass::{Glass, Medium};
use crate::material::mirror::Mirror;
use crate::material::modified_phong::ModifiedPhong;
use crate::material::polished::Polished;
use crate::material::{Material, glowing::Glowing, image_texture::ImageTexture, lambert::Lambert};
use crate::shape::word::{self, Reason, Word, Wrong};
use std::sync::Arc;

/// A material as the file describes it.
#[derive(Clone, Debug, PartialEq)]
pub struct Mtl {
    /// The material's name (`newmtl`).
    pub name: String,
    /// The share of the light that is scattered to all sides (`Kd`), from 0 to 1.
    pub diffuse: Rgb,
    /// The share that leaves in the highlight or in the mirror (`Ks`), from 0 to 1.
    pub specular: Rgb,
    /// The highlight's exponent (`Ns`).
    pub exponent: f32,
    /// The emitted radiance (`Ke`), in W·m⁻²·sr⁻¹.
    pub emitted: Rgb,
    /// The index of refraction (`Ni`).
    pub index: f32,
    /// The opacity (`d`, or 1 − `Tr`), from 0 to 1.
    pub opacity: f32,
    /// The number of the illumination model (`illum`).
    pub model: u32,
    /// The file of the picture that `diffuse` is multiplied by (`map_Kd`).
    pub diffuse_map: Option<String>,
    /// The file of the normal map (`norm`).
    pub normal_map: Option<String>,
}

/// What a colour (`Kd`, `Ks`, `Ke`) needs, for error messages.
const COLOUR: &str = "1 number, or 3 for red, green and blue";

impl Mtl {
    fn new(name: String) -> Self {
        Self {
            name,
            diffuse: Rgb::gray(0.8),
            specular: Rgb::BLACK,
            exponent: 0.0,
            emitted: Rgb::BLACK,
            index: 1.5,
            opacity: 1.0,
            model: 2,
            diffuse_map: None,
            normal_map: None,
        }
    }

    /// The material; `map` is the picture of `diffuse_map`, if there is one.
    ///
    /// A material with `Ke` above 0 only emits light. A transparent one (`d` < 0.99, or `illum` 4, 6, 7 or 9) is smooth glass.
    /// `illum` 3 and 5 are a mirror over a matte ground. `illum` 2 with a `Ks` above 0 is matte with a highlight. All others are
    /// matte.
    pub fn material(&self, map: Option<Arc<MipMap>>) -> Arc<dyn Material> {
        if self.emitted != Rgb::BLACK {
            return Arc::new(Glowing {
                radiance: self.emitted,
            });
        }
        if self.opacity < 0.99 || matches!(self.model, 4 | 6 | 7 | 9) {
            return Arc::new(Glass::of(Medium::clear(self.index)));
        }
        let (specular, diffuse, exponent) = (self.specular, self.diffuse, self.exponent);
        match self.model {
            3 | 5 => coloured(map, diffuse, move |albedo| Polished {
                mirror: Mirror { share: specular },
                below: Lambert { albedo },
            }),
            2 if specular != Rgb::BLACK => coloured(map, diffuse, move |albedo| ModifiedPhong {
                // So no more light leaves than arrives.
                diffuse: albedo * (1.0 - specular.max_channel()),
                specular,
                exponent,
            }),
            _ => coloured(map, diffuse, |albedo| Lambert { albedo }),
        }
    }
}

/// A material of one colour, or of the colours of a picture times this colour.
fn coloured<M: Material + 'static>(
    map: Option<Arc<MipMap>>,
    colour: Rgb,
    make: impl Fn(Rgb) -> M + Send + Sync + 'static,
) -> Arc<dyn Material> {
    let share = |v: f32| v.clamp(0.0, 1.0);
    match map {
        Some(map) => Arc::new(ImageTexture::new(map, move |texel: Rgb| {
            make((texel * colour).map(share))
        })),
        None => Arc::new(make(colour)),
    }
}

/// The materials of an MTL text. Keywords that are not in [`Mtl`] are ignored. Numbers are clamped: shares to [0, 1], `Ns` to
/// [0, 10⁶], `Ni` to [1, 4], and a negative `Ke` to 0.
///
/// # Errors
/// The first error, with its line and column.
pub fn parse(text: &str) -> Result<Vec<Mtl>, Wrong> {
    let mut all: Vec<Mtl> = Vec::new();
    for words in word::lines(text) {
        if words[0].text == "newmtl" {
            all.push(Mtl::new(word::name(&words)));
            continue;
        }
        let known = [
            "Kd", "Ks", "Ns", "Ke", "Ni", "d", "Tr", "illum", "map_Kd", "norm",
        ];
        if !known.contains(&words[0].text) {
            continue;
        }
        let Some(mtl) = all.last_mut() else {
            return Err(words[0].expected("newmtl and a name, before the first property"));
        };
        let share = |v: f32| v.clamp(0.0, 1.0);
        match words[0].text {
            "Kd" => mtl.diffuse = colour(&words, "a colour (Kd)")?.map(share),
            "Ks" => mtl.specular = colour(&words, "a colour (Ks)")?.map(share),
            "Ke" => mtl.emitted = colour(&words, "a colour (Ke)")?.map(|v| v.max(0.0)),
            "Ns" => mtl.exponent = one(&words, "an exponent (Ns)")?.clamp(0.0, 1e6),
            "Ni" => mtl.index = one(&words, "an index of refraction (Ni)")?.clamp(1.0, 4.0),
            "d" => mtl.opacity = share(one(&words, "an opacity (d)")?),
            "Tr" => mtl.opacity = 1.0 - share(one(&words, "a transparency (Tr)")?),
            "illum" => mtl.model = one(&words, "a model (illum)")? as u32,
            "map_Kd" => mtl.diffuse_map = Some(file(&words, "a picture (map_Kd)")?),
            _ => mtl.normal_map = Some(file(&words, "a picture (norm)")?),
        }
    }
    Ok(all)
}

fn one(words: &[Word], what: &'static str) -> Result<f32, Wrong> {
    Ok(word::numbers(words, 1..=1, what, "1 number")?[0])
}

fn colour(words: &[Word], what: &'static str) -> Result<Rgb, Wrong> {
    match *word::numbers(words, 1..=3, what, COLOUR)? {
        [v] => Ok(Rgb::gray(v)),
        [r, g, b] => Ok(Rgb::new(r, g, b)),
        _ => Err(words[0].wrong(Reason::Count {
            what,
            needs: COLOUR,
            found: 2,
        })),
    }
}

/// The name of a file: all words after the keyword, or the last word if there are options, as in `-s 1 1 1 wood.png`.
fn file(words: &[Word], what: &'static str) -> Result<String, Wrong> {
    let name = match words.get(1) {
        Some(first) if first.text.starts_with('-') => words[words.len() - 1].text.to_owned(),
        _ => word::name(words),
    };
    if name.is_empty() {
        return Err(words[0].wrong(Reason::Count {
            what,
            needs: "the name of a file",
            found: 0,
        }));
    }
    Ok(name.replace('\\', "/"))
}
