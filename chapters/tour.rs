//! The tour: every chapter's pictures in one run.

use crate::LESSONS;
use crate::kit::options::Options;
use crate::kit::say::say;
use crate::kit::stage::{Drawn, Stage, progress_bar};
use crate::kit::untrusted::Untrusted;
use crate::kit::{captions, gallery, gallery::Drawing};
use crate::lesson::Lesson;
use clap::Args;
use indicatif::MultiProgress;
use raybook_workbook::curriculum::{self, CHAPTERS};
use std::time::Instant;

/// The options of `raybook tour`.
#[derive(Args, Debug)]
pub struct Tour {
    #[command(flatten)]
    options: Options,
    /// Only these chapters: 3,sphere,ch06
    #[arg(long, value_delimiter = ',')]
    only: Vec<String>,
}

impl Tour {
    /// Draws the chapters, one after the other. After each chapter, the gallery of the chapters that are drawn is written.
    ///
    /// # Errors
    /// If `--only` names a chapter that does not exist, or a picture cannot be drawn or written.
    pub fn run(&self) -> Drawn {
        let start = Instant::now();
        let chosen = self.chosen()?;
        let page = gallery::page_in(&self.options.out);
        say(format!(
            "The pictures come into {}: open it, and reload it as chapters finish.",
            Untrusted::from(page.as_path())
        ));
        let bars = MultiProgress::new();
        let mut drawings = Vec::new();
        for lesson in chosen {
            let chapter_start = Instant::now();
            let stage = Stage::new(
                lesson.name,
                self.options.clone(),
                false,
                bars.add(progress_bar()),
            );
            lesson
                .draw(&stage)
                .map_err(|error| format!("{}: {error}", lesson.name))?;
            let (outputs, time) = (stage.into_outputs(), chapter_start.elapsed());
            if bars.is_hidden() {
                say(format!(
                    "{:<24} {} pictures in {:.1} s{}",
                    lesson.name,
                    outputs.len(),
                    time.as_secs_f32(),
                    gallery::rays(&outputs)
                ));
            }
            captions::write(&self.options.out.join(lesson.name), &outputs)?;
            drawings.push(Drawing {
                lesson,
                outputs,
                time,
            });
            gallery::write(&self.options.out, &drawings)?;
        }
        say(format!(
            "{} chapters in {:.1} s; look at {}",
            drawings.len(),
            start.elapsed().as_secs_f32(),
            Untrusted::from(page.as_path())
        ));
        Ok(())
    }

    fn chosen(&self) -> Result<Vec<&'static Lesson>, String> {
        let names = || {
            CHAPTERS
                .iter()
                .map(|chapter| chapter.name)
                .collect::<Vec<_>>()
                .join(", ")
        };
        let mut words = self.only.iter();
        if let Some(wrong) = words.find(|word| curriculum::called(word).is_none()) {
            return Err(format!(
                "--only {wrong}: no chapter is called so; there are {}",
                names()
            ));
        }
        let wanted = |lesson: &&Lesson| {
            self.only.is_empty()
                || self
                    .only
                    .iter()
                    .any(|word| lesson.chapter().answers_to(word))
        };
        Ok(LESSONS.iter().filter(wanted).collect())
    }
}
