//! The frame of every page that is written: its head, its style, and its figures.

use maud::{DOCTYPE, Markup, PreEscaped, html};

const STYLE: &str = "
:root { color-scheme: light dark }
body { font: 17px/1.5 system-ui, sans-serif; max-width: 1240px; margin: 2rem auto; padding: 0 1rem; color: #222; background: #fff; overflow-wrap: break-word }
h1 { margin-bottom: 0 } section { margin-top: 3rem; border-top: 1px solid #ccc }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(480px, 100%), 1fr)); gap: 1.5rem }
figure { margin: 0; min-width: 0 } img { width: 100%; height: auto; background: #fff } figcaption { color: #444; font-size: 15px }
.unscaled { grid-column: 1 / -1 } .unscaled a { display: block; overflow-x: auto } .unscaled img { width: auto; image-rendering: pixelated }
table { border-collapse: collapse } th, td { padding: .2em .9em; border-bottom: 1px solid #ddd; text-align: right }
th:first-child, td:first-child { text-align: left } .scroll { overflow-x: auto; max-width: 100% }
code { background: #f0f0f0; padding: .1em .3em; border-radius: 3px; overflow-wrap: anywhere }
nav { display: flex; flex-wrap: wrap; gap: .1em 1.2em } nav a { padding: .25em 0 }
nav ol { columns: 3 17em; margin: 0; padding: 0; list-style: none; width: 100% } nav li { break-inside: avoid; padding: .15em 0 }
[role=alert] { border-left: 4px solid #d55e00; padding-left: 1rem } [role=alert] pre { white-space: pre-wrap } pre { overflow-x: auto }
.pictures { border: 1px solid #ccc; margin: 1rem 0; min-width: 0; padding: .5rem 1rem } .pictures label { margin-right: 1.2em; white-space: nowrap }
.row { display: flex; gap: .7rem; flex-wrap: wrap } .row figure { flex: 1 1 200px; max-width: 760px }
.picture { display: block; position: relative } .picture img { image-rendering: pixelated; display: block } .slider, .picture img + img { display: none }
.picture i { position: absolute; box-sizing: content-box; min-width: 5px; min-height: 5px; outline: 2px solid #fff; box-shadow: 0 0 0 4px #000; pointer-events: none }
.pictures:has([value=yours]:checked) .row figure:not(.yours), .pictures:has([value=right]:checked) .row figure:not(.right),
.pictures:has([value=difference]:checked) .row figure:not(.difference), .pictures:has([value=slider]:checked) .row figure:not(.slider) { display: none }
.pictures:has([value=slider]:checked) .slider, .slider .picture img + img { display: block }
.slider img + img { position: absolute; inset: 0; clip-path: inset(0 0 0 var(--cut, 50%)) } .slider input { width: 100% } .pictures input[type=number] { width: 4.5em }
:focus-visible { outline: 3px solid #e69f00; outline-offset: 3px }
@media (prefers-color-scheme: dark) { body { color: #ddd; background: #1b1b1b } figcaption { color: #bbb } code { background: #333 } a { color: #8bf } }";

/// A whole page.
pub fn page(title: &str, body: &Markup) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                link rel="icon" href="data:,"; // or a browser asks for one
                title { (title) }
                style { (PreEscaped(STYLE)) }
            }
            body { (body) }
        }
    };
    page.into_string()
}

/// A table. If it is wider than the window, it can be scrolled, by keys too.
pub fn table(label: &str, rows: &Markup) -> Markup {
    html! { div class="scroll" tabindex="0" role="region" aria-label=(label) { table { (rows) } } }
}

/// A picture that is also a link to the picture alone, and below it the caption.
pub fn figure(file: &str, alt: &str, caption: &Markup) -> Markup {
    html! { figure {
        a href=(file) { img src=(file) alt=(alt) loading="lazy"; }
        figcaption { (caption) }
    } }
}
