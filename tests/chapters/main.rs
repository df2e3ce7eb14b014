//! What must be true of the chapters and their pictures.

mod architecture;
mod book;
mod ch02_hdr;
mod ch06_triangle;
mod ch07_obj;
mod ch08_grid;
mod ch09_two_level_grid;
mod ch10_octree;
mod ch11_bvh;
mod ch13_reflection;
mod ch14_refraction;
mod ch16_soft_shadows;
mod ch18_environment;
mod ch20_panorama;
mod ch21_black_hole;
mod ch22_antialiasing;
mod ch23_adaptive;
mod chapters;
mod course;
mod golden;
mod habits;
mod kit;
mod knobs;
mod terminal;
