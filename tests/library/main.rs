//! What must be true of the library.

mod agreement;
mod aim;
mod aimed;
mod bounded;
mod ch01_rays;
mod ch02_hdr;
mod ch03_sphere;
mod ch04_plane;
mod ch05_box;
mod ch07_attributes;
mod ch07_files;
mod ch07_list;
mod ch07_mesh;
mod ch07_obj_peer;
mod ch07_ply;
mod ch07_stl;
mod ch07_teapot;
mod ch07_teapot_surface;
mod ch07_watertight;
mod ch12_phong;
mod ch15_shadows;
mod ch17_rendering_equation;
mod ch19_depth_of_field;
mod ch24_wide_bvh;
mod denoise;
mod domain;
mod embree_recorded;
mod even;
mod examples;
mod guides;
mod laws;
mod neighbours;
mod noise;
mod padded;
mod plastic;
mod published;
mod scaling;
mod sobol;
mod soundness;
mod store;
mod textures;
mod where_is_what;

#[global_allocator]
static COUNTING: raybook_common::counting::Counting = raybook_common::counting::Counting;
