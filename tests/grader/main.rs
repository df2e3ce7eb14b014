//! What must be true of the workbook, the grader and the command.

mod alternatives;
mod ask;
mod bless;
mod ch25_capstone;
mod common;
mod exercise;
mod feedback;
mod first_hour;
mod golden_answers;
mod grade;
mod interrupt;
mod own_patterns;
mod readers;
mod rows;
mod samplers;
mod silly;
mod starter;
mod tour;
mod usage;
