//! Points in time: when a hand-in was due, and when it came.

use std::fmt::{self, Display, Formatter};
use std::str::FromStr;
use std::time::{SystemTime, UNIX_EPOCH};
use toml::value::{Datetime, Offset};

/// An instant, as a clock of some offset from UTC shows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Timestamp {
    /// Seconds since the beginning of 1970 in UTC.
    pub seconds: i64,
    /// Minutes by which the clock is ahead of UTC.
    east: i16,
}

const DAY: i64 = 86400;

impl Timestamp {
    /// The instant of a date and a time with an offset from UTC; `None` where one of the three is missing.
    pub fn of(when: &Datetime) -> Option<Self> {
        let (date, time, offset) = (when.date?, when.time?, when.offset?);
        let east = match offset {
            Offset::Z => 0,
            Offset::Custom { minutes } => minutes,
        };
        let days = days(
            i64::from(date.year),
            i64::from(date.month),
            i64::from(date.day),
        );
        let [hour, minute, second] = [time.hour, time.minute, time.second].map(i64::from);
        let shown = days * DAY + hour * 3600 + minute * 60 + second;
        Some(Self {
            seconds: shown - 60 * i64::from(east),
            east,
        })
    }

    /// The instant `seconds` after the beginning of 1970, as a clock in UTC shows it.
    pub fn utc(seconds: i64) -> Self {
        Self { seconds, east: 0 }
    }

    /// Now.
    pub fn now() -> Self {
        let since = SystemTime::now().duration_since(UNIX_EPOCH);
        Self::utc(since.map_or(0, |since| since.as_secs() as i64))
    }
}

/// As RFC 3339 writes it: `2026-11-30T23:59:00+01:00`.
impl FromStr for Timestamp {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let when = Datetime::from_str(text.trim()).ok();
        when.and_then(|when| Self::of(&when)).ok_or(
            "this must be a date and a time with an offset from UTC, such as 2026-11-30T23:59:00+01:00",
        )
    }
}

impl Display for Timestamp {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let shown = self.seconds + 60 * i64::from(self.east);
        let (year, month, day) = date(shown.div_euclid(DAY));
        let rest = shown.rem_euclid(DAY);
        let (hour, minute, second) = (rest / 3600, rest / 60 % 60, rest % 60);
        write!(
            f,
            "{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}"
        )?;
        let (sign, east) = (if self.east < 0 { '-' } else { '+' }, self.east.abs());
        match east {
            0 => f.write_str("Z"),
            _ => write!(f, "{sign}{:02}:{:02}", east / 60, east % 60),
        }
    }
}

/// Days from the beginning of 1970 to a date of the Gregorian calendar. The year is taken to begin in March, so that the day that
/// comes and goes is its last (Hinnant, "chrono-Compatible Low-Level Date Algorithms").
fn days(year: i64, month: i64, day: i64) -> i64 {
    let year = if month <= 2 { year - 1 } else { year };
    let era = year.div_euclid(400);
    let year_of_era = year.rem_euclid(400);
    let day_of_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
    era * 146_097 + year_of_era * 365 + year_of_era / 4 - year_of_era / 100 + day_of_year - 719_468
}

/// The date of a day since the beginning of 1970: year, month, day.
fn date(days: i64) -> (i64, i64, i64) {
    let shifted = days + 719_468;
    let era = shifted.div_euclid(146_097);
    let day_of_era = shifted.rem_euclid(146_097);
    let year_of_era =
        (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let from_march = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * from_march + 2) / 5 + 1;
    let month = (from_march + 2) % 12 + 1;
    let year = era * 400 + year_of_era + i64::from(month <= 2);
    (year, month, day)
}
