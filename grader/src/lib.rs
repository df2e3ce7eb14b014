//! What the course knows and the student does not: cases, judges, mistakes. It never travels with the starter.

pub mod again;
pub mod ask;
mod attempt;
pub mod book;
pub mod budget;
pub mod capstone;
pub mod cases;
pub mod check;
pub mod class;
mod clock;
pub mod command_line;
pub mod contain;
mod contradiction;
pub mod converse;
pub mod describe;
pub mod diagnose;
pub mod dress;
mod each;
pub mod examine;
pub mod explain;
pub mod feedback;
pub mod fingerprint;
pub mod finite;
pub mod further;
pub mod golden;
pub mod hidden;
pub mod inside;
pub mod json;
pub mod judge;
pub mod jump;
pub mod keys;
pub mod language;
pub mod layout;
pub mod leeway;
pub mod library;
pub mod limits;
mod listen;
pub mod lock;
pub mod manifest;
pub mod mutex;
pub mod own;
pub mod own_chapters;
pub mod pairing;
pub mod passage;
pub mod patterns;
pub mod picture;
pub mod prints;
pub mod progress;
pub mod rare;
pub mod reader;
pub mod recipe;
pub mod related;
pub mod report;
pub mod sample;
pub mod sandbox;
pub mod search;
pub mod seen;
pub mod serve;
pub mod shrink;
mod slowness;
pub mod stable;
pub mod starter;
#[cfg(target_os = "linux")]
mod stat;
pub mod student;
mod suspend;
pub mod together;
pub mod traits;
mod trial;
mod upon;
pub mod watched;

use raybook::image::rgb::Rgb;
use raybook::math::pcg::Pcg;
use raybook_workbook::exercise::Exercise;
use together::Bounds;

/// Whether an answer is right; if not, why not, in the exercise's own words and units.
pub type Verdict = Result<(), String>;

/// An exercise with everything that grading needs, but for its named cases: they are text, in its golden file.
pub trait Graded: Exercise + Clone + Sync + 'static {
    /// An ordinary question. It is kept only if its answer does not hang on the last digits of its numbers.
    fn random(rng: &mut Pcg) -> Self;

    /// Compares an answer with the golden one.
    ///
    /// # Errors
    /// Why the answer is wrong.
    fn judge(question: &Self, golden: &Self::Answer, got: &Self::Answer) -> Verdict;

    /// Why an answer is wrong, in more words than its judge has, where these take time to find: of thousands of predicted answers nobody reads them.
    fn complaint(
        _question: &Self,
        _golden: &Self::Answer,
        _got: &Self::Answer,
        why: String,
    ) -> String {
        why
    }

    /// Judges all answers together that are right one by one: a bias that hides in the scatter of each shows in all of them, and
    /// so does a number of the question that no answer depends on. Of answers that are within all bounds of chance, narrower ones tell which leave doubt.
    ///
    /// # Errors
    /// What is wrong with them; a right method meets one less than once in ten thousand classes of 500.
    fn together(_answers: &[(Self, Self::Answer)], _bounds: Bounds) -> Verdict {
        Ok(())
    }

    /// Further questions for a program that is right in all cases. They are asked as long as all answers together leave doubt, and keep
    /// within the limits of the cases.
    fn further(_rng: &mut Pcg) -> Vec<Self> {
        Vec::new()
    }

    /// A question with this number of elements, for an exercise that builds a structure: among many, a wrong cost shows that a dozen
    /// hide. None of another exercise.
    fn crowded(_rng: &mut Pcg, _count: usize) -> Option<Self> {
        None
    }

    /// What the judge allows where many answers are right, in sentences for students: how much dearer a tree may be, or how much room a
    /// pattern may leave.
    const ALLOWS: &'static str = "";

    /// Questions that follow from others.
    const RELATIONS: &'static [Relation<Self>] = &[];

    /// Wrong implementations that students are known to write.
    const MISTAKES: &'static [Mistake<Self>];

    /// Complaints of the judge that say what is wrong with a function, where answers have many right forms, such as trees and patterns.
    const FLAWS: &'static [Flaw] = &[];

    /// The pictures that the answers make, where the exercise is one of pixels.
    const PICTURES: &'static [Picture<Self>] = &[];

    /// A question whose answer turns wrong when its numbers move by this number of their last digits is nobody's fault: more
    /// where an answer is the end of a long way.
    const ULPS: i32 = 8;

    /// An answer this close to a mistake's, relatively, is that mistake: more where answers scatter.
    const ALIKE: f32 = 1e-3;

    /// What of an answer tells mistakes apart where many answers are right: costs, counts, shares of a distribution, each of about
    /// the size of 1, and as many for every question. With none, the answer's own numbers do.
    fn traits(_question: &Self, _answer: &Self::Answer) -> Vec<f64> {
        Vec::new()
    }

    /// The one form that stands for all answers that mean the same, such as a tree whose nodes are numbered otherwise. It is asked of
    /// wrong answers too.
    fn canonical(_question: &Self, answer: Self::Answer) -> Self::Answer {
        answer
    }

    /// Fields of the question that a diagnosis may misread only as numbers of about the same size, above 0: with others there would
    /// be no answer, or no end of it.
    const POSITIVE: &'static [&'static str] = &[];

    /// Fields of the question that a diagnosis does not misread: they belong to others.
    const FIXED: &'static [&'static str] = &[];

    /// Whether a question keeps what its fields say of each other: the smaller of two bounds is the smaller, axes are perpendicular. Random
    /// and named questions do; those that are made of others for a student to look at must.
    fn is_sound(_question: &Self) -> bool {
        true
    }

    /// How many times as long it takes to find an answer as to read the question's numbers and to write the answer's. Above 1, a diagnosis does
    /// not try misread questions, and fewer further questions are asked (see [`rare`]).
    const EFFORT: usize = 1;

    /// The right answer to a question that was misread: what many a mistake comes down to.
    fn misread(question: &Self, how: impl FnOnce(&mut Self)) -> Self::Answer {
        let mut question = question.clone();
        how(&mut question);
        question.right()
    }

    /// The right answer, of which a mistake is made, and to a question that is misread. Where two mistakes are tried at once, it is that of the
    /// other one. Of an estimate it is the mean, which is sooner there than an estimate.
    fn right(&self) -> Self::Answer {
        upon::answer(self).unwrap_or_else(|| self.answer())
    }
}

/// A way to make a question of another. Its answer is the reference's, which need not be that to the first.
pub struct Relation<E> {
    /// What is done to it, as a participle: "moved by a metre".
    pub name: &'static str,
    /// The question made of another.
    pub question: fn(&E) -> E,
}

impl<E> Relation<E> {
    /// The whole scene at another place.
    pub const fn moved(question: fn(&E) -> E) -> Self {
        let name = "moved by a metre along each axis";
        Self { name, question }
    }
}

/// A wrong implementation.
pub struct Mistake<E: Exercise> {
    /// What it does, as a verb: "takes the far root".
    pub name: &'static str,
    /// A sentence that leads the student on and does not give the answer away.
    pub hint: &'static str,
    /// The wrong answer.
    pub answer: fn(&E) -> E::Answer,
}

/// Something wrong that can be read off an answer, whatever made it. It is told where no mistake gives the same answers.
#[derive(Clone, Copy, Debug)]
pub struct Flaw {
    /// Words of the judge's complaint, which no other complaint has.
    pub complaint: &'static str,
    /// What a function with such answers does, as a verb: "puts more shapes into a leaf than are allowed".
    pub name: &'static str,
    /// A sentence that leads the student on.
    pub hint: &'static str,
}

/// A picture with a question per pixel.
pub struct Picture<E: Exercise> {
    /// What it is called, among an exercise's pictures.
    pub name: &'static str,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// What it shows, for those who cannot see it.
    pub alt: &'static str,
    /// The question of the pixel in column x and row y.
    pub question: fn(x: u32, y: u32) -> E,
    /// The colour of an answer.
    pub colour: fn(&E, &E::Answer) -> Rgb,
}
