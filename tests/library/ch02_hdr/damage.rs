//! Picture files that are cut off, damaged, or something else.

use super::lights;
use proptest::prelude::{ProptestConfig, any, prop_assert_eq, proptest};
use raybook::image::Image;
use raybook::image::file::{self, FileError};
use std::fs;

/// A picture's file in this format.
pub(super) fn bytes_of(extension: &str) -> Vec<u8> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("picture").with_extension(extension);
    file::save(&path, &lights()).expect("it can be written");
    fs::read(&path).expect("it can be read")
}

/// What reading these bytes as this format yields.
pub(super) fn read_as(extension: &str, bytes: &[u8]) -> Result<Image, FileError> {
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
                error.contains(&format!("cannot be read as {format}: ")),
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
    let mut lying = bytes_of("exr");
    let mut replace = |attribute: &[u8], offset: usize, value: i32| {
        let found = lying.windows(attribute.len()).position(|w| w == attribute);
        // After the name and the type, each with its 0, come four bytes of length, then the value.
        let at = found.expect("the header has it") + attribute.len() + 4 + offset;
        lying[at..at + 4].copy_from_slice(&value.to_le_bytes());
    };
    replace(b"dataWindow\0box2i\0", 8, 999_999_999); // the last column
    replace(b"chunkCount\0int\0", 0, 15_625_000); // as many tiles of 64 × 64 as that takes
    let error = read_as("exr", &lying).expect_err("there are not so many pixels");
    // 276 GB, were they believed.
    assert!(
        error
            .to_string()
            .contains("cannot hold 1000000000 × 23 pixels"),
        "{error}"
    );

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
