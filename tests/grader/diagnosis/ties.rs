//! Answers that rounding decides, beside many that a mistake explains.

use super::function::diagnosed;
use raybook_grader::cases;
use raybook_grader::diagnose::ties::beside;
use raybook_grader::examine::visible_rng;

#[test]
fn an_answer_that_rounding_decides_is_a_mistakes_as_well() {
    let grid = cases::find("grid_resolution").expect("the exercise exists");
    let floors = grid
        .mistake_called("rounds down")
        .expect("it is one of its mistakes");
    let found = diagnosed("grid_resolution", |q| {
        let mut next_to = q.to_vec();
        next_to[4] *= 1.0 - 1e-6; // a hair less dense: 20 cells are 19.99…
        grid.mistake_answers(floors, &next_to)
    });
    assert_eq!(found.name, "rounds down");
    assert_eq!((found.certain, found.explained), (true, found.wrong));
}

#[test]
fn a_walk_that_touches_other_cells_is_a_mistakes_as_well() {
    let walks = [
        (
            "two_level_walk",
            "takes the cells along z first, the coarse ones and the fine ones",
        ),
        (
            "octree_walk",
            "returns the leaves in the order of their numbers",
        ),
    ];
    for (name, mistake) in walks {
        let walk = cases::find(name).expect("the exercise exists");
        let number = walk
            .mistake_called(mistake)
            .expect("it is one of its mistakes");
        let found = diagnosed(name, |q| {
            let rng = &mut visible_rng(&format!("{q:?}"));
            walk.mistake_answers(number, &beside(walk, q, 0.5, rng))
        });
        assert_eq!(found.name, mistake);
        assert_eq!(
            (found.certain, found.explained),
            (true, found.wrong),
            "{name}"
        );
    }
}
