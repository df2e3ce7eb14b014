//! sRGB: exact at its ends, and back.

use super::ROUNDING;
use proptest::prelude::{prop_assert, proptest};
use raybook::image::tone;

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
        (0.5, 0.735_357),
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
