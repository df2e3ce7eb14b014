//! Which source files of a hand-in make which programs.

use super::files::Files;
use crate::examine::Examiner;
use crate::language::Language;
use raybook_workbook::curriculum;
use std::collections::BTreeMap;

/// Files of a hand-in that answer all exercises, in the order in which they are looked for.
const MAIN: [&str; 4] = ["answer", "answers", "main", "program"];

/// Which source files make which programs, and what these are asked: one program for everything, if a file is called like one or
/// it is the only one; or else a program for each exercise or chapter, by the file of this name. An exercise of the instructor's
/// own is in no workbook: a file of its name is a program apart.
pub(super) fn programs(
    language: Language,
    files: &Files,
    exercises: &[&'static dyn Examiner],
) -> Vec<(Vec<String>, Vec<&'static dyn Examiner>)> {
    let headers = ["h", "hh", "hpp"];
    let is_source = |path: &&String| {
        let ending = path.rsplit_once('.').map_or("", |(_, ending)| ending);
        language.endings().contains(&ending) && !headers.contains(&ending)
    };
    let sources: Vec<&String> = files.keys().filter(is_source).collect();
    let stem = |path: &String| {
        let file = path
            .rsplit_once('/')
            .map_or(path.as_str(), |(_, file)| file);
        file.rsplit_once('.')
            .map_or(file, |(stem, _)| stem)
            .to_owned()
    };
    let own = |path: &String| {
        let name = stem(path);
        let mut own = exercises.iter().filter(|of| super::is_own(of.name()));
        own.find(|examiner| examiner.name() == name).copied()
    };
    let apart = sources
        .iter()
        .filter_map(|path| Some((vec![(*path).clone()], vec![own(path)?])));
    let mut apart: Vec<(Vec<String>, Vec<&'static dyn Examiner>)> = apart.collect();
    let sources: Vec<&String> = sources
        .into_iter()
        .filter(|path| own(path).is_none())
        .collect();
    let is_apart = |name: &str| {
        apart
            .iter()
            .any(|(_, of)| of.iter().any(|of| of.name() == name))
    };
    let exercises: Vec<_> = exercises
        .iter()
        .copied()
        .filter(|of| !is_apart(of.name()))
        .collect();
    let called = |name: &str| sources.iter().copied().find(|path| stem(path) == name);
    let main = MAIN.iter().find_map(|name| called(name));
    let only = sources.first().copied().filter(|_| sources.len() == 1);
    let file_of = |examiner: &dyn Examiner| {
        let chapter = curriculum::of_exercise(examiner.name());
        let of_chapter = chapter.and_then(|chapter| called(chapter.name));
        called(examiner.name()).or(of_chapter)
    };
    let one_each = main.is_none()
        && only.is_none()
        && exercises
            .iter()
            .any(|examiner| file_of(*examiner).is_some());
    if !one_each {
        let sources: Vec<String> = match (language, main.or(only)) {
            (Language::Python, Some(main)) => vec![main.clone()],
            (Language::Python, None) => Vec::new(),
            _ => sources.into_iter().cloned().collect(),
        };
        apart.push((sources, exercises));
        return apart;
    }
    let mut programs: BTreeMap<Vec<String>, Vec<&'static dyn Examiner>> = BTreeMap::new();
    for examiner in exercises {
        let sources = file_of(examiner).into_iter().cloned().collect();
        programs.entry(sources).or_default().push(examiner);
    }
    apart.extend(programs);
    apart
}
