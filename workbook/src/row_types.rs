//! Numbers, vectors, rays, options and lists as rows.

use crate::row::{Row, RowError, Words};
use glam::{Vec2, Vec3};
use raybook::image::rgb::Rgb;
use raybook::math::{dir3::Dir3, interval::Interval, ray::Ray};

/// One word, by `FromStr` and a format.
macro_rules! word_row {
    ($type:ty, $expected:literal, $write:expr) => {
        impl Row for $type {
            fn names(name: &str) -> Vec<String> {
                vec![name.to_owned()]
            }

            fn write(&self) -> String {
                $write(*self)
            }

            fn read(words: &mut Words<'_>, name: &str) -> Result<Self, RowError> {
                words.next(name, $expected, |word| word.parse().ok())
            }
        }
    };
}

word_row!(f32, "a number", |v: f32| format!("{v:?}")
    .trim_end_matches(".0")
    .to_lowercase());
word_row!(u32, "a whole number from 0 up", |v: u32| v.to_string());

/// Several values in a row, and how the whole is made of them.
macro_rules! several_row {
    ($type:ty, $($part:ident: $kind:ty = $get:expr),+ => $make:expr) => {
        impl Row for $type {
            fn names(name: &str) -> Vec<String> {
                [$(<$kind>::names(&format!("{name}.{}", stringify!($part)))),+].concat()
            }

            fn write(&self) -> String {
                [$(<$kind as Row>::write(&($get)(self))),+].join(" ")
            }

            fn read(words: &mut Words<'_>, name: &str) -> Result<Self, RowError> {
                $(let $part = <$kind>::read(words, &format!("{name}.{}", stringify!($part)))?;)+
                Ok($make)
            }
        }
    };
}

several_row!(Vec2, x: f32 = |v: &Vec2| v.x, y: f32 = |v: &Vec2| v.y => Vec2::new(x, y));
several_row!(Vec3, x: f32 = |v: &Vec3| v.x, y: f32 = |v: &Vec3| v.y, z: f32 = |v: &Vec3| v.z => Vec3::new(x, y, z));
several_row!(Rgb, r: f32 = |v: &Rgb| v.r, g: f32 = |v: &Rgb| v.g, b: f32 = |v: &Rgb| v.b => Rgb::new(r, g, b));
several_row!(Interval, min: f32 = |v: &Interval| v.min, max: f32 = |v: &Interval| v.max => Interval::new(min, max));

impl Row for Ray {
    fn names(_name: &str) -> Vec<String> {
        [Vec3::names("origin"), Dir3::names("direction")].concat()
    }

    fn write(&self) -> String {
        [self.origin.write(), self.direction.write()].join("  ")
    }

    fn read(words: &mut Words<'_>, _name: &str) -> Result<Self, RowError> {
        Ok(Self::new(
            Vec3::read(words, "origin")?,
            Dir3::read(words, "direction")?,
        ))
    }

    fn parts(&self, _name: &str) -> Vec<(String, String)> {
        [
            self.origin.parts("origin"),
            self.direction.parts("direction"),
        ]
        .concat()
    }
}

impl Row for Dir3 {
    fn names(name: &str) -> Vec<String> {
        Vec3::names(name)
    }

    fn write(&self) -> String {
        Vec3::write(self)
    }

    /// Any vector that has a direction; it is normalised.
    fn read(words: &mut Words<'_>, name: &str) -> Result<Self, RowError> {
        let word = words.position();
        let v = Vec3::read(words, name)?;
        Dir3::new(v).ok_or_else(|| RowError::Word {
            word,
            name: name.to_owned(),
            expected: "a direction",
            found: v.write(),
        })
    }
}

impl<T: Row> Row for Option<T> {
    fn names(name: &str) -> Vec<String> {
        let names = T::names(name);
        vec![format!("none | {}", names.join(" "))]
    }

    fn write(&self) -> String {
        self.as_ref().map_or_else(|| "none".to_owned(), Row::write)
    }

    fn read(words: &mut Words<'_>, name: &str) -> Result<Self, RowError> {
        if words.take("none") {
            Ok(None)
        } else {
            T::read(words, name).map(Some)
        }
    }

    fn parts(&self, name: &str) -> Vec<(String, String)> {
        self.as_ref().map_or_else(
            || vec![(name.to_owned(), "none".to_owned())],
            |value| value.parts(name),
        )
    }
}

impl<T: Row> Row for Vec<T> {
    fn names(name: &str) -> Vec<String> {
        vec![
            format!("{name}.count"),
            format!("[{}]…", T::names(name).join(" ")),
        ]
    }

    fn write(&self) -> String {
        std::iter::once(self.len().to_string())
            .chain(self.iter().map(Row::write))
            .collect::<Vec<_>>()
            .join("  ")
    }

    fn read(words: &mut Words<'_>, name: &str) -> Result<Self, RowError> {
        let count = u32::read(words, &format!("the number of {name}"))?;
        (0..count)
            .map(|i| T::read(words, &format!("{name}[{i}]")))
            .collect()
    }

    fn parts(&self, name: &str) -> Vec<(String, String)> {
        if T::ALONE {
            let each = self.iter().zip(0..);
            each.flat_map(|(value, i)| value.parts(&format!("{name}[{i}]")))
                .collect()
        } else {
            vec![(name.to_owned(), self.write())]
        }
    }
}
