//! What follows a PLY file's header: rows of numbers, in text or in binary.

use crate::shape::ply::PlyError;
use crate::shape::ply::header::{Kind, Order, Property};
use crate::shape::word::{self, Reason, Word, Wrong};
use std::iter::Zip;
use std::ops::RangeFrom;
use std::str::Lines;

/// Rows of numbers, read one after another.
pub(super) trait Body {
    /// Goes to the next row; an error if there is none.
    fn begin_row(&mut self) -> Result<(), PlyError>;
    /// The next number of the row; an error if there is none.
    fn number(&mut self, kind: Kind) -> Result<f64, PlyError>;
    /// An error if the row is not at its end.
    fn end_row(&self) -> Result<(), PlyError>;
    /// An error if the file is not at its end.
    fn end(&mut self) -> Result<(), PlyError>;
    /// The error that the number that was read last is wrong.
    fn wrong(&self, reason: Reason) -> PlyError;
}

/// Calls `take` with the number of a property, or with each number of its list.
///
/// # Errors
/// If there are too few numbers, the length of a list is not a whole number from 0, or `take` returns an error.
pub(super) fn each_number<B: Body>(
    property: &Property,
    body: &mut B,
    mut take: impl FnMut(&B, f64) -> Result<(), PlyError>,
) -> Result<(), PlyError> {
    let count = match property.list {
        None => 1.0,
        Some(kind) => body.number(kind)?,
    };
    if count != (count as u32).into() {
        return Err(body.wrong(Reason::Expected {
            expected: "the length of a list, from 0 to 4294967295",
            found: count.to_string(),
        }));
    }
    for _ in 0..count as u32 {
        let number = body.number(property.kind)?;
        take(body, number)?;
    }
    Ok(())
}

/// The rows of a text: each row is a line.
pub(super) struct Text<'a> {
    lines: Zip<RangeFrom<usize>, Lines<'a>>,
    /// The line number of the row.
    line: usize,
    row: Vec<Word<'a>>,
    /// The number of words of the row that were read.
    used: usize,
}

impl<'a> Text<'a> {
    /// The rows of a text whose first line has the number `first_line`.
    pub(super) fn new(text: &'a str, first_line: usize) -> Self {
        Self {
            lines: (first_line..).zip(text.lines()),
            line: first_line,
            row: Vec::new(),
            used: 0,
        }
    }

    /// The words of the next line that is not empty.
    fn next_line(&mut self) -> Option<Vec<Word<'a>>> {
        let mut rows = self.lines.by_ref().map(|(n, line)| word::words(line, n));
        rows.find(|row| !row.is_empty())
    }
}

impl Body for Text<'_> {
    fn begin_row(&mut self) -> Result<(), PlyError> {
        self.used = 0;
        let Some(row) = self.next_line() else {
            return Err(PlyError::Text(Wrong {
                line: self.line,
                column: 1,
                reason: Reason::End("a row that the header promises"),
            }));
        };
        self.line = row[0].line;
        self.row = row;
        Ok(())
    }

    fn number(&mut self, _: Kind) -> Result<f64, PlyError> {
        let Some(word) = self.row.get(self.used) else {
            return Err(self.wrong(Reason::Count {
                what: "this line",
                needs: "a number for each `property` of its element in the header",
                found: self.row.len(),
            }));
        };
        self.used += 1;
        let number = word.text.parse();
        Ok(number.map_err(|_| word.wrong(Reason::NotANumber(word.text.to_owned())))?)
    }

    fn end_row(&self) -> Result<(), PlyError> {
        match self.row.get(self.used) {
            Some(word) => Err(word.expected("the end of the line").into()),
            None => Ok(()),
        }
    }

    fn end(&mut self) -> Result<(), PlyError> {
        match self.next_line() {
            Some(row) => Err(row[0].expected("the end of the file").into()),
            None => Ok(()),
        }
    }

    fn wrong(&self, reason: Reason) -> PlyError {
        self.row[self.used.saturating_sub(1)].wrong(reason).into()
    }
}

/// The rows of a binary file, with nothing between them.
pub(super) struct Binary<'a> {
    /// The whole file.
    bytes: &'a [u8],
    /// Where the number that was read last begins.
    last: usize,
    /// Where the next number begins.
    next: usize,
    order: Order,
}

impl<'a> Binary<'a> {
    /// The rows in `rest`, the last part of a file's `bytes`.
    pub(super) fn new(bytes: &'a [u8], rest: &[u8], order: Order) -> Self {
        let next = bytes.len() - rest.len();
        Self {
            bytes,
            last: next,
            next,
            order,
        }
    }
}

impl Body for Binary<'_> {
    fn begin_row(&mut self) -> Result<(), PlyError> {
        Ok(())
    }

    fn number(&mut self, kind: Kind) -> Result<f64, PlyError> {
        let size = match kind {
            Kind::Char | Kind::Uchar => 1,
            Kind::Short | Kind::Ushort => 2,
            Kind::Int | Kind::Uint | Kind::Float => 4,
            Kind::Double => 8,
        };
        self.last = self.next;
        let Some(found) = self.bytes.get(self.next..self.next + size) else {
            return Err(self.wrong(Reason::End("a number that the header promises")));
        };
        self.next += size;
        let mut bytes = [0; 8];
        bytes[..size].copy_from_slice(found);
        if self.order == Order::Big {
            bytes[..size].reverse();
        }
        let bits = u64::from_le_bytes(bytes);
        Ok(match kind {
            Kind::Char => f64::from(bits as i8),
            Kind::Short => f64::from(bits as i16),
            Kind::Int => f64::from(bits as i32),
            Kind::Uchar | Kind::Ushort | Kind::Uint => bits as f64,
            Kind::Float => f64::from(f32::from_bits(bits as u32)),
            Kind::Double => f64::from_bits(bits),
        })
    }

    fn end_row(&self) -> Result<(), PlyError> {
        Ok(())
    }

    fn end(&mut self) -> Result<(), PlyError> {
        self.last = self.next;
        match self.bytes.len() - self.next {
            0 => Ok(()),
            more => Err(self.wrong(Reason::Expected {
                expected: "the end of the file",
                found: format!("{more} more bytes"),
            })),
        }
    }

    fn wrong(&self, reason: Reason) -> PlyError {
        PlyError::Binary {
            byte: self.last,
            reason,
        }
    }
}
