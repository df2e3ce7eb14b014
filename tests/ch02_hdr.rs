//! Chapter 2: exposure, tone curves, sRGB, picture files, the comparison of pictures, and the scene with the window.

use glam::{Vec2, Vec3, vec3};
use proptest::prelude::{ProptestConfig, any, prop_assert, prop_assert_eq, proptest};
use rand::RngExt;
use raybook::camera::{Camera, pinhole::Pinhole};
use raybook::image::compare::{Difference, Tolerance, compare};
use raybook::image::file::{self, FileError};
use raybook::image::{Image, rgb::Rgb, tone};
use raybook::math::{dir3::Dir3, interval::Interval, pcg, ray::Ray};
use raybook::render::film::Film;
use raybook::scene::{evening, noise, window};
use raybook::shape::{Shape, sphere::Sphere};
use std::fs;
use std::path::Path;

/// A few roundings of `f32` on numbers of about 1.
const ROUNDING: f32 = 4.0 * f32::EPSILON;

// ---- exposure and tone ----

#[test]
fn a_stop_is_a_factor_of_two() {
    let light = Rgb::new(0.25, 3.0, 1e5);
    assert_eq!(tone::expose(light, 0.0), light, "0 stops change nothing");
    assert_eq!(
        tone::expose(light, 1.0),
        light * 2.0,
        "one stop more is twice the light"
    );
    assert_eq!(
        tone::expose(light, -3.0),
        light / 8.0,
        "three stops less are an eighth"
    );
    let half = tone::expose(Rgb::WHITE, 0.5).r;
    assert!(
        (half - std::f32::consts::SQRT_2).abs() < ROUNDING,
        "half a stop is √2, not {half}"
    );
}

#[test]
fn clamping_cuts_each_channel() {
    assert_eq!(
        tone::clamp(Rgb::new(-1.0, 0.5, 7.0)),
        Rgb::new(0.0, 0.5, 1.0)
    );
    let orange = Rgb::new(40.0, 20.0, 5.0);
    assert_eq!(
        tone::clamp(orange),
        Rgb::WHITE,
        "an orange that is too bright turns white"
    );
}

#[test]
fn reinhard_maps_all_light_below_one_and_keeps_the_hue() {
    for (l, expected) in [
        (0.0, 0.0),
        (1.0, 0.5),
        (3.0, 0.75),
        (99.0, 0.99),
        (1e6, 1.0),
    ] {
        let mapped = tone::reinhard(Rgb::gray(l)).g;
        assert!(
            (mapped - expected).abs() < 2e-6,
            "{l} becomes {mapped}, not {expected}"
        );
    }
    let orange = Rgb::new(40.0, 20.0, 5.0);
    let mapped = tone::reinhard(orange);
    assert!(
        (mapped.r / mapped.b - 8.0).abs() < 1e-5,
        "8 times more red than blue stays so"
    );
    // Y = 0.2126·40 + 0.7152·20 + 0.0722·5 = 23.169
    assert!(
        (mapped.luminance() - 23.169 / 24.169).abs() < 1e-5,
        "its luminance becomes L/(1 + L)"
    );
    assert!(
        mapped.r > 1.0,
        "a saturated channel may exceed 1: {}",
        mapped.r
    );
}

#[test]
fn the_film_like_curve_rises_from_black_to_white() {
    assert_eq!(tone::aces(Rgb::BLACK), Rgb::BLACK, "no light stays black");
    // (1·2.54)/(1·3.02 + 0.14) by hand
    assert!(
        (tone::aces(Rgb::WHITE).r - 2.54 / 3.16).abs() < ROUNDING,
        "1 becomes 0.804"
    );
    assert_eq!(
        tone::aces(Rgb::gray(1e30)),
        Rgb::WHITE,
        "all the light of the world is white"
    );
    assert_eq!(
        tone::aces(Rgb::gray(f32::INFINITY)),
        Rgb::WHITE,
        "even an infinite radiance"
    );
    assert_eq!(
        tone::aces(Rgb::gray(-1.0)),
        Rgb::BLACK,
        "less than no light is black"
    );
    let curve: Vec<f32> = (-160..=80)
        .map(|i| tone::aces(Rgb::gray((i as f32 / 8.0).exp2())).r)
        .collect();
    assert!(curve.is_sorted(), "more light is never darker");
}

// ---- sRGB ----

#[test]
fn srgb_is_exact_at_both_ends() {
    assert_eq!(
        tone::encode_srgb(0.0).to_bits(),
        0.0_f32.to_bits(),
        "0 is encoded as 0"
    );
    assert_eq!(
        tone::encode_srgb(1.0).to_bits(),
        1.0_f32.to_bits(),
        "1 is encoded as 1"
    );
    assert_eq!(
        (tone::to_byte(0.0), tone::to_byte(1.0)),
        (0, 255),
        "the bytes are 0 and 255"
    );
    assert_eq!(
        (tone::decode_srgb(0.0), tone::decode_srgb(1.0)),
        (0.0, 1.0),
        "and back"
    );
}

#[test]
fn srgb_clamps_what_no_display_can_show() {
    for (v, byte) in [
        (-1.0, 0),
        (-0.0, 0),
        (f32::NAN, 0),
        (f32::NEG_INFINITY, 0),
        (1.0001, 255),
        (1e5, 255),
        (f32::INFINITY, 255),
    ] {
        assert_eq!(tone::to_byte(v), byte, "{v}");
    }
}

#[test]
fn srgb_has_the_values_of_its_standard() {
    // IEC 61966-2-1 in double precision.
    for (v, code) in [
        (0.001, 0.012_92),
        (0.003_130_8, 0.040_449_936),
        (0.01, 0.099_852_6),
        (0.18, 0.461_356_1),
        (0.214_041_14, 0.5),
        (0.5, 0.735_356_98),
    ] {
        assert!(
            (tone::encode_srgb(v) - code).abs() < ROUNDING,
            "{v}: {} is not {code}",
            tone::encode_srgb(v)
        );
    }
    assert_eq!(
        tone::to_byte(0.5),
        188,
        "half the light is not half the code"
    );
    // The gamma of 2.2 that it is often taken for is up to 0.034 off in the shadows.
    let gamma = 0.001_f32.powf(1.0 / 2.2);
    assert!(
        (tone::encode_srgb(0.001) - gamma).abs() > 0.03,
        "sRGB is not a gamma of 2.2"
    );
}

#[test]
fn every_byte_comes_back_and_they_rise() {
    let mut last = -1.0;
    for byte in 0..=255_u8 {
        let v = tone::decode_srgb(f32::from(byte) / 255.0);
        assert_eq!(
            tone::to_byte(v),
            byte,
            "byte {byte} is {v}, which comes back"
        );
        assert!(v > last, "byte {byte} is brighter than the one before");
        last = v;
    }
    let codes: Vec<u8> = (0..=100_000)
        .map(|i| tone::to_byte(i as f32 / 1e5))
        .collect();
    assert!(codes.is_sorted(), "more light never has a smaller byte");
    assert_eq!(
        codes.first().zip(codes.last()),
        Some((&0, &255)),
        "from 0 to 255"
    );
}

proptest! {
    #[test]
    fn decoding_undoes_encoding(v in 0.0_f32..=1.0) {
        let back = tone::decode_srgb(tone::encode_srgb(v));
        // The curve's steepest part multiplies the code's rounding, 6e-8, by 1.055·2.4/… < 2.3; two roundings of powf more.
        prop_assert!((back - v).abs() < 1e-6, "{v} came back as {back}");
    }
}

// ---- files ----

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

/// A smooth picture over ten orders of magnitude, without anything that a format would have to clamp.
fn lights() -> Image {
    Image::from_fn(40, 23, |x, y| {
        let level = 10.0_f32.powf(x as f32 / 4.0 - 5.0);
        Rgb::new(level, level * (y as f32 / 22.0), level * 0.3)
    })
}

fn no_partial_file_in(folder: &Path) {
    let names: Vec<_> = fs::read_dir(folder)
        .expect("the folder can be read")
        .map(|entry| {
            entry
                .expect("an entry")
                .file_name()
                .to_string_lossy()
                .into_owned()
        })
        .collect();
    assert!(
        !names.iter().any(|name| name.contains("partial")),
        "nothing is left behind: {names:?}"
    );
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

#[test]
fn a_name_that_is_no_pictures_is_an_error_that_says_which_are() {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["picture.jpg", "picture", ".exr", "picture.exr.bak", ""] {
        let path = folder.path().join(name);
        for error in [
            file::save(&path, &lights()).expect_err("not a picture's name"),
            file::load(&path).expect_err("not a picture's name"),
        ] {
            assert!(matches!(error, FileError::Format { .. }), "{name}: {error}");
            assert_eq!(
                error.to_string(),
                format!(
                    "{}: a picture's name must end in .exr, .hdr or .png",
                    path.display()
                )
            );
        }
        assert!(name.is_empty() || !path.exists(), "{name} was not written");
    }
}

#[test]
fn a_missing_file_is_an_error_that_names_it() {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["a.exr", "a.hdr", "a.png"] {
        let path = folder.path().join(name);
        let error = file::load(&path)
            .expect_err("there is no such file")
            .to_string();
        assert!(
            error.starts_with(&format!("{}: cannot read this file: ", path.display())),
            "{error}"
        );
    }
}

#[test]
fn a_picture_without_pixels_is_an_error() {
    let folder = tempfile::tempdir().expect("a folder");
    for (width, height) in [(0, 0), (0, 5), (5, 0)] {
        for name in ["a.exr", "a.hdr", "a.png"] {
            let path = folder.path().join(name);
            let empty = Image::from_fn(width, height, |_, _| Rgb::WHITE);
            let error = file::save(&path, &empty)
                .expect_err("there is nothing to write")
                .to_string();
            assert!(
                error.contains(&format!("{width} × {height} pixels")),
                "{error}"
            );
            assert!(!path.exists(), "nothing was written");
        }
    }
}

#[test]
fn a_folder_that_cannot_be_made_is_an_error_that_names_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let in_the_way = folder.path().join("file");
    fs::write(&in_the_way, "not a folder").expect("it can be written");
    for name in ["a.exr", "a.hdr", "a.png"] {
        let error = file::save(&in_the_way.join(name), &lights())
            .expect_err("a file is in the way")
            .to_string();
        assert!(
            error.contains("cannot write this file: the folder "),
            "{error}"
        );
        assert!(error.contains("file cannot be made: "), "{error}");
    }
    assert_eq!(
        fs::read_to_string(&in_the_way).expect("it is there"),
        "not a folder",
        "nothing was harmed"
    );
    no_partial_file_in(folder.path());
}

#[test]
fn a_write_that_fails_leaves_nothing_behind() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("picture.exr");
    fs::create_dir(&path).expect("it can be made");
    fs::write(path.join("inside"), "").expect("it can be written");
    let error = file::save(&path, &lights()).expect_err("a folder with a file in it has this name");
    assert!(
        matches!(error, FileError::Io { doing: "write", .. }),
        "{error}"
    );
    assert!(
        path.join("inside").exists(),
        "what was there is still there"
    );
    no_partial_file_in(folder.path());
}

#[test]
fn a_write_replaces_the_old_picture() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("picture.exr");
    for v in [1.0, 2.0] {
        let picture = Image::from_fn(3, 2, |_, _| Rgb::gray(v));
        file::save(&path, &picture).expect("it can be written");
        assert!(
            file::load(&path)
                .expect("it can be read")
                .same_bits(&picture),
            "the last one counts"
        );
    }
    no_partial_file_in(folder.path());
}

/// A picture's file in this format.
fn bytes_of(extension: &str) -> Vec<u8> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("picture").with_extension(extension);
    file::save(&path, &lights()).expect("it can be written");
    fs::read(&path).expect("it can be read")
}

/// What reading these bytes as this format yields.
fn read_as(extension: &str, bytes: &[u8]) -> Result<Image, FileError> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("picture").with_extension(extension);
    fs::write(&path, bytes).expect("it can be written");
    file::load(&path)
}

#[test]
fn a_file_cut_off_anywhere_is_an_error() {
    for extension in ["exr", "hdr", "png"] {
        let whole = bytes_of(extension);
        let expected = read_as(extension, &whole).expect("the whole file can be read");
        // All short ones, where the header is, and some of the longer ones.
        let lengths = (0..whole.len().min(500))
            .chain((500..whole.len()).step_by(37))
            .chain([whole.len() - 1]);
        for length in lengths {
            match read_as(extension, &whole[..length]) {
                Err(FileError::Content { .. }) => {}
                Err(other) => panic!("{length} bytes of the .{extension}: {other}"),
                Ok(picture) => assert!(
                    extension == "png" && picture.same_bits(&expected),
                    "{length} bytes of {} of the .{extension} were taken for a picture",
                    whole.len()
                ),
            }
        }
    }
}

#[test]
fn garbage_is_an_error_that_says_what_was_promised() {
    for (extension, format) in [("exr", "OpenEXR"), ("hdr", "Radiance HDR"), ("png", "PNG")] {
        for garbage in [
            &b""[..],
            b"hello",
            &[0; 1000],
            &[255; 1000],
            "<html>not a picture</html>".as_bytes(),
        ] {
            let error = read_as(extension, garbage)
                .expect_err("it is garbage")
                .to_string();
            assert!(
                error.contains(&format!(
                    "this is not a {format} picture that can be read: "
                )),
                "{error}"
            );
        }
    }
}

#[test]
fn a_file_of_another_format_is_an_error() {
    for (extension, other) in [("exr", "png"), ("hdr", "exr"), ("png", "hdr")] {
        let error = read_as(extension, &bytes_of(other)).expect_err("the name lies");
        assert!(
            matches!(error, FileError::Content { .. }),
            "a .{other} called .{extension}: {error}"
        );
    }
}

#[test]
fn a_header_that_claims_a_huge_picture_takes_no_memory() {
    let whole = bytes_of("exr");
    // The data window, "dataWindow\0box2i\0" and the size 16, holds x0 y0 x1 y1.
    let at = whole
        .windows(17)
        .position(|w| w == b"dataWindow\0box2i\0")
        .expect("an EXR has one")
        + 17
        + 4;
    let mut lying = whole.clone();
    lying[at + 8..at + 12].copy_from_slice(&1_000_000_000_i32.to_le_bytes());
    lying[at + 12..at + 16].copy_from_slice(&1_000_000_000_i32.to_le_bytes());
    let error = read_as("exr", &lying).expect_err("there are not so many pixels");
    assert!(matches!(error, FileError::Content { .. }), "{error}");

    let hdr = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1000000 +X 1000000\n\x02\x02\x02\x02";
    assert!(read_as("hdr", hdr).is_err(), "nor here");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]
    #[test]
    fn damaged_files_never_panic(format in 0..3_usize, places in proptest::collection::vec((any::<usize>(), any::<u8>()), 1..6)) {
        let extension = ["exr", "hdr", "png"][format];
        let mut bytes = bytes_of(extension);
        let length = bytes.len();
        for (place, value) in places {
            // Mostly in the header, where damage has the widest consequences.
            let place = if place % 4 == 0 { place / 4 % length } else { place / 4 % length.min(400) };
            bytes[place] = value;
        }
        // Either is right: a flipped pixel is still a picture.
        if let Ok(picture) = read_as(extension, &bytes) {
            prop_assert_eq!(picture.pixels().len(), picture.width() * picture.height());
        }
    }
}

// ---- comparison ----

/// A real picture: a shaded sphere before a sky that changes slowly.
fn rendered() -> Image {
    let film = Film {
        width: 96,
        height: 54,
        samples: 4,
        seed: 1,
        threads: 1,
        progress: &|_| (),
    };
    let camera = Pinhole::look_at(
        vec3(0.5, 0.8, 4.0),
        Vec3::ZERO,
        Vec3::Y,
        0.035,
        film.aspect(),
    )
    .expect("it can");
    let sphere = Sphere::new(Vec3::ZERO, 1.0);
    film.render(|place, _| {
        let ray = camera.ray(place, Vec2::ZERO);
        sphere.hit(&ray, Interval::AHEAD).map_or_else(
            || {
                Rgb::new(0.25, 0.32, 0.45)
                    .lerp(Rgb::new(0.6, 0.62, 0.65), 0.5 + 0.5 * ray.direction.y)
            },
            |hit| {
                let n = sphere.surface(&ray, &hit).normal;
                Rgb::new(0.9, 0.5, 0.2) * (0.08 + n.dot(vec3(0.6, 0.7, 0.4)).max(0.0))
            },
        )
    })
}

/// The picture with another one's pixel at each place.
fn moved(picture: &Image, from: impl Fn(usize, usize) -> (usize, usize)) -> Image {
    Image::from_fn(picture.width(), picture.height(), |x, y| {
        let (x, y) = from(x, y);
        picture.at(x, y)
    })
}

/// The picture with one pixel replaced.
fn with_pixel(picture: &Image, x: usize, y: usize, colour: Rgb) -> Image {
    let mut changed = picture.clone();
    changed.set(x, y, colour);
    changed
}

/// The errors that a comparison must see, planted.
fn planted(base: &Image) -> Vec<(&'static str, Image)> {
    let (w, h) = (base.width(), base.height());
    let only = |place: fn(usize, usize) -> bool, change: fn(Rgb) -> Rgb| {
        Image::from_fn(w, h, |x, y| {
            if place(x, y) {
                change(base.at(x, y))
            } else {
                base.at(x, y)
            }
        })
    };
    vec![
        ("shifted left", moved(base, |x, y| ((x + 1).min(w - 1), y))),
        (
            "shifted right",
            moved(base, |x, y| (x.saturating_sub(1), y)),
        ),
        ("shifted up", moved(base, |x, y| (x, (y + 1).min(h - 1)))),
        ("shifted down", moved(base, |x, y| (x, y.saturating_sub(1)))),
        ("left and right swapped", moved(base, |x, y| (w - 1 - x, y))),
        ("upside down", moved(base, |x, y| (x, h - 1 - y))),
        ("a dead column", only(|x, _| x == 30, |_| Rgb::BLACK)),
        ("a dead row", only(|_, y| y == 20, |_| Rgb::BLACK)),
        (
            "a column drawn twice",
            moved(base, |x, y| (if x == 48 { 47 } else { x }, y)),
        ),
        ("5 % brighter", base.map(|p| p * 1.05)),
        ("5 % darker", base.map(|p| p * 0.95)),
        ("1 % brighter everywhere", base.map(|p| p * 1.01)),
        ("1 % darker everywhere", base.map(|p| p * 0.99)),
        (
            "1 % brighter in one quarter",
            only(|x, y| x < 48 && y < 27, |p| p * 1.01),
        ),
        ("1 % more red", base.map(|p| Rgb::new(p.r * 1.01, p.g, p.b))),
        ("gamma 1.02", base.map(|p| p.map(|v| v.powf(1.02)))),
        ("encoded as sRGB", base.map(|p| p.map(tone::encode_srgb))),
        (
            "rounded to bytes",
            base.map(|p| p.map(|v| tone::decode_srgb(f32::from(tone::to_byte(v)) / 255.0))),
        ),
        (
            "red and blue swapped",
            base.map(|p| Rgb::new(p.b, p.g, p.r)),
        ),
        ("green lost", base.map(|p| Rgb::new(p.r, 0.0, p.b))),
        (
            "a dead tile",
            only(
                |x, y| (32..36).contains(&x) && (16..20).contains(&y),
                |_| Rgb::BLACK,
            ),
        ),
        (
            "salt and pepper",
            only(|x, y| x % 12 == 3 && y % 12 == 5, |_| Rgb::WHITE),
        ),
        (
            "a NaN",
            with_pixel(base, 5, 40, Rgb::new(0.1, f32::NAN, 0.1)),
        ),
        (
            "an infinite pixel",
            with_pixel(base, 95, 53, Rgb::gray(f32::INFINITY)),
        ),
        ("one firefly", with_pixel(base, 50, 20, Rgb::gray(100.0))),
        (
            "a column too few",
            Image::from_fn(w - 1, h, |x, y| base.at(x, y)),
        ),
        (
            "a row too many",
            Image::from_fn(w, h + 1, |x, y| base.at(x, y.min(h - 1))),
        ),
        (
            "width and height swapped",
            Image::from_fn(h, w, |x, y| base.at(y, x)),
        ),
        ("all black", base.map(|_| Rgb::BLACK)),
    ]
}

#[test]
fn every_planted_error_is_caught() {
    let base = rendered();
    let passed: Vec<_> = planted(&base)
        .into_iter()
        .filter(|(_, wrong)| compare(&base, wrong, &Tolerance::RENDERED_AGAIN).is_ok())
        .map(|(name, _)| name)
        .collect();
    assert!(passed.is_empty(), "these passed: {passed:?}");
}

#[test]
fn what_another_processor_may_do_is_accepted() {
    let base = rendered();
    let mut rng = pcg::stream(3, 0);
    let rounded = Image::from_fn(96, 54, |x, y| {
        base.at(x, y)
            .map(|v| v * (1.0 + 1e-6 * (2.0 * rng_in_turn(x, y) - 1.0)))
    });
    assert_ne!(rounded, base, "it is not the same picture");
    // One of four samples of a pixel on the silhouette, on the other side.
    let (sphere, sky) = (base.at(48, 27), base.at(3, 27));
    let on_silhouette = |x: usize, y: usize| base.at(x, y) + (sphere + sky * -1.0) * 0.25;
    let edge = (0..48)
        .find(|&x| base.at(x, 27).r > base.at(0, 27).r + 0.05)
        .expect("the sphere has an edge");
    let one = with_pixel(&rounded, edge, 27, on_silhouette(edge, 27));
    let other: usize = rng.random_range(60..70);
    let two = with_pixel(&one, other, 8, on_silhouette(other, 8));
    for (name, picture) in [
        ("itself", &base),
        ("rounded", &rounded),
        ("one pixel", &one),
        ("two pixels", &two),
    ] {
        assert_eq!(
            compare(&base, picture, &Tolerance::RENDERED_AGAIN),
            Ok(()),
            "{name}"
        );
    }
}

/// A number in [0, 1) for each pixel.
fn rng_in_turn(x: usize, y: usize) -> f32 {
    noise::hash(x as i32, y as i32).min(0.999)
}

#[test]
fn each_kind_of_difference_says_what_and_where() {
    let base = Image::from_fn(40, 30, |_, _| Rgb::gray(0.5));
    let judge =
        |wrong: &Image| compare(&base, wrong, &Tolerance::RENDERED_AGAIN).expect_err("it differs");
    let column = Image::from_fn(40, 30, |x, _| Rgb::gray(if x == 7 { 0.51 } else { 0.5 }));
    let scattered = Image::from_fn(40, 30, |x, y| {
        Rgb::gray(if x % 10 == 3 && y % 10 == 2 {
            0.51
        } else {
            0.5
        })
    });
    for (wrong, message) in [
        (
            Image::from_fn(40, 31, |_, _| Rgb::gray(0.5)),
            "the picture is 40 × 31 pixels, 40 × 30 were expected",
        ),
        (
            with_pixel(&base, 39, 29, Rgb::gray(f32::NAN)),
            "pixel (39, 29) is not a finite number",
        ),
        (
            base.map(|p| p * 1.1),
            "the mean is 0.55, 0.5 was expected: +10.00 %",
        ),
        (column, "30 neighbouring pixels differ, the first at (7, 0)"),
        (
            scattered,
            "12 pixels differ, at most 4 may; the first is (3, 2)",
        ),
    ] {
        assert_eq!(judge(&wrong).to_string(), message);
    }
    assert!(matches!(
        judge(&base.map(|_| Rgb::gray(f32::INFINITY))),
        Difference::NotFinite { x: 0, y: 0 }
    ));
}

#[test]
fn an_expected_picture_that_is_not_finite_agrees_with_nothing() {
    let nan = Image::from_fn(4, 4, |_, _| Rgb::gray(f32::NAN));
    assert!(
        compare(&nan, &nan, &Tolerance::RENDERED_AGAIN).is_err(),
        "not even with itself"
    );
    let none = Image::from_fn(0, 0, |_, _| Rgb::BLACK);
    assert_eq!(
        compare(&none, &none, &Tolerance::RENDERED_AGAIN),
        Ok(()),
        "no pixels agree, and do not panic"
    );
}

// ---- the scene ----

fn look_out(width: usize, jiggle: f32) -> Image {
    let film = Film {
        width,
        height: width * 9 / 16,
        samples: 4,
        seed: 1,
        threads: 2,
        progress: &|_| (),
    };
    let camera = Pinhole::look_at(window::EYE, window::MIDDLE, Vec3::Y, 0.024, film.aspect())
        .expect("it can");
    film.render(|place, rng| {
        let ray = camera.ray(place, Vec2::ZERO);
        let off = jiggle * (vec3(rng.random(), rng.random(), rng.random()) - 0.5);
        window::radiance(&Ray::new(
            ray.origin,
            Dir3::new_or(*ray.direction + off, ray.direction),
        ))
    })
}

#[test]
fn the_scene_spans_more_than_five_orders_of_magnitude() {
    for width in [64, 96, 320] {
        let picture = look_out(width, 0.0);
        let luminances = || picture.pixels().iter().map(|p| p.luminance());
        let (least, most) = (
            luminances().fold(f32::INFINITY, f32::min),
            luminances().fold(0.0, f32::max),
        );
        assert!(least > 0.0, "no pixel is black: the ratio has a meaning");
        assert!(
            most / least > 1e5,
            "from {least} to {most} at {width} pixels"
        );
        assert!(
            picture
                .pixels()
                .iter()
                .flat_map(|p| p.channels())
                .all(|v| v.is_finite() && v >= 0.0),
            "all is light"
        );
    }
}

#[test]
fn the_scene_does_not_hang_on_last_bits() {
    // Directions moved by an ulp, as another processor's `sin` or `exp` might: the golden comparison must not notice.
    let compared = compare(
        &look_out(96, 0.0),
        &look_out(96, 1.2e-7),
        &Tolerance::RENDERED_AGAIN,
    );
    assert_eq!(compared, Ok(()), "the picture is stable");
}

#[test]
fn rays_in_every_direction_find_light() {
    for i in 0..2000 {
        let mut rng = pcg::stream(5, i);
        let d = Vec3::from_array([rng.random(), rng.random(), rng.random()]) * 2.0 - 1.0;
        let direction = Dir3::new_or(d, Dir3::Y);
        let (inside, outside) = (
            window::radiance(&Ray::new(window::EYE, direction)),
            evening::radiance(direction),
        );
        for v in inside.channels().into_iter().chain(outside.channels()) {
            assert!(v.is_finite() && v > 0.0, "{direction:?} sees {v}");
        }
    }
    for axis in [Dir3::X, Dir3::Y, Dir3::Z, -Dir3::X, -Dir3::Y, -Dir3::Z] {
        let seen = window::radiance(&Ray::new(window::EYE, axis)).luminance();
        assert!(seen.is_finite() && seen > 0.0, "{axis:?} sees {seen}");
    }
}

#[test]
fn the_sun_sends_what_its_disc_adds_up_to() {
    // The integral of the radiance over the disc, minus the sky's, in rings and sectors around the sun's middle.
    let sun = evening::toward_sun();
    let right = Dir3::new_or(sun.cross(Vec3::Y), Dir3::X);
    let up = right.cross(*sun);
    let (rings, sectors) = (400, 24);
    let mut sum = [0.0_f64; 3];
    for ring in 0..rings {
        let angle = evening::SUN_RADIUS * 1.0001 * (ring as f32 + 0.5) / rings as f32;
        for sector in 0..sectors {
            let around = std::f32::consts::TAU * sector as f32 / sectors as f32;
            let off = around.cos() * *right + around.sin() * up;
            let d = Dir3::new_or(angle.cos() * *sun + angle.sin() * off, sun);
            let solid_angle = f64::from(angle.sin() * evening::SUN_RADIUS * 1.0001 / rings as f32)
                * std::f64::consts::TAU
                / f64::from(sectors);
            for (sum, v) in sum.iter_mut().zip(evening::radiance(d).channels()) {
                *sum += f64::from(v) * solid_angle;
            }
        }
    }
    for (sum, stated) in sum.into_iter().zip(evening::sunlight().channels()) {
        // The sky around the sun adds about 2e-3.
        let ratio = sum / f64::from(stated);
        assert!(
            (ratio - 1.0).abs() < 5e-3,
            "the disc sends {ratio} of what is stated"
        );
    }
}

#[test]
fn noise_stays_in_its_range_and_has_no_steps() {
    let mut largest_step: f32 = 0.0;
    for i in 0..4000 {
        let p = Vec2::new(i as f32 * 0.013 - 20.0, 7.3 - i as f32 * 0.007);
        for v in [noise::noise(p), noise::layers(p, 5)] {
            assert!((0.0..=1.0).contains(&v), "noise at {p} is {v}");
        }
        largest_step = largest_step.max((noise::noise(p + 0.001) - noise::noise(p)).abs());
    }
    // The blend's slope is 1.5 at most, in two directions.
    assert!(
        largest_step < 0.004,
        "a step of {largest_step} over a thousandth"
    );
}
