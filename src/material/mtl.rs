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
use crate::material::{Material, glowing::Glowing, lambert::Lambert, texture::Texture};
use crate::shape::Surface;
use crate::shape::word::{self, Reason, Word, Wrong};
use std::collections::BTreeSet;
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
    /// The file of the picture that `specular` is multiplied by (`map_Ks`).
    pub specular_map: Option<String>,
    /// The file of the normal map (`norm`).
    pub normal_map: Option<String>,
    /// Keywords of the format that describe what this library does not have, such as `map_Bump`: a picture of heights.
    pub unused: BTreeSet<&'static str>,
}

/// The pictures of a material.
#[derive(Clone, Debug, Default)]
pub struct Maps {
    /// The picture of `diffuse_map`.
    pub diffuse: Option<Arc<MipMap>>,
    /// The picture of `specular_map`.
    pub specular: Option<Arc<MipMap>>,
}

/// The keywords of [`Mtl::unused`]: bumps and displacement by heights, maps of other properties, and the extension for physically
/// based rendering.
const UNUSED: [&str; 27] = [
    "map_Bump", "map_bump", "bump", "disp", "decal", "refl", "map_refl", "map_d", "map_Tr",
    "map_Ns", "map_Ke", "map_Ni", "Tf", "Pr", "map_Pr", "Pm", "map_Pm", "Ps", "map_Ps", "Pc",
    "Pcr", "aniso", "anisor", "map_Pc", "map_RMA", "map_ORM", "map_Disp",
];

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
            specular_map: None,
            normal_map: None,
            unused: BTreeSet::new(),
        }
    }

    /// The material; `maps` are the pictures that it names.
    ///
    /// A material with `Ke` above 0 only emits light. A transparent one (`d` < 0.99, or `illum` 4, 6, 7 or 9) is smooth glass.
    /// `illum` 3 and 5 are a mirror over a matte ground. `illum` 2 with a `Ks` above 0 is matte with a highlight. All others are
    /// matte.
    pub fn material(&self, maps: Maps) -> Arc<dyn Material> {
        if self.emitted != Rgb::BLACK {
            return Arc::new(Glowing {
                radiance: self.emitted,
            });
        }
        if self.opacity < 0.99 || matches!(self.model, 4 | 6 | 7 | 9) {
            return Arc::new(Glass::of(Medium::clear(self.index)));
        }
        let exponent = self.exponent;
        match self.model {
            3 | 5 => self.coloured(maps, |diffuse, specular| Polished {
                mirror: Mirror { share: specular },
                below: Lambert { albedo: diffuse },
            }),
            2 if self.specular != Rgb::BLACK => {
                self.coloured(maps, move |diffuse, specular| ModifiedPhong {
                    // So no more light leaves than arrives.
                    diffuse: diffuse * (1.0 - specular.max_channel()),
                    specular,
                    exponent,
                })
            }
            _ => self.coloured(maps, |diffuse, _| Lambert { albedo: diffuse }),
        }
    }

    /// A material of the colours `diffuse` and `specular`, times the colours of the pictures if there are any.
    fn coloured<M: Material + 'static>(
        &self,
        maps: Maps,
        make: impl Fn(Rgb, Rgb) -> M + Send + Sync + 'static,
    ) -> Arc<dyn Material> {
        let (diffuse, specular) = (self.diffuse, self.specular);
        if maps.diffuse.is_none() && maps.specular.is_none() {
            return Arc::new(make(diffuse, specular));
        }
        Arc::new(Mapped {
            diffuse: (diffuse, maps.diffuse),
            specular: (specular, maps.specular),
            make,
        })
    }
}

/// A material of two colours, each with the picture that it is multiplied by, if there is one.
struct Mapped<F> {
    diffuse: (Rgb, Option<Arc<MipMap>>),
    specular: (Rgb, Option<Arc<MipMap>>),
    make: F,
}

impl<M: Material, F: Fn(Rgb, Rgb) -> M + Send + Sync> Texture for Mapped<F> {
    type Material = M;

    fn at(&self, surface: &Surface) -> M {
        let colour = |(colour, map): &(Rgb, Option<Arc<MipMap>>)| match map {
            Some(map) => (map.at(surface.texture, surface.texture_width) * *colour)
                .map(|v| v.clamp(0.0, 1.0)),
            None => *colour,
        };
        (self.make)(colour(&self.diffuse), colour(&self.specular))
    }
}

/// The materials of an MTL text. Keywords that are not in [`Mtl`] are ignored; [`Mtl::unused`] has those that would change the
/// picture. Numbers are clamped: shares to [0, 1], `Ns` to
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
            "Kd", "Ks", "Ns", "Ke", "Ni", "d", "Tr", "illum", "map_Kd", "map_Ks", "norm",
        ];
        let is_word = |word: &&'static str| *word == words[0].text;
        let unused = UNUSED.into_iter().find(is_word);
        if !known.contains(&words[0].text) && unused.is_none() {
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
            "map_Ks" => mtl.specular_map = Some(file(&words, "a picture (map_Ks)")?),
            "norm" => mtl.normal_map = Some(file(&words, "a picture (norm)")?),
            _ => mtl.unused.extend(unused),
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
