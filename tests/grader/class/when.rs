//! Points in time, as they are read and written.

use raybook_grader::class::when::Timestamp;

#[test]
fn instants_are_read_and_written() {
    for (text, seconds, shown) in [
        ("1970-01-01T00:00:00Z", 0, "1970-01-01T00:00:00Z"),
        (
            "2000-02-29T12:00:00+01:00",
            951_822_000,
            "2000-02-29T12:00:00+01:00",
        ),
        (
            "2026-11-30T23:59:00-05:30",
            1_796_102_940,
            "2026-11-30T23:59:00-05:30",
        ),
        (
            "2100-03-01 00:00:00Z",
            4_107_542_400,
            "2100-03-01T00:00:00Z",
        ),
    ] {
        let instant: Timestamp = text.parse().expect(text);
        assert_eq!(instant.seconds, seconds, "{text}");
        assert_eq!(instant.to_string(), shown, "{text}");
    }
    for wrong in [
        "2026-11-30",
        "2026-11-30T23:59:00",
        "23:59:00",
        "soon",
        "2026-02-30T00:00:00Z",
    ] {
        assert!(wrong.parse::<Timestamp>().is_err(), "{wrong}");
    }
}

#[test]
fn every_day_is_its_own_date() {
    for day in -200_000..200_000 {
        let instant = Timestamp::utc(86_400 * day);
        assert_eq!(instant.to_string().parse(), Ok(instant), "{instant}");
    }
}
