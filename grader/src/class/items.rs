//! Item analysis: which exercises and cases the class fails, and which mistakes it makes.

use super::grades::Grade;
use super::record::Standing;
use std::collections::BTreeMap;

/// An exercise in the hands of a class. Each student counts, also those who handed in the same.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Item {
    /// The exercise.
    pub exercise: String,
    /// Students by how their exercise stands.
    pub standing: BTreeMap<&'static str, usize>,
    /// Students who were right on the visible cases only.
    pub visible_only: usize,
    /// Students who took the reference.
    pub taken: usize,
    /// The wrong cases and how many students have them wrong, the most frequent first.
    pub cases: Vec<(String, usize)>,
    /// The mistakes and how many students make them, the most frequent first.
    pub mistakes: Vec<(String, usize)>,
}

impl Item {
    /// Students whose exercise stands like this.
    pub fn count(&self, standing: Standing) -> usize {
        self.standing.get(standing.name()).copied().unwrap_or(0)
    }
}

/// The items of a class, in the order of the course.
pub fn items(grades: &[Grade]) -> Vec<Item> {
    let Some(first) = grades.first() else {
        return Vec::new();
    };
    let names = first.exercises().map(|exercise| exercise.counted.name);
    names.map(|name| item(name, grades)).collect()
}

fn item(name: &str, grades: &[Grade]) -> Item {
    let mut item = Item {
        exercise: name.to_owned(),
        ..Item::default()
    };
    let (mut cases, mut mistakes) = (BTreeMap::new(), BTreeMap::new());
    let of_name = grades
        .iter()
        .flat_map(Grade::exercises)
        .filter(|exercise| exercise.counted.name == name);
    for exercise in of_name {
        item.taken += usize::from(exercise.taken);
        let Some(result) = &exercise.result else {
            continue;
        };
        *item.standing.entry(result.standing.name()).or_default() += 1;
        item.visible_only += usize::from(result.right_on_visible_only());
        if result.standing == Standing::Wrong {
            for case in &result.wrong {
                *cases.entry(case.clone()).or_default() += 1;
            }
            if let Some([mistake, _]) = &result.mistake {
                *mistakes.entry(mistake.clone()).or_default() += 1;
            }
        }
    }
    item.cases = most_first(cases);
    item.mistakes = most_first(mistakes);
    item
}

fn most_first(counts: BTreeMap<String, usize>) -> Vec<(String, usize)> {
    let mut counts: Vec<_> = counts.into_iter().collect();
    counts.sort_by(|(a, m), (b, n)| n.cmp(m).then_with(|| a.cmp(b)));
    counts
}
