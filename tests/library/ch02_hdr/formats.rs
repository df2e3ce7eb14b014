//! Picture files: what each format keeps.

use super::{lights, no_partial_file_in};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder};
use rand::RngExt;
use raybook::image::{Image, file, rgb::Rgb, tone};
use raybook::math::pcg;

/// A picture with every kind of number that a file has to keep.
fn extremes() -> Image {
    let values = [
        0.0,
        f32::MIN_POSITIVE,
        1e-40, // subnormal
        1e-5,
        0.1,
        1.0,
        std::f32::consts::PI,
        123_456.79,
        1e30,
        f32::MAX,
        f32::INFINITY,
        -2.5,
    ];
    Image::from_fn(11, 7, |x, y| {
        let value = |i: usize| values[i % values.len()];
        Rgb::new(value(x + y), value(x + 5 * y + 1), value(3 * x + y + 2))
    })
}

#[test]
fn exr_keeps_every_bit() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("deep/er/picture.exr");
    for (name, picture) in [("extremes", extremes()), ("lights", lights())] {
        file::save(&path, &picture).expect("it can be written, and its folder made");
        let kept = file::load(&path).expect("it can be read");
        assert!(kept.same_bits(&picture), "{name}: every bit is as it was");
    }
    let nan = Image::from_fn(1, 1, |_, _| Rgb::new(f32::NAN, 1.0, -0.0));
    file::save(&path, &nan).expect("NaN can be written");
    assert!(
        file::load(&path).expect("it can be read").same_bits(&nan),
        "NaN and −0 too"
    );
    no_partial_file_in(path.parent().expect("it has a folder"));
}

#[test]
fn hdr_keeps_each_channel_to_a_128th_of_the_largest() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("picture.hdr");
    let picture = lights();
    file::save(&path, &picture).expect("it can be written");
    let kept = file::load(&path).expect("it can be read");
    assert_eq!((kept.width(), kept.height()), (40, 23), "the size");
    let mut worst: f32 = 0.0;
    for (a, b) in picture.pixels().iter().zip(kept.pixels()) {
        let largest = a.r.max(a.g).max(a.b);
        for (a, b) in a.channels().into_iter().zip(b.channels()) {
            worst = worst.max((a - b).abs() / largest);
        }
    }
    assert!(
        worst <= 1.0 / 128.0,
        "an error of {worst} of the largest channel"
    );
    assert!(
        worst > 1.0 / 1024.0,
        "8 bits cannot be better than this: the file was not an RGBE ({worst})"
    );
    no_partial_file_in(folder.path());
}

#[test]
fn hdr_clamps_what_its_exponent_cannot_hold() {
    // The encoder alone would turn the first four black or into noise, and 1e-40 white.
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("picture.hdr");
    for (v, least, most) in [
        (f32::MAX, 1e38, f32::MAX),
        (f32::INFINITY, 1e38, f32::MAX),
        (2e38, 1e38, f32::MAX),
        (1e38, 0.99e38, 1.01e38),
        (1e-40, 0.0, 1e-37),
        (0.0, 0.0, 0.0),
        (-3.0, 0.0, 0.0),
        (f32::NAN, 0.0, 0.0),
    ] {
        file::save(&path, &Image::from_fn(9, 2, |_, _| Rgb::gray(v))).expect("it can be written");
        let kept = file::load(&path).expect("it can be read").at(4, 1);
        assert!(
            (least..=most).contains(&kept.g),
            "{v} came back as {kept:?}"
        );
    }
}

#[test]
fn png_keeps_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("picture.PNG");
    // Every byte in every channel.
    let linear = |byte: usize| tone::decode_srgb((byte % 256) as f32 / 255.0);
    let picture = Image::from_fn(16, 16, |x, y| {
        let i = 16 * y + x;
        Rgb::new(linear(i), linear(i + 85), linear(255 - i))
    });
    file::save(&path, &picture).expect("it can be written, in capitals too");
    assert!(
        file::load(&path)
            .expect("it can be read")
            .same_bits(&picture),
        "all bytes come back"
    );
    file::save(
        &path,
        &Image::from_fn(2, 1, |_, _| Rgb::new(-1.0, 1e9, f32::NAN)),
    )
    .expect("it can be written");
    let clamped = file::load(&path).expect("it can be read").at(1, 0);
    assert_eq!(
        clamped,
        Rgb::new(0.0, 1.0, 0.0),
        "what no display can show is clamped"
    );
}

/// Without filters, drawings are smaller; with filters, rendered pictures are. The smaller of both files is written.
#[test]
fn png_is_as_small_as_the_better_of_two_filters() {
    let mut rng = pcg::stream(2, 1);
    let drawing = Image::from_fn(96, 96, |_, _| {
        Rgb::gray(f32::from(u8::from(rng.random_bool(0.2))))
    });
    let rendered = Image::from_fn(96, 96, |x, y| {
        let [x, y] = [x, y].map(|v| v as f32 / 96.0);
        Rgb::new(x * y, 0.5 * (x + y), (x - 0.3).powi(2))
    });
    let filters = [FilterType::Adaptive, FilterType::NoFilter];
    let better = [drawing, rendered].map(|picture| {
        let sizes = filters.map(|filter| {
            let (mut bytes, (w, h)) = (Vec::new(), (picture.width(), picture.height()));
            PngEncoder::new_with_quality(&mut bytes, CompressionType::Default, filter)
                .write_image(
                    &tone::to_bytes(&picture),
                    w as u32,
                    h as u32,
                    ExtendedColorType::Rgb8,
                )
                .expect("it can be written");
            bytes.len()
        });
        let written = file::to_png(&picture).expect("it has pixels").len();
        assert_eq!(written, sizes[0].min(sizes[1]), "of {sizes:?}");
        sizes[1] < sizes[0]
    });
    assert_eq!(
        better,
        [true, false],
        "each filter is better for one of them"
    );
}
