//! What every student's program has, in whatever language: reading a question's numbers, printing an answer's.

use glam::{DVec2, DVec3};

/// Another right program for an exercise.
pub struct Alternative {
    /// The exercise.
    pub exercise: &'static str,
    /// The method.
    pub method: &'static str,
    /// The answer's numbers; `None` for none.
    pub answer: fn(&mut Question) -> Answer,
}

/// The numbers of an answer.
pub type Answer = Option<Vec<f64>>;

/// The word `none` where a number could be, at the end of an answer.
pub const NONE: f64 = f64::from_bits(0x7ff8_0000_6e6f_6e65);

/// How a number becomes a word.
pub type Print = fn(f64) -> String;

/// How a language prints a number that is not whole. (All print whole ones, such as an id, without a point.)
pub const STYLES: [(&str, Print); 3] = [
    ("as short as it can be read back", |v| format!("{v}")),
    ("with 17 digits after the point", |v| format!("{v:.17}")),
    ("with an exponent", |v| format!("{v:.16E}")),
];

impl Alternative {
    /// The answer to a question's line.
    pub fn answer_to(&self, question: &str) -> Answer {
        let mut question = Question::read(question);
        let answer = (self.answer)(&mut question);
        assert!(
            question.is_empty(),
            "{}, {}: words are left over",
            self.exercise,
            self.method
        );
        answer
    }
}

/// An answer as words.
pub fn line(answer: &Answer, print: Print) -> String {
    let word = |&v: &f64| {
        if v.to_bits() == NONE.to_bits() {
            "none".to_owned()
        } else if v.fract() == 0.0 {
            format!("{v}")
        } else {
            print(v)
        }
    };
    answer.as_ref().map_or_else(
        || "none".to_owned(),
        |numbers| numbers.iter().map(word).collect::<Vec<_>>().join(" "),
    )
}

/// The words of a question that are still to be read; nearly all are numbers.
pub struct Question {
    words: std::vec::IntoIter<String>,
}

impl Question {
    pub fn read(line: &str) -> Self {
        let words: Vec<_> = line.split_whitespace().map(str::to_owned).collect();
        Self {
            words: words.into_iter(),
        }
    }

    pub fn is_empty(&self) -> bool {
        self.words.len() == 0
    }

    pub fn word(&mut self) -> String {
        self.words.next().expect("one more word")
    }

    pub fn number(&mut self) -> f64 {
        let word = self.word();
        word.parse()
            .unwrap_or_else(|_| panic!("`{word}` is no number"))
    }

    pub fn whole(&mut self) -> usize {
        self.number() as usize
    }

    pub fn pair(&mut self) -> DVec2 {
        DVec2::new(self.number(), self.number())
    }

    pub fn vector(&mut self) -> DVec3 {
        DVec3::new(self.number(), self.number(), self.number())
    }

    /// A list, which begins with its length.
    pub fn list<T>(&mut self, read: fn(&mut Self) -> T) -> Vec<T> {
        (0..self.whole()).map(|_| read(self)).collect()
    }

    /// A ray and the interval that counts.
    pub fn ray(&mut self) -> Ray {
        Ray {
            o: self.vector(),
            d: self.vector(),
            min: self.number(),
            max: self.number(),
        }
    }
}

/// A ray and the interval that counts.
#[derive(Clone, Copy)]
pub struct Ray {
    pub o: DVec3,
    pub d: DVec3,
    pub min: f64,
    pub max: f64,
}

impl Ray {
    pub fn counts(&self, t: f64) -> bool {
        self.min < t && t < self.max
    }

    /// The first of these distances that counts, as an answer.
    pub fn first(&self, candidates: &[f64]) -> Answer {
        let t = candidates.iter().find(|&&t| self.counts(t))?;
        Some(vec![*t])
    }
}
