//! Pictures made of a student's answers.
//!
//! An exercise of pixels is asked a question for each of them: all in a check (`ask`), coarse first where somebody watches
//! (`progressive`). The answers make a picture, which stands beside the right one and the difference (`triple`); a picture of a whole
//! scene has points by rays and by image (`score`), and a check tells of it in words (`words`).

pub mod ask;
pub mod progressive;
pub mod score;
pub mod triple;
pub mod words;
