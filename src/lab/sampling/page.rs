//! The lab's page: every figure with its files, and the table.

use crate::image::{Image, file};
use crate::lab::sampling::plot::{Drawn, Plot};
use crate::lab::sampling::table::{self, Row};
use maud::{DOCTYPE, Markup, PreEscaped, html};
use std::error::Error;
use std::path::{Path, PathBuf};

const STYLE: &str = "
body { font: 17px/1.5 system-ui, sans-serif; max-width: 1240px; margin: 2rem auto; padding: 0 1rem; color: #222; background: #fff }
section { margin-top: 3rem; border-top: 1px solid #ccc }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(480px, 100%), 1fr)); gap: 1.5rem }
figure { margin: 0 } img { max-width: 100%; height: auto; background: #fff } figcaption { color: #444; font-size: 15px }
table { border-collapse: collapse } th, td { padding: .2em .9em; border-bottom: 1px solid #ddd; text-align: right }
th:first-child, td:first-child { text-align: left }
@media (prefers-color-scheme: dark) { body { color: #ddd; background: #1b1b1b } figcaption { color: #bbb } a { color: #8bf } }";

/// A page that grows section by section, and the folder of its files.
pub struct Page {
    folder: PathBuf,
    remarks: Vec<String>,
    sections: Vec<(&'static str, &'static str, Vec<Markup>)>,
}

impl Page {
    /// A page in a folder, with remarks at its beginning.
    pub fn new(folder: &Path, remarks: Vec<String>) -> Self {
        Self {
            folder: folder.to_owned(),
            remarks,
            sections: Vec::new(),
        }
    }

    /// Begins a section: its title, and what to see in it.
    pub fn section(&mut self, title: &'static str, text: &'static str) {
        self.sections.push((title, text, Vec::new()));
    }

    /// Writes a plot as PNG, SVG and CSV, and shows it.
    ///
    /// # Errors
    /// If it cannot be drawn or written.
    pub fn plot(&mut self, name: &str, alt: &str, plot: &impl Plot) -> Drawn {
        file::save(
            &self.folder.join(name).with_extension("png"),
            &plot.image()?,
        )?;
        self.write(name, "svg", plot.svg()?.as_bytes())?;
        self.write(name, "csv", plot.csv().as_bytes())?;
        self.add(html! { figure {
            img src={ (name) ".svg" } alt=(alt) loading="lazy";
            figcaption { (alt) " " a href={ (name) ".png" } { "PNG" } " · " a href={ (name) ".svg" } { "SVG" } " · " a href={ (name) ".csv" } { "CSV" } }
        } });
        Ok(())
    }

    /// Writes a picture, and shows it.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn picture(&mut self, name: &str, alt: &str, picture: &Image) -> Drawn {
        file::save(&self.folder.join(name).with_extension("png"), picture)?;
        self.add(html! { figure {
            a href={ (name) ".png" } { img src={ (name) ".png" } alt=(alt) loading="lazy"; }
            figcaption { (alt) }
        } });
        Ok(())
    }

    /// Shows the table, and writes it as CSV.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn table(&mut self, name: &str, rows: &[Row]) -> Drawn {
        self.write(name, "csv", table::csv(rows).as_bytes())?;
        self.add(html! {
            table {
                thead { tr { th { "pattern" } th { "star discrepancy" } th { "L₂ star discrepancy" }
                    th { "least distance, of the largest possible" } th { "ns a point" } th { "what it does with five points" } } }
                tbody { @for row in rows { tr {
                    td { (row.title) } td { (format!("{:.4}", row.star)) } td { (format!("{:.5}", row.l2_star)) }
                    td { (format!("{:.2}", row.distance)) } td { (row.nanoseconds.map_or_else(|| "–".to_owned(), |ns| format!("{ns:.0}"))) } td { (row.five) }
                } } }
            }
            p { a href={ (name) ".csv" } { "CSV" } }
        });
        Ok(())
    }

    /// Writes the page itself, and returns its path.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn finish(self) -> Result<PathBuf, Box<dyn Error>> {
        let page = html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    meta charset="utf-8";
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    title { "raybook: the sampling lab" }
                    style { (PreEscaped(STYLE)) }
                }
                body {
                    h1 { "The sampling lab" }
                    p { "Patterns that place samples in a pixel, and what can be measured of them. Everything here was drawn and measured on this machine." }
                    @if !self.remarks.is_empty() { ul { @for remark in &self.remarks { li { (remark) } } } }
                    @for (title, text, parts) in &self.sections {
                        section { h2 { (title) } p { (text) } div class="figures" { @for part in parts { (part) } } }
                    }
                }
            }
        };
        let path = self.folder.join("index.html");
        file::write_whole(&path, page.into_string().as_bytes())?;
        Ok(path)
    }

    fn add(&mut self, part: Markup) {
        if let Some((_, _, parts)) = self.sections.last_mut() {
            parts.push(part);
        }
    }

    fn write(&self, name: &str, extension: &str, bytes: &[u8]) -> Drawn {
        let path = self.folder.join(name).with_extension(extension);
        Ok(file::write_whole(&path, bytes)?)
    }
}
