//! The lab's page: every figure with its files, and the table.

use crate::kit::figure::Diagram;
use crate::kit::html::page;
use crate::kit::stage::Drawn;
use crate::lab::page_style::{SCRIPT, STYLE};
use crate::lab::plot::Plot;
use crate::lab::settings::Settings;
use crate::lab::subject::known;
use crate::lab::table;
use crate::lab::table::{COLUMNS, Row};
use maud::{Markup, PreEscaped, html};
use raybook::image::Image;
use raybook::image::file::{self, FileError};
use raybook::store;
use std::error::Error;
use std::panic::resume_unwind;
use std::path::PathBuf;
use std::thread::{self, JoinHandle};

/// Width of a row of pictures on a page of 1400 pixels, and of the space beside each picture, in pixels.
const ROW: usize = 1368;
const GAP: usize = 8;

/// A page that grows section by section, and the folder of its files.
#[derive(Debug)]
pub struct Page {
    folder: PathBuf,
    remarks: Vec<String>,
    command: String,
    slides: bool,
    /// Whether the lab knows more patterns than it shows.
    shows_a_choice: bool,
    sections: Vec<(&'static str, Markup, Vec<Markup>)>,
    /// The picture that is being written.
    saving: Option<JoinHandle<Result<(), FileError>>>,
}

/// Pictures of one target: the words and the names of the patterns, and the numbers of samples.
#[derive(Debug)]
pub struct Tiles<'a> {
    /// The name of the target as a word.
    pub target: &'a str,
    /// Words and names of the patterns.
    pub patterns: &'a [(String, String)],
    /// The numbers of samples.
    pub samples: &'a [usize],
    /// Width of a picture.
    pub width: usize,
}

impl Page {
    /// A page in a folder, with remarks at its beginning.
    pub fn new(settings: &Settings) -> Self {
        Self {
            folder: settings.folder.clone(),
            remarks: settings.remarks.clone(),
            command: settings.command.clone(),
            slides: settings.slides,
            shows_a_choice: {
                let is_shown = |name| settings.subjects.iter().any(|s| s.pattern.name == name);
                !known().all(|pattern| is_shown(pattern.name))
            },
            sections: Vec::new(),
            saving: None,
        }
    }

    /// Begins a section: its title, and a text about what is seen in the section.
    pub fn section(&mut self, title: &'static str, text: Markup) {
        self.sections.push((title, text, Vec::new()));
    }

    /// Writes a plot as PNG, SVG and CSV, and shows the plot: `alt` says what it shows, and `how` says how it was measured.
    ///
    /// # Errors
    /// If it cannot be drawn or written.
    pub fn plot(&mut self, name: &str, alt: &str, how: &str, plot: &dyn Plot) -> Drawn {
        let Diagram { pixels, svg } = plot.large()?;
        self.save(name, pixels)?;
        self.write(name, "svg", svg.as_bytes())?;
        self.write(name, "csv", plot.csv().as_bytes())?;
        let link = |extension: &str, name_of_it| html! { a href={ (name) "." (extension) } { (name_of_it) } };
        let (width, height) = plot.size();
        let file = format!("{name}.svg");
        self.add(html! { figure {
            div class="scroll" { a href=(file) { img src=(file) alt=(alt) width=(width) height=(height) loading="lazy"; } }
            figcaption { (alt) " " (self.how(how)) " " (link("png", "PNG")) " · " (link("svg", "SVG")) " · " (link("csv", "CSV")) }
        } });
        Ok(())
    }

    /// How something was measured, and the command that measures it again.
    fn how(&self, how: &str) -> Markup {
        html! { (how) ". " code { (self.command) } }
    }

    /// Writes one picture as PNG, on a thread of its own: the next measurement runs meanwhile. There is one such thread at a
    /// time.
    ///
    /// # Errors
    /// If the picture before it could not be written.
    pub fn save(&mut self, name: &str, picture: Image) -> Drawn {
        self.wait()?;
        let path = self.folder.join(name).with_extension("png");
        self.saving = Some(thread::spawn(move || file::save(&path, &picture)));
        Ok(())
    }

    /// Waits until the latest picture is written.
    fn wait(&mut self) -> Drawn {
        match self.saving.take().map(JoinHandle::join) {
            Some(Ok(saved)) => Ok(saved?),
            Some(Err(panic)) => resume_unwind(panic),
            None => Ok(()),
        }
    }

    /// Shows pictures that were written, unscaled: a figure for each number of samples, with a picture for each pattern. The pictures
    /// are in as few rows as a wide page allows, and all rows are equally long.
    pub fn tiles(&mut self, alt: &str, how: &str, tiles: &Tiles) {
        let (width, count) = (tiles.width, tiles.patterns.len());
        let rows = (count * (width + GAP)).div_ceil(ROW).max(1);
        let style = format!(
            "--width: {width}px; max-width: {}px",
            count.div_ceil(rows) * (width + GAP)
        );
        for samples in tiles.samples {
            let plural = if *samples == 1 { "" } else { "s" };
            let alt = format!("{alt}, with {samples} sample{plural} per pixel.");
            self.add(html! { figure {
                div class="pixels" style=(style) tabindex="0" role="group" aria-label=(alt) {
                    @for (key, title) in tiles.patterns { span {
                        (title)
                        img src={ (tiles.target) "_" (key) "_" (samples) ".png" } alt={ (tiles.target) ", " (title) ", " (samples) " sample" (plural) } width=(width) height=(width) loading="lazy";
                    } }
                }
                figcaption { (alt) " " (self.how(how)) }
            } });
        }
    }

    /// Shows two of the pictures in turns.
    pub fn flip(&mut self, targets: &[(&str, &str)], tiles: &Tiles) {
        let choose = |name: &str, options: Vec<(String, String)>| html! { label { (name) " " select { @for (value, text) in &options { option value=(value) { (text) } } } } };
        let whats = targets
            .iter()
            .map(|(key, title)| ((*key).to_owned(), (*title).to_owned()));
        let counts = tiles.samples.iter().map(|n| (n.to_string(), n.to_string()));
        let width = tiles.width;
        let first = tiles.patterns.first().map_or("", |p| p.0.as_str());
        let samples = tiles.samples.first().map_or(1, |n| *n);
        self.add(html! { div class="flip" {
            h3 { "Flip between two patterns" }
            p { (choose("picture", whats.collect())) (choose("samples", counts.collect())) (choose("A", tiles.patterns.to_vec())) (choose("B", tiles.patterns.to_vec())) }
            p { button type="button" { "flip (key F)" } " " output aria-live="polite" {} }
            img src={ (tiles.target) "_" (first) "_" (samples) ".png" } alt="" width=(width) height=(width);
        } });
    }

    /// Shows the table, and writes it as CSV.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn table(&mut self, name: &str, how: &str, rows: &[Row]) -> Drawn {
        self.write(name, "csv", table::csv(rows).as_bytes())?;
        let heading = |text: &str| html! { th scope="col" aria-sort="none" { button type="button" { (text) } } };
        self.add(html! { div {
            div class="scroll" { table {
                thead { tr { (heading("pattern")) @for column in &COLUMNS { (heading(column.1)) } th scope="col" { "what it does with five points" } } }
                tbody { @for row in rows { tr {
                    td { (row.title) }
                    @for (text, v) in row.texts().zip(&row.numbers) { td data-value=(v.map_or_else(String::new, |v| v.to_string())) { (text) } }
                    td { (row.five) }
                } } }
            } }
            p { "A click on a heading sorts by its column. " (self.how(how)) " " a href={ (name) ".csv" } { "CSV" } }
        } });
        self.add(html! { div {
            dl { @for (_, heading, meaning, _) in &COLUMNS { dt { (heading) } dd { (meaning) "." } } }
        } });
        Ok(())
    }

    /// Writes the page itself, after all its pictures, and returns its path.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn finish(mut self) -> Result<PathBuf, Box<dyn Error>> {
        self.wait()?;
        let body = html! {
            style { (PreEscaped(STYLE)) }
            section class="screen" {
                h1 { "The sampling lab" }
                p { "Patterns that place samples in a pixel, and what can be measured of these patterns. Everything here was \
                    drawn and measured on this machine, by the command " code { (self.command) } "." }
                @if self.shows_a_choice { p { "These are some of the patterns that the lab knows: " code { "raybook samplers --patterns all" } " \
                    shows all of them, and " code { "--patterns random,halton" } " those that you name." } }
                @if !self.remarks.is_empty() { ul { @for remark in &self.remarks { li { (remark) } } } }
            }
            @for (title, text, parts) in &self.sections {
                @if self.slides {
                    section class="screen" { h2 { (title) } (text) }
                    @for part in parts { section class="screen" { div class="figures" { (part) } } }
                } @else {
                    section class="screen" { h2 { (title) } (text) div class="figures" { @for part in parts { (part) } } }
                }
            }
            script { (PreEscaped(SCRIPT)) }
        };
        let page = page("raybook: the sampling lab", &body);
        let page = if self.slides {
            page.replacen("<body>", "<body class=\"slides\">", 1)
        } else {
            page
        };
        let path = self.folder.join("index.html");
        store::write(&path, page.as_bytes())?;
        Ok(path)
    }

    fn add(&mut self, part: Markup) {
        if let Some((_, _, parts)) = self.sections.last_mut() {
            parts.push(part);
        }
    }

    fn write(&self, name: &str, extension: &str, bytes: &[u8]) -> Drawn {
        let path = self.folder.join(format!("{name}.{extension}"));
        Ok(store::write(&path, bytes)?)
    }
}
