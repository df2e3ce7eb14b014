//! The bytes of picture files, by the crates `exr` and `image`.

use crate::image::{Image, rgb::Rgb, tone};
use crate::memory::{BUDGET, gigabytes};
use exr::meta::BlockDescription;
use exr::meta::header::Header;
use exr::prelude::{ReadChannels, ReadLayers, WritableImage};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ImageDecoder, ImageEncoder, ImageError, ImageResult, Limits};
use std::io::Cursor;
use std::thread;

/// Maximum number of pixels per byte of an EXR file: its densest blocks, of 256 rows, take tens of bytes each.
/// A damaged header may claim any size, and no memory must be allocated for a size that the file cannot hold.
const PIXELS_PER_BYTE: usize = 1 << 14;

pub(super) fn encode_exr(picture: &Image) -> Result<Vec<u8>, String> {
    let mut bytes = Cursor::new(Vec::new());
    let channels = exr::prelude::SpecificChannels::rgb(|at: exr::prelude::Vec2<usize>| {
        let Rgb { r, g, b } = picture.at(at.x(), at.y());
        (r, g, b)
    });
    exr::prelude::Image::from_channels((picture.width(), picture.height()), channels)
        .write()
        .non_parallel() // in parallel, the order of the blocks would depend on the threads
        .to_buffered(&mut bytes)
        .map_err(|e| e.to_string())?;
    Ok(bytes.into_inner())
}

/// Refuses a picture whose pixels, and `decoding` bytes while it is decoded, would take more memory than the [`BUDGET`].
fn afford(width: u64, height: u64, decoding: u64) -> Result<(), String> {
    let pixels = width.saturating_mul(height);
    let needed = pixels
        .saturating_mul(size_of::<Rgb>() as u64)
        .saturating_add(decoding);
    if needed <= BUDGET {
        return Ok(());
    }
    Err(format!(
        "{width} × {height} pixels take {} of memory, and a picture may take {}; scale it down, or cut it up",
        gigabytes(needed),
        gigabytes(BUDGET)
    ))
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
        afford(width as u64, height as u64, blocks_of_exr(header))?;
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

/// Size of the blocks that the decoder holds at the same time, packed and unpacked, in bytes.
fn blocks_of_exr(header: &Header) -> u64 {
    let [width, height] = [header.layer_size.width(), header.layer_size.height()];
    let lines = header.compression.scan_lines_per_block();
    let block = match header.blocks {
        BlockDescription::ScanLines => width.saturating_mul(lines),
        BlockDescription::Tiles(tiles) => {
            let [across, down] = [tiles.tile_size.width(), tiles.tile_size.height()];
            across.saturating_mul(down)
        }
    };
    // One block for each thread, and two that wait (`ParallelBlockDecompressor`), but no more than the picture has.
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let blocks = (width.saturating_mul(height) / block.max(1) + 1).min(threads + 2);
    let bytes = block.saturating_mul(header.channels.bytes_per_pixel);
    (2 * blocks).saturating_mul(bytes) as u64
}

pub(super) fn encode_hdr(picture: &Image) -> Result<Vec<u8>, String> {
    /// The largest value that is written. The exponent is a byte, and the encoder lets it overflow: from 2¹²⁷ on, white would
    /// turn black, and below 2⁻¹²⁸, black would turn white.
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
    /// Height of a strip in rows, and one of how many strips belongs to the sample.
    const STRIP: usize = 16;
    const EVERY: usize = 8;
    let pixels = tone::to_bytes(picture);
    let width = picture.width();
    // A rendered picture is smaller with filtered lines, a drawing with few colours is smaller without. A sample of strips tells;
    // the one in the middle is among them.
    let strips = pixels.chunks((3 * width * STRIP).max(1));
    let first = strips.len() / 2 % EVERY;
    let sample: Vec<_> = strips.skip(first).step_by(EVERY).collect();
    let sample = sample.concat();
    let size = |filter| compressed_png(&sample, width, filter).map(|bytes| bytes.len());
    let filter = if size(FilterType::NoFilter)? < size(FilterType::Adaptive)? {
        FilterType::NoFilter
    } else {
        FilterType::Adaptive
    };
    compressed_png(&pixels, width, filter)
}

/// The PNG file of rows of pixels, three bytes each.
fn compressed_png(pixels: &[u8], width: usize, filter: FilterType) -> Result<Vec<u8>, String> {
    let mut bytes = Cursor::new(Vec::new());
    let height = pixels.len() / (3 * width).max(1);
    // Smaller by a quarter than with the encoder's default, and still written in some hundredths of a second.
    PngEncoder::new_with_quality(&mut bytes, CompressionType::Default, filter)
        .write_image(
            pixels,
            width as u32,
            height as u32,
            image::ExtendedColorType::Rgb8,
        )
        .map_err(|e| e.to_string())?;
    Ok(bytes.into_inner())
}

pub(super) fn decode_hdr(bytes: &[u8]) -> Result<Image, String> {
    decode(
        image::codecs::hdr::HdrDecoder::new(Cursor::new(bytes)),
        |v| v,
    )
}

/// The linear radiance of a PNG's code values, without their opacity.
pub(super) fn decode_png(bytes: &[u8]) -> Result<Image, String> {
    // This limits the memory for colour profiles and texts; `afford` limits that for the pixels.
    let mut limits = Limits::default();
    limits.max_alloc = Some(BUDGET);
    let decoder = image::codecs::png::PngDecoder::with_limits(Cursor::new(bytes), limits);
    decode(decoder, tone::decode_srgb)
}

/// The message for a decoder's error.
fn told(error: &ImageError) -> String {
    match error {
        ImageError::Limits(_) => format!(
            "decoding it takes more memory than a picture may take, {}; scale it down, or cut it up",
            gigabytes(BUDGET)
        ),
        error => error.to_string(),
    }
}

/// The picture of a decoder, as linear radiance; memory is allocated only after the header's size has been checked.
fn decode<D: ImageDecoder>(
    decoder: ImageResult<D>,
    to_linear: fn(f32) -> f32,
) -> Result<Image, String> {
    let decoder = decoder.map_err(|e| told(&e))?;
    let (width, height) = decoder.dimensions();
    let (colour, size) = (decoder.color_type(), decoder.total_bytes());
    afford(width.into(), height.into(), size)?;
    let channels = usize::from(colour.channel_count());
    let bytes = usize::from(colour.bytes_per_pixel()) / channels;
    let value = match bytes {
        1 => |sample: &[u8]| f32::from(sample[0]) / 255.0,
        2 => |sample: &[u8]| f32::from(u16::from_ne_bytes([sample[0], sample[1]])) / 65535.0,
        4 => |sample: &[u8]| f32::from_ne_bytes([sample[0], sample[1], sample[2], sample[3]]),
        _ => return Err(format!("its samples are of an unknown kind, {colour:?}")),
    };
    let mut samples = vec![0; size as usize];
    decoder.read_image(&mut samples).map_err(|e| told(&e))?;
    let sample = |i: usize| to_linear(value(&samples[i * bytes..][..bytes]));
    let (width, height) = (width as usize, height as usize);
    Ok(Image::from_fn(width, height, |x, y| {
        let first = (y * width + x) * channels;
        match channels {
            1 | 2 => Rgb::gray(sample(first)),
            _ => Rgb::new(sample(first), sample(first + 1), sample(first + 2)),
        }
    }))
}
