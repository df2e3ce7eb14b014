//! Records and choices as rows: each field stands once, with its name, its type and its meaning.

use crate::kind::{Kind, Parts};
use crate::row::{Numbers, Row};
use glam::{Vec2, Vec3};
use raybook::image::rgb::Rgb;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};

/// Defines a struct that is a row: its fields in order, each with a comment that says what it means, and in which unit.
///
/// Where a field has a range, its words end the comment's sentence:
///
/// ```text
/// /// The radius, in metres,
/// pub radius: f32 [above 0],
/// ```
macro_rules! row {
    ($(#[doc = $doc:literal])+ pub struct $name:ident {
        $($(#[doc = $meaning:literal])+ pub $field:ident: $kind:ty $([$($range:tt)+])?),+ $(,)?
    }) => {
        $(#[doc = $doc])+
        #[derive(Clone, Debug, PartialEq)]
        pub struct $name {
            $($(#[doc = $meaning])+ $(#[doc = concat!(" ", stringify!($($range)+), ".")])? pub $field: $kind),+
        }

        crate::record::row_of!($name { $($(#[doc = $meaning])+ $field: $kind $([$($range)+])?),+ });
    };
}

/// Makes the field of a declaration.
macro_rules! field {
    ($(#[doc = $meaning:literal])+ $field:ident: $kind:ty $([$($range:tt)+])?) => {
        crate::kind::Field {
            name: stringify!($field),
            kind: <$kind as crate::row::Row>::KIND,
            meaning: concat!($($meaning),+ $(, " ", stringify!($($range)+), ".")?).trim_ascii(),
            range: crate::record::range!($($($range)+)?),
        }
    };
}

/// The range of a field: `above 0`, `from 0 to 1`, `1 or more`, or none at all.
macro_rules! range {
    () => {
        None
    };
    (above $least:literal) => {
        Some(crate::kind::Range {
            words: stringify!(above $least),
            ends: [std::ops::Bound::Excluded($least), std::ops::Bound::Unbounded],
        })
    };
    (from $least:literal to $most:literal) => {
        Some(crate::kind::Range {
            words: stringify!(from $least to $most),
            ends: [std::ops::Bound::Included($least), std::ops::Bound::Included($most)],
        })
    };
    ($least:literal or more) => {
        Some(crate::kind::Range {
            words: stringify!($least or more),
            ends: [std::ops::Bound::Included($least), std::ops::Bound::Unbounded],
        })
    };
}

/// Makes a row of a struct that there is: its fields in order, each with a comment.
macro_rules! row_of {
    ($name:ident { $($(#[doc = $meaning:literal])+ $field:ident: $kind:ty $([$($range:tt)+])?),+ $(,)? }) => {
        impl crate::row::Row for $name {
            const KIND: &'static crate::kind::Kind =
                &crate::kind::Kind::Record(&crate::kind::Record {
                    name: stringify!($name),
                    fields: &[$(crate::record::field!(
                        $(#[doc = $meaning])+ $field: $kind $([$($range)+])?
                    )),+],
                });

            fn put(&self, numbers: &mut Vec<f64>) {
                $(crate::row::Row::put(&self.$field, numbers);)+
            }

            fn take(numbers: &mut crate::row::Numbers<'_>) -> Self {
                Self { $($field: crate::row::Row::take(numbers)),+ }
            }
        }
    };
}

/// Makes a row of an enum whose variants hold one row each: a word says which it is.
macro_rules! choice_of {
    ($name:ty { $($word:literal: $variant:ident($kind:ty)),+ $(,)? }) => {
        impl crate::row::Row for $name {
            const KIND: &'static crate::kind::Kind =
                &crate::kind::Kind::Choice(&[$(($word, <$kind as crate::row::Row>::KIND)),+]);

            fn put(&self, numbers: &mut Vec<f64>) {
                let mut i = -1.0;
                $(i += 1.0;
                if let Self::$variant(value) = self {
                    numbers.push(i);
                    crate::row::Row::put(value, numbers);
                })+
            }

            fn take(numbers: &mut crate::row::Numbers<'_>) -> Self {
                let takes = [$(|numbers: &mut crate::row::Numbers<'_>| {
                    Self::$variant(<$kind as crate::row::Row>::take(numbers))
                }),+];
                let i = numbers.number() as usize;
                takes[i.min(takes.len() - 1)](numbers)
            }
        }
    };
}

/// Makes a row of a struct of numbers that belong together.
macro_rules! numbers_of {
    ($name:ident { $($part:ident),+ }) => {
        impl Row for $name {
            const KIND: &'static Kind = &Kind::Numbers(&Parts {
                name: stringify!($name),
                parts: &[$(stringify!($part)),+],
            });

            fn put(&self, numbers: &mut Vec<f64>) {
                $(self.$part.put(numbers);)+
            }

            fn take(numbers: &mut Numbers<'_>) -> Self {
                Self { $($part: f32::take(numbers)),+ }
            }
        }
    };
}

numbers_of!(Vec2 { x, y });
numbers_of!(Vec3 { x, y, z });
numbers_of!(Rgb { r, g, b });
numbers_of!(Interval { min, max });

row_of!(Ray {
    /// Where the ray starts, in metres.
    origin: Vec3,
    /// Where it goes.
    direction: Dir3,
});

pub(crate) use {choice_of, field, range, row, row_of};
