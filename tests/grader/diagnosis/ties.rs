//! Answers that rounding decides, beside many that a mistake explains.

use super::function::diagnosed;
use raybook_grader::cases;

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
