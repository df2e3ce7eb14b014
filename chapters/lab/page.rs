//! The lab's page: every figure with its files, and the table.

use crate::kit::html::{figure, page};
use crate::kit::stage::Drawn;
use crate::lab::plot::Plot;
use crate::lab::table;
use crate::lab::table::Row;
use maud::{Markup, html};
use raybook::image::{Image, file};
use raybook::store;
use std::error::Error;
use std::path::{Path, PathBuf};

/// A page that grows section by section, and the folder of its files.
#[derive(Debug)]
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
        let link = |extension: &str, name_of_it| html! { a href={ (name) "." (extension) } { (name_of_it) } };
        let caption = html! { (alt) " " (link("png", "PNG")) " · " (link("svg", "SVG")) " · " (link("csv", "CSV")) };
        self.add(figure(&format!("{name}.svg"), alt, &caption));
        Ok(())
    }

    /// Writes a picture, and shows it.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn picture(&mut self, name: &str, alt: &str, picture: &Image) -> Drawn {
        file::save(&self.folder.join(name).with_extension("png"), picture)?;
        self.add(figure(&format!("{name}.png"), alt, &html! { (alt) }));
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
                    th { "least distance between two points, as a share of the largest that so many can have" } th { "ns a point" } th { "what it does with five points" } } }
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
        let body = html! {
            h1 { "The sampling lab" }
            p { "Patterns that place samples in a pixel, and what can be measured of them. Everything here was drawn and measured on this machine." }
            @if !self.remarks.is_empty() { ul { @for remark in &self.remarks { li { (remark) } } } }
            @for (title, text, parts) in &self.sections {
                section { h2 { (title) } p { (text) } div class="figures" { @for part in parts { (part) } } }
            }
        };
        let page = page("raybook: the sampling lab", &body);
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
        let path = self.folder.join(name).with_extension(extension);
        Ok(store::write(&path, bytes)?)
    }
}
