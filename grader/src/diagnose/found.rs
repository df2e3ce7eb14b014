//! An explanation that was found, and what may be said of it.

use super::evidence::{Evidence, Scope, Score};
use super::fit::Answers;
use super::pairs;
use super::special::SEEN;
use super::{Beside, Diagnosis, MOST, ties};

/// A guess that explains all wrong answers may be contradicted by this many right ones for each.
const SOME: usize = 4;

/// An explanation is nearly complete if it gives this many wrong answers for each one that is not as it says.
const NEARLY: usize = 6;

/// What is rarer than this is told only if it explains nearly all wrong answers, and to the last digits.
const RARE: u32 = 26;

/// What is made in some cases only must explain answers that tell this much.
const PARTLY: f64 = 2.0;

/// An explanation, and how well it agrees.
pub struct Found {
    pub name: String,
    pub hint: String,
    /// A mistake made after the first.
    pub then: Option<(String, String)>,
    /// Another mistake that explains the same answers, which say too little to tell which of the two it is.
    pub rival: Option<(String, String)>,
    pub rank: u32,
    pub fitted: u32,
    pub score: Score,
    pub answers: Answers,
    /// How many of these are what they are because rounding decides.
    pub ties: usize,
}

impl Found {
    /// Small is good.
    pub fn key(&self) -> (usize, usize, u32, usize) {
        let loss = self.score.missed + self.score.contradicted;
        (
            loss,
            self.ties,
            self.rank + 2 * self.fitted,
            usize::MAX - self.score.close,
        )
    }

    /// Whether it explains all wrong answers, and contradicts no right one.
    pub fn is_complete(&self) -> bool {
        self.score.missed + self.score.contradicted == 0
    }

    /// Whether it explains all wrong answers, none of them because rounding decides so.
    pub fn is_exact(&self) -> bool {
        self.is_complete() && self.ties == 0
    }

    /// Where rounding decides, takes what one `answer`s who makes the mistake as the student's rounding decides.
    pub fn decide_ties(
        &mut self,
        evidence: &Evidence<'_>,
        answer: &dyn Fn(&[f64]) -> Option<Vec<f64>>,
    ) {
        if !self.is_complete() && self.is_nearly_complete() {
            self.ties = ties::decide(evidence, &mut self.answers, answer);
            let score = evidence.score(MOST, |k| self.answers[k].clone());
            self.score = score.unwrap_or(self.score);
        }
    }

    /// Whether few answers are not as it says.
    pub fn is_nearly_complete(&self) -> bool {
        NEARLY * (self.score.missed + self.score.contradicted) <= self.score.explained
    }

    /// Whether it is one mistake that no right answer contradicts, and few of the wrong ones are not to the last digits as it says.
    pub fn is_nearly_the_one(&self) -> bool {
        let is_near = self.is_nearly_complete() && self.score.contradicted == 0;
        self.is_complete() || is_near && self.then.is_none() && self.is_sharp()
    }

    /// Whether it gives all wrong answers to the last digits, several that tell much, so that it is no chance, whatever the right ones are.
    pub fn is_partly(&self) -> bool {
        let Score {
            explained,
            missed,
            sharp,
            tells,
            is_doubtful,
            ..
        } = self.score;
        let is_exact = missed == 0 && sharp == explained && !is_doubtful;
        is_exact && self.fitted == 0 && tells >= PARTLY
    }

    /// Whether most of what it explains is as it says to the last digits. Guesses are many: within a judge's tolerance, one or another
    /// fits by chance.
    pub fn is_sharp(&self) -> bool {
        2 * self.score.sharp >= self.score.explained
    }

    pub fn is_own(&self) -> bool {
        self.rank == 0
    }

    /// Whether it is one of the exercise's own mistakes, or two of them.
    pub fn is_of_own(&self) -> bool {
        self.is_own() || self.then.is_some() && self.rank <= pairs::OWN
    }

    /// Whether it may be told at all.
    pub fn holds(&self) -> bool {
        let Score {
            explained,
            missed,
            contradicted,
            tells,
            ..
        } = self.score;
        if self.rank > RARE && !(self.is_sharp() && NEARLY * missed <= explained) {
            return false;
        }
        if tells >= 1.0 {
            let own = missed == 0 && self.is_own() && !self.is_categorical();
            contradicted <= explained
                || own
                || missed == 0 && self.fitted == 0 && contradicted <= SOME * explained
        } else {
            2 * contradicted <= explained
        }
    }

    pub fn is_certain(&self) -> bool {
        let Score {
            missed,
            contradicted,
            strays,
            tells,
            is_rough,
            is_doubtful,
            ..
        } = self.score;
        let needed = match (self.is_own(), self.is_categorical()) {
            (true, false) => 1.0,
            (true, true) => 2.0,
            (false, _) if self.rank == SEEN => 1.0,
            (false, true) => f64::INFINITY,
            (false, false) => 2.0 + f64::from(self.fitted),
        };
        // Pairs of mistakes are many, and one may fit by chance; and estimates are on the whole too large for many a reason.
        let is_guessed = is_rough && self.fitted > 0;
        missed == 0
            && !is_guessed
            && (self.is_own() || self.is_sharp())
            && contradicted + strays == 0
            && !is_doubtful
            && tells >= needed
            && self.then.is_none()
            && self.rival.is_none()
    }

    /// Whether the answers are little more than yes and no, which many mistakes explain alike.
    pub fn is_categorical(&self) -> bool {
        self.score.tells < 0.9 * self.score.explained as f64
    }

    pub fn told(&self, evidence: &Evidence<'_>) -> Diagnosis {
        // A mistake of the whole function shows in more answers than it is contradicted by.
        let in_some = self.is_own() && self.score.contradicted > self.score.explained;
        self.told_only(evidence, in_some.then_some("in some cases"))
    }

    /// What it is, and when `only` it is made, if that is known.
    pub fn told_only(&self, evidence: &Evidence<'_>, only: Option<&str>) -> Diagnosis {
        let only = only.map_or_else(String::new, |only| format!(", but only {only}"));
        let part = match evidence.scope {
            Scope::Whole => None,
            Scope::Part(part) => Some(evidence.parts[part].name.clone()),
            Scope::Shape => Some("the number of answers".to_owned()),
        };
        let one = |name: &String, hint: &String, beside: Beside| Diagnosis {
            name: format!("{name}{only}"),
            hint: hint.clone(),
            part: part.clone(),
            certain: self.is_certain(),
            explained: self.score.explained,
            wrong: evidence.wrong,
            further: 0,
            shown: evidence.first_explained(&self.answers),
            beside,
            also: Vec::new(),
        };
        let told = |beside| move |(name, hint): &(String, String)| one(name, hint, beside);
        let then = self.then.iter().map(told(Beside::Together));
        let rival = self.rival.iter().map(told(Beside::Instead));
        Diagnosis {
            also: then.chain(rival).collect(),
            ..one(&self.name, &self.hint, Beside::Apart)
        }
    }
}
