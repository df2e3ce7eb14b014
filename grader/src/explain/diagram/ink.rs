//! What the marks of a drawing stand for, and how that looks.

/// What a mark stands for. Its colour and its form say the same, so that either is enough.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Ink {
    /// The ray, or what arrives.
    Ray,
    /// The distances that count.
    Interval,
    /// The shape that is asked about.
    Shape,
    /// The right answer.
    Right,
    /// The student's answer.
    Yours,
    /// What only helps to see.
    Guide,
}

impl Ink {
    /// Okabe and Ito's colours, which the colour-blind tell apart.
    pub(super) fn colour(self) -> &'static str {
        match self {
            Self::Ray => "#282828",
            Self::Interval => "#56b4e9",
            Self::Shape => "#0072b2",
            Self::Right => "#009e73",
            Self::Yours => "#d55e00",
            Self::Guide => "#8a8a8a",
        }
    }

    pub(super) fn width(self) -> f64 {
        match self {
            Self::Interval => 11.0,
            Self::Guide => 1.3,
            _ => 2.6,
        }
    }

    /// The dashes of its lines.
    pub(super) fn dashes(self) -> &'static str {
        match self {
            Self::Yours => "9 5",
            Self::Guide => "3 4",
            _ => "none",
        }
    }

    /// What the key says of it; nothing of what has its label.
    pub(super) fn meaning(self) -> &'static str {
        match self {
            Self::Ray => "the ray",
            Self::Interval => "the distances that count",
            Self::Right => "the right answer",
            Self::Yours => "your answer",
            Self::Shape | Self::Guide => "",
        }
    }
}
