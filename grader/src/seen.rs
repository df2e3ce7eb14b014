//! What values occur: the smallest and the largest number of each field over many rows, as the fields' kinds tell.

use raybook_workbook::kind::Kind;
use raybook_workbook::row::Numbers;

/// What occurs of a value.
#[derive(Clone, Debug, PartialEq)]
pub struct Seen {
    /// The smallest and the largest finite number; of a list, its shortest and longest length. None if there is no value.
    pub range: Option<[f64; 2]>,
    /// Whether `inf` occurs.
    pub infinite: bool,
    /// Whether `-inf` occurs.
    pub minus_infinite: bool,
    /// Whether `none` occurs.
    pub none: bool,
    /// What occurs of its parts: of the value of an optional, of the elements of a list, of the fields, of the choices.
    pub of: Vec<Seen>,
}

impl Seen {
    /// What occurs in rows of a kind.
    pub fn in_rows<'a>(kind: &Kind, rows: impl IntoIterator<Item = &'a [f64]>) -> Self {
        let mut seen = Self::nothing(kind);
        for row in rows {
            seen.see(kind, &mut Numbers::of(row));
        }
        seen
    }

    fn nothing(kind: &Kind) -> Self {
        let of = match kind {
            Kind::Number | Kind::Whole | Kind::Numbers(_) | Kind::Direction => vec![],
            Kind::Optional(kind) | Kind::List(kind) => vec![Self::nothing(kind)],
            Kind::Record(record) => {
                let kinds = record.fields.iter().map(|field| field.kind);
                kinds.map(Self::nothing).collect()
            }
            Kind::Choice(choices) => {
                let kinds = choices.iter().map(|(_, kind)| *kind);
                kinds.map(Self::nothing).collect()
            }
        };
        Self {
            range: None,
            infinite: false,
            minus_infinite: false,
            none: false,
            of,
        }
    }

    fn see(&mut self, kind: &Kind, numbers: &mut Numbers<'_>) {
        match kind {
            Kind::Number | Kind::Whole => self.number(numbers.number()),
            Kind::Numbers(parts) => parts
                .parts
                .iter()
                .for_each(|_| self.number(numbers.number())),
            Kind::Direction => (0..3).for_each(|_| self.number(numbers.number())),
            Kind::Optional(kind) => {
                if numbers.number() == 0.0 {
                    self.none = true;
                } else {
                    self.of[0].see(kind, numbers);
                }
            }
            Kind::List(kind) => {
                let length = numbers.number();
                self.number(length);
                (0..length as u32).for_each(|_| self.of[0].see(kind, numbers));
            }
            Kind::Record(record) => {
                for (seen, field) in self.of.iter_mut().zip(record.fields) {
                    seen.see(field.kind, numbers);
                }
            }
            Kind::Choice(choices) => {
                let i = numbers.number() as usize;
                if let Some((_, kind)) = choices.get(i) {
                    self.of[i].see(kind, numbers);
                }
            }
        }
    }

    fn number(&mut self, v: f64) {
        self.infinite |= v == f64::INFINITY;
        self.minus_infinite |= v == f64::NEG_INFINITY;
        if v.is_finite() {
            let [least, most] = self.range.unwrap_or([v, v]);
            self.range = Some([least.min(v), most.max(v)]);
        }
    }
}
