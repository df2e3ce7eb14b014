//! Small files that promise pictures larger than the budget of memory: the header is asked before anything is decoded.

use super::damage::{bytes_of, read_as};
use raybook::memory::BUDGET;

/// A chunk of a PNG.
fn chunk(kind: &[u8], content: &[u8]) -> Vec<u8> {
    let checked = [kind, content].concat();
    let mut sum = !0_u32;
    for byte in &checked {
        sum ^= u32::from(*byte);
        for _ in 0..8 {
            sum = (sum >> 1) ^ (0xedb8_8320 & (sum & 1).wrapping_neg());
        }
    }
    let length = (content.len() as u32).to_be_bytes();
    [&length[..], &checked, &(!sum).to_be_bytes()].concat()
}

/// A PNG of this size, bits a sample and colour type, with next to nothing in it.
fn png(width: u32, height: u32, bits: u8, colour: u8) -> Vec<u8> {
    let size = [width.to_be_bytes(), height.to_be_bytes()].concat();
    let header = [&size[..], &[bits, colour, 0, 0, 0]].concat();
    // An empty stream that is sound so far as it goes.
    let data = chunk(b"IDAT", &[0x78, 0x9c, 0x03, 0x00]);
    let chunks = [chunk(b"IHDR", &header), data, chunk(b"IEND", &[])];
    [&b"\x89PNG\r\n\x1a\n"[..], &chunks.concat()].concat()
}

fn hdr(width: u32, height: u32) -> Vec<u8> {
    format!("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n").into_bytes()
}

/// An EXR of as many bytes, whose header is that of another picture.
fn exr(length: usize, attributes: &[(&[u8], usize, i32)]) -> Vec<u8> {
    let mut lying = bytes_of("exr");
    for (attribute, offset, value) in attributes {
        let found = lying.windows(attribute.len()).position(|w| w == *attribute);
        // After the name and the type, each with its 0, come four bytes of length, then the value.
        let at = found.expect("the header has it") + attribute.len() + 4 + offset;
        lying[at..at + 4].copy_from_slice(&value.to_le_bytes());
    }
    lying.resize(length, 0);
    lying
}

/// What is said of a file of this format.
fn said(extension: &str, bytes: &[u8]) -> String {
    read_as(extension, bytes)
        .expect_err("nothing of this size is in it")
        .to_string()
}

#[test]
fn a_picture_over_the_budget_is_refused_by_its_header() {
    let window: &[u8] = b"dataWindow\0box2i\0";
    let count: &[u8] = b"chunkCount\0int\0";
    let tiles: &[u8] = b"tiles\0tiledesc\0";
    // 157 × 157 tiles of 64 × 64.
    let wide = [(window, 8, 9999), (window, 12, 9999), (count, 0, 157 * 157)];
    for (extension, bytes, size) in [
        ("png", png(13_000, 13_000, 8, 2), "13000 × 13000"),
        ("png", png(8000, 8000, 16, 6), "8000 × 8000"),
        ("hdr", hdr(10_000, 10_000), "10000 × 10000"),
        ("exr", exr(200_000, &wide), "10000 × 10000"),
        // A small picture in an enormous tile.
        (
            "exr",
            exr(
                200_000,
                &[(tiles, 0, 1 << 20), (tiles, 4, 1 << 20), (count, 0, 1)],
            ),
            "40 × 23",
        ),
    ] {
        let error = said(extension, &bytes);
        for part in [
            &*format!("picture.{extension}: cannot be read as "),
            &format!("{size} pixels take "),
            "GB of memory, and a picture may take 1.1 GB; scale it down",
        ] {
            assert!(error.contains(part), "no `{part}` in: {error}");
        }
    }
    assert_eq!(BUDGET, 1 << 30, "of which the errors speak");
}

#[test]
fn a_header_that_no_memory_could_follow_is_refused() {
    for bytes in [hdr(u32::MAX, u32::MAX), hdr(2_000_000_000, 2_000_000_000)] {
        said("hdr", &bytes);
    }
    for (width, height) in [(2_000_000_000, 2), (0x7fff_ffff, 0x7fff_ffff)] {
        let error = said("png", &png(width, height, 16, 6));
        assert!(
            error.contains("memory") && error.contains("1.1 GB"),
            "{error}"
        );
    }
}

#[test]
fn the_widest_picture_that_a_chapter_draws_is_within_the_budget() {
    let error = said("png", &png(8192, 8192, 8, 2));
    assert!(
        !error.contains("of memory"),
        "only its pixels miss: {error}"
    );
    let error = said("hdr", &hdr(8192, 4096));
    assert!(!error.contains("of memory"), "an environment: {error}");
}
