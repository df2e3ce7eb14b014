//! Chapter 18: a direction's place on a cube map and on a latitude-longitude map, and directions chosen by the light of one.

mod cube;
mod latlong;
mod map;
mod pdf;
mod sampled;
