//! Image textures: the colour of each place is looked up in a picture.
//!
//! ```
//! use raybook::material::texture::Texture;
//! use raybook::prelude::*;
//!
//! let stripes = Image::from_fn(2, 1, |x, _| Rgb::gray([0.2, 0.8][x]));
//! let paper = ImageTexture::new(MipMap::new(&stripes), |albedo| Lambert { albedo });
//! let flat = Surface::flat(Vec3::ZERO, 0.0, Dir3::Y);
//! assert_eq!(paper.at(&Surface { texture: vec2(0.25, 0.5), ..flat }).albedo, Rgb::gray(0.2)); // the middle of a pixel
//! ```

use crate::image::{mip::MipMap, rgb::Rgb};
use crate::material::{Material, texture::Texture};
use crate::shape::Surface;
use std::fmt;
use std::sync::Arc;

/// A material that depends on the colour of a picture at the surface's texture coordinates (Catmull 1974; Blinn and Newell 1976).
///
/// ```
/// use raybook::prelude::*;
///
/// let stripes = Image::from_fn(2, 1, |x, _| Rgb::gray([0.2, 0.8][x]));
/// let paper = ImageTexture::new(MipMap::new(&stripes), |albedo| Lambert { albedo });
/// let ball = Thing::new(Sphere::new(Vec3::ZERO, 1.0), paper);
/// ```
pub struct ImageTexture<M> {
    /// The picture. Materials may share it.
    pub map: Arc<MipMap>,
    /// The least width, in texture coordinates, over which colours are averaged; 0 for the sharpest picture without aliasing.
    pub width: f32,
    /// The material for a colour.
    pub make: Box<dyn Fn(Rgb) -> M + Send + Sync>,
}

impl<M> ImageTexture<M> {
    /// The picture with the least `width` 0, on a surface whose material `make` returns for a colour.
    pub fn new(
        map: impl Into<Arc<MipMap>>,
        make: impl Fn(Rgb) -> M + Send + Sync + 'static,
    ) -> Self {
        Self {
            map: map.into(),
            width: 0.0,
            make: Box::new(make),
        }
    }
}

impl<M> fmt::Debug for ImageTexture<M> {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.debug_struct("ImageTexture")
            .field("width", &self.width)
            .finish_non_exhaustive()
    }
}

impl<M: Material> Texture for ImageTexture<M> {
    type Material = M;

    fn at(&self, surface: &Surface) -> M {
        let width = self.width.max(surface.texture_width);
        (self.make)(self.map.at(surface.texture, width))
    }
}
