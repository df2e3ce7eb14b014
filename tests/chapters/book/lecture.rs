//! The table from the lecture's topics to the lessons: each topic has a place in a lesson, and a figure or an exercise. That the places exist is
//! tested with all other links.

use super::links::links;
use super::page;
use raybook_workbook::curriculum::CHAPTERS;

/// Minimum number of topics of a lecture on ray tracing.
const TOPICS: usize = 60;

#[test]
fn every_topic_of_the_lecture_has_a_lesson_and_a_figure_or_an_exercise() {
    let text = page("lecture.md");
    let rows = text.lines().filter_map(|line| line.strip_prefix("| "));
    let rows: Vec<Vec<_>> = rows.map(|row| row.split(" | ").collect()).skip(1).collect();
    assert!(rows.len() >= TOPICS, "{} topics", rows.len());
    for row in &rows {
        let [topic, lesson, shown] = row[..] else {
            panic!("book/src/lecture.md: a row has three parts: {row:?}");
        };
        assert!(
            links(lesson).iter().any(|link| link.contains('#')),
            "“{topic}” needs the place in its lesson: {lesson}"
        );
        let is_shown = |link: &String| {
            let place = link.split_once('#').map_or("", |(_, place)| place);
            place.starts_with("figure-") || place.starts_with("turn-") || link.starts_with("why.md")
        };
        let shown = links(shown);
        assert!(
            !shown.is_empty() && shown.iter().all(is_shown),
            "“{topic}” needs a figure or an exercise: {shown:?}"
        );
    }
    for chapter in CHAPTERS {
        assert!(
            text.contains(&format!("]({}.md", chapter.name)),
            "book/src/lecture.md needs a row that leads to {}.md",
            chapter.name
        );
    }
}
