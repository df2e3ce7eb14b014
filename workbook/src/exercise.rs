//! An exercise: one function of the library, asked many times.

use crate::kind::{Field, Kind};
use crate::row::{self, Row, RowError};

/// One function that a student writes; the type is the question, and its fields are the function's parameters.
pub trait Exercise: Row {
    /// What it returns.
    type Answer: Row;
    /// Its name: the grade key, and the anchor around the function in the library.
    const NAME: &'static str;
    /// What to do, in a sentence or two of mathematics; also the comment above the student's stub.
    const TASK: &'static str;
    /// What this means for the types of the library, for those who write it in Rust; empty if there is nothing to say.
    const IN_RUST: &'static str;
    /// The answer: its name, its kind and its meaning.
    const ANSWER: Field;

    /// Calls the library's function; in a student's copy of the library, the student's.
    fn answer(&self) -> Self::Answer;
}

/// An exercise whose types are forgotten: questions and answers are lines, or rows of numbers.
#[derive(Debug)]
pub struct Asked {
    /// Its name.
    pub name: &'static str,
    /// What to do.
    pub task: &'static str,
    /// What this means in Rust; may be empty.
    pub in_rust: &'static str,
    /// The kind of its questions.
    pub question: &'static Kind,
    /// Its answers.
    pub answer: Field,
    /// Answers a question, both as numbers.
    pub call: fn(&[f64]) -> Vec<f64>,
}

impl Asked {
    /// An exercise without its types.
    pub const fn of<E: Exercise>() -> Self {
        Self {
            name: E::NAME,
            task: E::TASK,
            in_rust: E::IN_RUST,
            question: E::KIND,
            answer: E::ANSWER,
            call: |question| row::to_numbers(&row::from_numbers::<E>(question).answer()),
        }
    }

    /// The names of a question's words.
    pub fn question_names(&self) -> Vec<String> {
        self.question.names("question")
    }

    /// The names of an answer's words.
    pub fn answer_names(&self) -> Vec<String> {
        self.answer.kind.names(self.answer.name)
    }

    /// The parameters of the function, which are the fields of a question.
    pub fn parameters(&self) -> &'static [Field] {
        match self.question {
            Kind::Record(record) => record.fields,
            _ => &[],
        }
    }

    /// The numbers of a question.
    ///
    /// # Errors
    /// If the line is not a question of this exercise.
    pub fn read_question(&self, line: &str) -> Result<Vec<f64>, RowError> {
        row::parse(self.question, line, "question")
    }

    /// The numbers of an answer.
    ///
    /// # Errors
    /// If the line is not an answer to this exercise.
    pub fn read_answer(&self, line: &str) -> Result<Vec<f64>, RowError> {
        row::parse(self.answer.kind, line, self.answer.name)
    }

    /// Answers a question.
    ///
    /// # Errors
    /// If the line is not a question of this exercise.
    pub fn answer_line(&self, question: &str) -> Result<String, RowError> {
        let mut answer = (self.call)(&self.read_question(question)?);
        for v in &mut answer {
            *v += 0.0; // a zero without a sign, as people write it
        }
        Ok(row::format(self.answer.kind, &answer))
    }
}

/// What the comment of a declaration says of mathematics, and what of Rust.
pub(crate) const fn task(comment: &'static str) -> (&'static str, &'static str) {
    const IN_RUST: &[u8] = b"In Rust: ";
    let bytes = comment.as_bytes();
    let mut at = 0;
    while at + IN_RUST.len() <= bytes.len() {
        let mut same = 0;
        while same < IN_RUST.len() && bytes[at + same] == IN_RUST[same] {
            same += 1;
        }
        if same == IN_RUST.len() {
            let (task, in_rust) = comment.split_at(at);
            return (
                task.trim_ascii(),
                in_rust.split_at(IN_RUST.len()).1.trim_ascii(),
            );
        }
        at += 1;
    }
    (comment.trim_ascii(), "")
}

/// Declares the exercises of a chapter, each once:
///
/// ```text
/// exercises! { ($) ch03_sphere
///     /// The task.
///     ///
///     /// In Rust: which types of the library say this. (May be left out.)
///     SphereHit: sphere_hit(
///         /// What the parameter means, and its unit.
///         ray: Ray,
///         /// What this one means; its range ends the sentence,
///         radius: f32 [above 0],
///     ) -> (
///         /// What the answer means, and its unit.
///         t: Option<f32>,
///     ) {
///         the call of the library's function, in which the parameters are variables; or `|q| { … }`, in which q has them all
///     }
/// }
/// ```
///
/// It makes the struct `SphereHit` of the parameters, which is the question and its row; its [`Exercise`]; the chapter's list
/// `EXERCISES`; and the macro `ch03_sphere!`, which calls another macro with the names of the exercises and of their types. The
/// `$` is for the parameter of that macro.
macro_rules! exercises {
    (($d:tt) $chapter:ident $(
        $(#[doc = $task:literal])+
        $exercise:ident: $name:ident($(
            $(#[doc = $meaning:literal])+
            $field:ident: $kind:ty $([$($range:tt)+])?
        ),+ $(,)?) -> (
            $(#[doc = $answers:literal])+
            $answer:ident: $type:ty $([$($within:tt)+])? $(,)?
        ) $(|$q:ident|)? $body:block
    )+) => {
        /// The exercises of this chapter, in order.
        pub static EXERCISES: &[crate::exercise::Asked] =
            &[$(crate::exercise::Asked::of::<$exercise>()),+];

        /// Calls a macro with the chapter, and the name and the type of each of its exercises.
        #[macro_export]
        macro_rules! $chapter {
            ($d then:ident) => {
                $d then! { $chapter $($name: $exercise),+ }
            };
        }

        $(
            crate::record::row! {
                $(#[doc = $task])+
                pub struct $exercise {
                    $($(#[doc = $meaning])+ pub $field: $kind $([$($range)+])?),+
                }
            }

            impl crate::exercise::Exercise for $exercise {
                type Answer = $type;
                const NAME: &'static str = stringify!($name);
                const TASK: &'static str = crate::exercise::task(concat!($($task),+)).0;
                const IN_RUST: &'static str = crate::exercise::task(concat!($($task),+)).1;
                const ANSWER: crate::kind::Field =
                    crate::record::field!($(#[doc = $answers])+ $answer: $type $([$($within)+])?);

                fn answer(&self) -> Self::Answer {
                    crate::exercise::answer_of!(self [$($q)?] [$($field),+] $body)
                }
            }
        )+
    };
}

/// The value of a declaration's block: in it the parameters are variables, or the name between bars is the whole question.
macro_rules! answer_of {
    ($this:ident [] [$($field:ident),+] $body:block) => {{
        let Self { $($field),+ } = $this.clone();
        $body
    }};
    ($this:ident [$q:ident] [$($field:ident),+] $body:block) => {{
        let $q = $this;
        $body
    }};
}

pub(crate) use {answer_of, exercises};
