//! Rooms, scenes and figures that a few chapters share.

pub mod daylight;
pub mod directions;
pub mod flatland;
pub mod growth;
pub mod heat;
pub mod law;
pub mod outdoors;
pub mod own_mesh;
pub mod ray_tree;
pub mod ray_tree_figure;
pub mod showroom;
pub mod speeds;
pub mod stadium_figure;
pub mod stock_picture;
