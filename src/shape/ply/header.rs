//! The header of a PLY file: lines of text that list the elements, and the properties of each.

use crate::shape::ply::PlyError;
use crate::shape::word::{self, Reason, Word, Wrong};

/// Maximum length of a header, in bytes; a longer header is an error.
const LONGEST: usize = 1 << 20;

/// Number of values that are read for a vertex: x, y, z, the normal's x, y, z, u and v.
pub(super) const SLOTS: usize = 8;

/// The names of these numbers; programs use different names for the texture coordinates.
const NAMES: [&[&str]; SLOTS] = [
    &["x"],
    &["y"],
    &["z"],
    &["nx"],
    &["ny"],
    &["nz"],
    &["u", "s", "texture_u"],
    &["v", "t", "texture_v"],
];

/// The order of the bytes of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Order {
    /// The least byte first.
    Little,
    /// The greatest byte first.
    Big,
}

/// The contents of a header.
#[derive(Debug)]
pub(super) struct Header {
    /// The order of the bytes in the body; `None` if the body is text.
    pub order: Option<Order>,
    /// The elements, in the order of their rows in the body.
    pub elements: Vec<Element>,
    /// Number of lines of the header.
    pub lines: usize,
}

/// An element: a kind of rows.
#[derive(Debug)]
pub(super) struct Element {
    /// `vertex`, `face`, or something else.
    pub name: String,
    /// The number of rows.
    pub count: u64,
    /// What each row holds.
    pub properties: Vec<Property>,
}

/// A property: a number in each row, or a list of numbers.
#[derive(Debug)]
pub(super) struct Property {
    /// The type of each number.
    pub kind: Kind,
    /// The type of a list's length; `None` for a single number.
    pub list: Option<Kind>,
    /// The meaning of the numbers.
    pub role: Role,
}

/// The meaning of a property.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// A number of a vertex: one of x, y, z, the normal's x, y, z, u and v.
    Slot(usize),
    /// The vertices of a face.
    Corners,
    /// No meaning: the numbers are ignored.
    Unused,
}

/// The type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A signed whole number of 8 bits.
    Char,
    /// An unsigned whole number of 8 bits.
    Uchar,
    /// A signed whole number of 16 bits.
    Short,
    /// An unsigned whole number of 16 bits.
    Ushort,
    /// A signed whole number of 32 bits.
    Int,
    /// An unsigned whole number of 32 bits.
    Uint,
    /// A floating-point number of 32 bits.
    Float,
    /// A floating-point number of 64 bits.
    Double,
}

impl Kind {
    fn of(word: &Word) -> Result<Self, Wrong> {
        Ok(match word.text {
            "char" | "int8" => Self::Char,
            "uchar" | "uint8" => Self::Uchar,
            "short" | "int16" => Self::Short,
            "ushort" | "uint16" => Self::Ushort,
            "int" | "int32" => Self::Int,
            "uint" | "uint32" => Self::Uint,
            "float" | "float32" => Self::Float,
            "double" | "float64" => Self::Double,
            _ => {
                return Err(
                    word.expected("a type: char, uchar, short, ushort, int, uint, float or double")
                );
            }
        })
    }
}

impl Header {
    /// The header of a file, and the bytes that follow.
    ///
    /// # Errors
    /// The first line that is wrong.
    pub(super) fn parse(bytes: &[u8]) -> Result<(Self, &[u8]), PlyError> {
        let mut header = Self {
            order: None,
            elements: Vec::new(),
            lines: 0,
        };
        let (mut at, mut format) = (0, false);
        for line in bytes[..bytes.len().min(LONGEST)].split_inclusive(|&byte| byte == b'\n') {
            header.lines += 1;
            at += line.len();
            let line = String::from_utf8_lossy(line);
            let words = word::words(&line, header.lines);
            let texts: Vec<_> = words.iter().map(|word| word.text).collect();
            match texts[..] {
                ["ply"] if header.lines == 1 => {}
                _ if header.lines == 1 => break,
                [] | ["comment" | "obj_info", ..] => {}
                ["format", name, "1.0"] if !format => {
                    format = true;
                    header.order = order(name, &words[1])?;
                }
                ["element", name, count] if format => header.elements.push(Element {
                    name: name.to_owned(),
                    count: count
                        .parse()
                        .map_err(|_| words[2].expected("a number of rows"))?,
                    properties: Vec::new(),
                }),
                ["property", ..] if !header.elements.is_empty() => header.property(&words)?,
                ["end_header"] if format => {
                    header.complete(&words[0])?;
                    return Ok((header, &bytes[at..]));
                }
                _ => return Err(words[0].expected(EXPECTED).into()),
            }
        }
        let (line, reason) = if header.lines <= 1 {
            let found = bytes.get(..3).unwrap_or(bytes);
            let found = String::from_utf8_lossy(found).escape_debug().to_string();
            let expected = "`ply` alone in the first line";
            (1, Reason::Expected { expected, found })
        } else {
            (
                header.lines,
                Reason::Missing("line `end_header` in the first MiB of the file"),
            )
        };
        let column = 1;
        Err(Wrong {
            line,
            column,
            reason,
        }
        .into())
    }

    /// Adds the property of a line to the last element.
    fn property(&mut self, words: &[Word]) -> Result<(), PlyError> {
        let Some(element) = self.elements.last_mut() else {
            return Err(words[0].expected(EXPECTED).into());
        };
        let property = match words {
            [_, list, count, kind, name] if list.text == "list" => Property {
                kind: Kind::of(kind)?,
                list: Some(Kind::of(count)?),
                role: match (element.name.as_str(), name.text) {
                    ("face", "vertex_indices" | "vertex_index") => Role::Corners,
                    _ => Role::Unused,
                },
            },
            [_, kind, name] => Property {
                kind: Kind::of(kind)?,
                list: None,
                role: NAMES
                    .iter()
                    .position(|names| element.name == "vertex" && names.contains(&name.text))
                    .map_or(Role::Unused, Role::Slot),
            },
            _ => return Err(words[0].expected(EXPECTED).into()),
        };
        element.properties.push(property);
        Ok(())
    }

    /// Checks that vertices have x, y and z, and that faces have corners; `end` is the header's last word.
    fn complete(&self, end: &Word) -> Result<(), Wrong> {
        for element in &self.elements {
            let has = |role| element.properties.iter().any(|p| p.role == role);
            if element.name == "vertex" && !(0..3).all(|axis| has(Role::Slot(axis))) {
                return Err(end.expected("above a `property` x, y and z of `element vertex`"));
            }
            if element.name == "face" && !has(Role::Corners) {
                return Err(
                    end.expected("above a `property list … vertex_indices` of `element face`")
                );
            }
        }
        Ok(())
    }

    /// The number of rows of all elements of this name.
    pub(super) fn count(&self, name: &str) -> u64 {
        let named = self.elements.iter().filter(|element| element.name == name);
        named.fold(0, |sum, element| sum.saturating_add(element.count))
    }
}

/// What a line may be; the format comes first, and an element before its properties.
const EXPECTED: &str = "`format … 1.0`, then `element name count`, `property type name`, `property list type type name`, `comment`, or `end_header`";

fn order(name: &str, word: &Word) -> Result<Option<Order>, Wrong> {
    match name {
        "ascii" => Ok(None),
        "binary_little_endian" => Ok(Some(Order::Little)),
        "binary_big_endian" => Ok(Some(Order::Big)),
        _ => Err(word.expected("ascii, binary_little_endian or binary_big_endian")),
    }
}
