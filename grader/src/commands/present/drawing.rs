//! Drawing what the page asks for. Who asks for another picture is not interested in the one before: that ends at once. Only what is
//! drawn for good rests while a sketch is drawn, or a picture of the same chapter with knobs that were turned, and goes on then.

use super::place::Place;
use super::screens;
use indicatif::{ProgressBar, ProgressDrawTarget};
use raybook::store;
use raybook_chapters::kit::captions;
use raybook_chapters::kit::knobs::{self, Kind};
use raybook_chapters::kit::options::Options;
use raybook_chapters::kit::stage::{Output, Stage};
use raybook_chapters::lesson::Lesson;
use raybook_grader::mutex::lock;
use raybook_grader::serve::Answer;
use serde_json::json;
use std::error::Error;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

/// Where pictures are drawn.
pub(super) struct Studio {
    options: Options,
    /// Where a chapter's pictures are drawn for good. This rests while `at_once` is in use.
    for_good: Place,
    /// Where everything else is drawn.
    at_once: Place,
    /// What is being drawn for good, or was.
    going: Mutex<Option<Going>>,
}

/// A chapter's pictures that are being drawn for good.
struct Going {
    chapter: &'static str,
    /// Each time has a number of its own.
    number: u64,
    /// What who waits for another of its pictures is told, once it has ended.
    ended: Option<Answer>,
}

/// Width and samples of the first, quick version of a picture.
const QUICK: (u32, u32) = (240, 2);

/// Width of the second version of a picture whose knobs were turned, where no width is wanted.
const HALF: u32 = 480;

/// How good a picture is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Grade {
    /// Small, with few samples: something to look at, at once.
    Quick,
    /// Half as wide, with all samples: a quarter of the time.
    Half,
    /// As the tour draws it.
    Good,
}

/// How often it is looked whether a picture of a chapter that is being drawn is there.
const PAUSE: Duration = Duration::from_millis(50);

/// What is drawn of a chapter, and how.
#[derive(Clone, Copy)]
enum What<'a> {
    /// Its main picture, small: something to look at, at once.
    First,
    /// All its pictures, small: what there is to show.
    Sketches,
    /// All its pictures, for good, as the tour does.
    Pictures,
    /// One picture with knobs that were turned.
    Turned(&'a [String], &'a str, Grade),
}

impl Studio {
    pub(super) fn new(options: Options) -> Self {
        Self {
            options,
            for_good: Place::new(),
            at_once: Place::new(),
            going: Mutex::default(),
        }
    }

    /// The names and captions of a chapter's pictures: those that the tour drew, or else of sketches; `first=1` asks for one sketch.
    pub(super) fn screens(&self, lesson: &'static Lesson, query: &[(String, String)]) -> Answer {
        if let Some(screens) = screens::drawn(&self.options.out.join(lesson.name)) {
            return Answer::json(&json!({ "screens": screens, "all": true }));
        }
        let first = query.iter().any(|(name, _)| name == "first");
        let what = if first { What::First } else { What::Sketches };
        let told = |outputs: &[Output]| {
            let screens = screens::of_outputs(outputs);
            Answer::json(&json!({ "screens": screens, "all": !first }))
        };
        self.draw(lesson, what, told)
            .unwrap_or_else(|answer| answer)
    }

    /// A picture of a chapter with its knobs as they are said; `quick=1` asks for a small one, `half=1` for one that is half as
    /// wide, and `fresh=1` for none that was drawn before.
    pub(super) fn picture(
        self: &Arc<Self>,
        lesson: &'static Lesson,
        name: &str,
        query: &[(String, String)],
    ) -> Answer {
        let is_name = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
        if name.is_empty() || !name.chars().all(is_name) {
            return Answer::unknown();
        }
        let asks = |word: &str| query.iter().any(|(name, _)| name == word);
        let grade = match (asks("quick"), asks("half")) {
            (true, _) => Grade::Quick,
            (_, true) => Grade::Half,
            _ => Grade::Good,
        };
        let turned = match turned(lesson, query) {
            Ok(turned) => turned,
            Err(why) => return Answer::wrong(&why),
        };
        let png = Path::new(lesson.name).join(name).with_extension("png");
        if turned.is_empty() && !asks("fresh") {
            let kept = self.options.out.join(&png);
            return match self.kept(&kept) {
                Some(picture) => picture,
                None if grade == Grade::Quick => {
                    let sketch = read(&self.scratch("sketches").join(&png));
                    sketch.unwrap_or_else(Answer::unknown)
                }
                None => self.wait(lesson, &kept),
            };
        }
        let told = |outputs: &[Output]| match outputs.last() {
            Some(output) if output.png.ends_with(&png) => {
                let picture = read(&output.png).unwrap_or_else(Answer::unknown);
                picture.captioned(&output.caption)
            }
            _ => Answer::unknown(),
        };
        self.draw(lesson, What::Turned(&turned, name, grade), told)
            .unwrap_or_else(|answer| answer)
    }

    /// How much of the pixels is drawn that are known to be needed, from 0 to 1; none where they are drawn more than once.
    pub(super) fn progress(&self) -> Answer {
        let rests = self.at_once.easel.try_lock().is_err();
        let place = if rests { &self.at_once } else { &self.for_good };
        let share = place.share();
        Answer::json(&json!({ "share": (share < 1.0).then_some(share) }))
    }

    /// A picture that was drawn for good, with its caption, which may tell how; none if it has none, or is not there.
    fn kept(&self, png: &Path) -> Option<Answer> {
        let before = || {
            let text = store::read_text(&captions::file_in(png.parent()?)).ok()?;
            captions::find(&text, png.file_stem()?.to_str()?).map(str::to_owned)
        };
        let caption = self.for_good.caption(png).or_else(before)?;
        let picture = read(png)?;
        Some(picture.captioned(&caption))
    }

    /// Has a chapter's pictures drawn for good, if nobody does so yet, until this one is there.
    fn wait(self: &Arc<Self>, lesson: &'static Lesson, kept: &Path) -> Answer {
        let number = self.start(lesson);
        loop {
            if let Some(picture) = self.kept(kept) {
                return picture;
            }
            match &*lock(&self.going) {
                Some(going) if going.number == number => {
                    if let Some(ended) = &going.ended {
                        return ended.clone();
                    }
                }
                _ => return Answer::outdated(),
            }
            thread::sleep(PAUSE);
        }
    }

    /// The number of the drawing of a chapter for good that goes on; it is begun if there is none.
    fn start(self: &Arc<Self>, lesson: &'static Lesson) -> u64 {
        let mut going = lock(&self.going);
        let number = match &*going {
            Some(one) if one.chapter == lesson.name && one.ended.is_none() => return one.number,
            Some(one) => one.number + 1,
            None => 0,
        };
        *going = Some(Going {
            chapter: lesson.name,
            number,
            ended: None,
        });
        let studio = Arc::clone(self);
        thread::spawn(move || {
            let drawn = catch_unwind(AssertUnwindSafe(|| studio.draw_for_good(lesson)));
            let ended = drawn.unwrap_or_else(|_| {
                Answer::wrong("drawing this chapter failed: the terminal says why")
            });
            let mut going = lock(&studio.going);
            if let Some(one) = going.as_mut().filter(|one| one.number == number) {
                one.ended = Some(ended);
            }
        });
        number
    }

    /// Draws a chapter's pictures for good, and returns what who waits for one that is not among them is told.
    fn draw_for_good(&self, lesson: &'static Lesson) -> Answer {
        let folder = self.options.out.join(lesson.name);
        let written = self.draw(lesson, What::Pictures, |outputs| {
            captions::write(&folder, outputs)
        });
        match written {
            Ok(Ok(())) => Answer::wrong("there is no picture of this name"),
            Ok(Err(error)) => Answer::wrong(&error.to_string()),
            Err(answer) => answer,
        }
    }

    /// Draws, after the drawing that is in the way has been stopped, and does something with the pictures before anything else is drawn.
    fn draw<T>(
        &self,
        lesson: &'static Lesson,
        what: What,
        then: impl FnOnce(&[Output]) -> T,
    ) -> Result<T, Answer> {
        let wrong = |error: Box<dyn Error>| Answer::wrong(&error.to_string());
        let turned = match what {
            What::Turned(turned, ..) => turned,
            _ => &[],
        };
        let knobs = lesson.turn(turned).map_err(|error| wrong(error.into()))?;
        let place = if matches!(what, What::Pictures) {
            self.at_once.clear();
            &self.for_good
        } else {
            let is_elsewhere = |going: &Going| going.chapter != lesson.name;
            if lock(&self.going).as_ref().is_some_and(is_elsewhere) {
                self.for_good.clear();
            }
            &self.at_once
        };
        let ticket = place.clear();
        let _easel = lock(&place.easel);
        let (stage, bar) = self.stage(lesson, what);
        if !place.begin(&stage, bar, ticket) {
            return Err(Answer::outdated());
        }
        lesson.draw_turned(&stage, &knobs).map_err(wrong)?;
        if stage.stopper().load(Ordering::SeqCst) {
            return Err(Answer::outdated());
        }
        Ok(then(&stage.into_outputs()))
    }

    /// Where something is drawn, and the bar that shows how far it is.
    fn stage(&self, lesson: &'static Lesson, what: What) -> (Stage, ProgressBar) {
        let mut options = self.options.clone();
        let grade = match what {
            What::First | What::Sketches => Grade::Quick,
            What::Pictures => Grade::Good,
            What::Turned(.., grade) => grade,
        };
        match grade {
            Grade::Quick => (options.width, options.samples) = (Some(QUICK.0), Some(QUICK.1)),
            Grade::Half => {
                let half = options.width.map_or(HALF, |width| (width / 2).max(8));
                options.width = Some(half);
            }
            Grade::Good => {}
        }
        let bar = ProgressBar::with_draw_target(Some(0), ProgressDrawTarget::hidden());
        let stage = Stage::new(lesson.name, options, false, bar.clone());
        let sketches = || self.scratch("sketches").join(lesson.name);
        let stage = match what {
            What::First => stage.in_folder(sketches()).until("picture"),
            What::Sketches => stage.in_folder(sketches()),
            What::Pictures => stage.resting(Arc::clone(&self.at_once.easel)),
            What::Turned(_, last, _) => stage
                .in_folder(self.scratch("turned").join(lesson.name))
                .until(last),
        };
        (stage, bar)
    }

    /// A folder for what nobody needs again.
    fn scratch(&self, name: &str) -> PathBuf {
        self.options.out.join("present").join(name)
    }
}

/// A picture that is there: of a drawing its SVG, which is sharp on every projector.
fn read(png: &Path) -> Option<Answer> {
    let svg = store::read(&png.with_extension("svg")).map(Answer::svg);
    svg.or_else(|_| store::read(png).map(Answer::png)).ok()
}

/// The arguments that turn the knobs of a query: those of the chapter that no file belongs to.
fn turned(lesson: &Lesson, query: &[(String, String)]) -> Result<Vec<String>, String> {
    let knobs = knobs::of(&lesson.knobs());
    let argument = |(name, value): &(String, String)| {
        let is_it = |knob: &&knobs::Knob| knob.name == *name && knob.kind != Kind::File;
        match knobs.iter().find(is_it) {
            Some(_) => Ok(format!("--{name}={value}")),
            None => Err(format!("{} has no knob `{name}`", lesson.name)),
        }
    };
    query
        .iter()
        .filter(|(name, _)| !["quick", "half", "fresh"].contains(&name.as_str()))
        .map(argument)
        .collect()
}
