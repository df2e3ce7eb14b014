//! The bytes of picture files, by the crates `exr` and `image`.

use crate::image::{Image, rgb::Rgb, tone};
use exr::prelude::{ReadChannels, ReadLayers, WritableImage};
use image::ImageEncoder;
use std::io::Cursor;

/// No EXR file packs more pixels into a byte: its densest blocks, of 256 rows, take tens of bytes each.
/// A damaged header may claim any size, and memory for it must not be asked for before it is known to be a lie.
const PIXELS_PER_BYTE: usize = 1 << 14;

pub(super) fn encode_exr(picture: &Image) -> Result<Vec<u8>, String> {
    let mut bytes = Cursor::new(Vec::new());
    let channels = exr::prelude::SpecificChannels::rgb(|at: exr::prelude::Vec2<usize>| {
        let Rgb { r, g, b } = picture.at(at.x(), at.y());
        (r, g, b)
    });
    exr::prelude::Image::from_channels((picture.width(), picture.height()), channels)
        .write()
        .non_parallel() // in parallel, the blocks are written in the order in which they get ready
        .to_buffered(&mut bytes)
        .map_err(|e| e.to_string())?;
    Ok(bytes.into_inner())
}

pub(super) fn decode_exr(bytes: &[u8]) -> Result<Image, String> {
    let file = exr::block::read(Cursor::new(bytes), false).map_err(|e| e.to_string())?;
    for header in file.headers() {
        let (width, height) = (header.layer_size.width(), header.layer_size.height());
        let most = bytes.len().saturating_mul(PIXELS_PER_BYTE);
        if width.saturating_mul(height) > most {
            return Err(format!(
                "{} bytes cannot hold {width} × {height} pixels",
                bytes.len()
            ));
        }
    }
    let read = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(
            |size, _| Image::from_fn(size.width(), size.height(), |_, _| Rgb::BLACK),
            |picture, at, (r, g, b): (f32, f32, f32)| {
                picture.set(at.x(), at.y(), Rgb::new(r, g, b));
            },
        )
        .first_valid_layer()
        .all_attributes()
        .from_chunks(file);
    read.map(|file| file.layer_data.channel_data.pixels)
        .map_err(|e| e.to_string())
}

pub(super) fn encode_hdr(picture: &Image) -> Result<Vec<u8>, String> {
    /// The exponent is a byte, and the encoder lets it overflow: from 2¹²⁷ on white would turn black,
    /// and below 2⁻¹²⁸ black would turn white.
    const LARGEST: f32 = 1.7e38;
    let representable = |v: f32| {
        if v >= f32::MIN_POSITIVE {
            v.min(LARGEST)
        } else {
            0.0 // negative, NaN, or smaller than any light
        }
    };
    let pixels: Vec<_> = picture
        .pixels()
        .iter()
        .map(|p| image::Rgb(p.map(representable).channels()))
        .collect();
    let mut bytes = Vec::new();
    image::codecs::hdr::HdrEncoder::new(&mut bytes)
        .encode(&pixels, picture.width(), picture.height())
        .map_err(|e| e.to_string())?;
    Ok(bytes)
}

pub(super) fn encode_png(picture: &Image) -> Result<Vec<u8>, String> {
    let mut bytes = Cursor::new(Vec::new());
    let (width, height) = (picture.width() as u32, picture.height() as u32);
    let colour = image::ExtendedColorType::Rgb8;
    image::codecs::png::PngEncoder::new(&mut bytes)
        .write_image(&tone::to_bytes(picture), width, height, colour)
        .map_err(|e| e.to_string())?;
    Ok(bytes.into_inner())
}

pub(super) fn decode_with_image(
    bytes: &[u8],
    format: image::ImageFormat,
    to_linear: fn(f32) -> f32,
) -> Result<Image, String> {
    let decoded = image::load_from_memory_with_format(bytes, format)
        .map_err(|e| e.to_string())?
        .to_rgb32f();
    let (width, height) = (decoded.width() as usize, decoded.height() as usize);
    Ok(Image::from_fn(width, height, |x, y| {
        let [r, g, b] = decoded.get_pixel(x as u32, y as u32).0;
        Rgb::new(r, g, b).map(to_linear)
    }))
}
