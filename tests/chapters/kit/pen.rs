//! Pens, and the dashes of their lines.

use raybook_chapters::kit::figure::figure;
use raybook_chapters::kit::palette::BLUE;
use raybook_chapters::kit::pen::Pen;

#[test]
fn a_dashed_line_is_on_and_off_in_turns_also_around_corners() {
    let pen = Pen {
        dash: &[4.0, 2.0],
        ..Pen::plain((&BLUE).into())
    };
    let line = figure(20, 20, |canvas| {
        pen.line(canvas, &[(0, 0), (10, 0), (10, 10)])
    });
    let svg = line.expect("it is drawn").svg;
    let pieces = svg.split(" d=\"M").skip(1);
    let pieces: Vec<_> = pieces.filter_map(|rest| rest.split('"').next()).collect();
    let expected = ["0,0l4,0", "6,0l4,0", "10,2l0,4", "10,8l0,2"];
    assert_eq!(pieces, expected, "four pixels on, two off");
}
