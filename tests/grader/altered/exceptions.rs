//! Where an altered answer is as right as before.

/// An alteration after which answers may be right, and why.
pub struct Exception {
    /// The exercise.
    pub exercise: &'static str,
    /// How much of the answer is altered, `a word`, `a column` or `all`; how; and how many altered answers of a hundred may be right.
    pub altered: &'static [(&'static str, &'static str, usize)],
    /// Why they are.
    pub why: &'static str,
}

/// All exceptions. NaN and infinities are in none.
pub const EXCEPTIONS: &[Exception] = &[
    Exception {
        exercise: "mesh_hit",
        altered: &[("a word", "10 % more", 3)],
        why: "of two triangles at the same distance either is the nearest",
    },
    Exception {
        exercise: "grid_walk",
        altered: &[
            ("a word", "0", 2),
            ("a word", "10 % more", 1),
            ("a column", "0", 1),
        ],
        why: "where cells meet in a plane, an edge or a corner, the ray may be said to touch any of them",
    },
    Exception {
        exercise: "two_level_walk",
        altered: &[
            ("a word", "0", 3),
            ("a word", "10 % more", 2),
            ("a word", "left out", 1),
        ],
        why: "in a plane between two cells either is right, and an empty one is not visited",
    },
    Exception {
        exercise: "octree_build",
        altered: &[("a word", "0", 2), ("a word", "10 % more", 15)],
        why: "where the names of an empty leaf begin means nothing; and a leaf may use the place in the list where another leaf names the same shapes",
    },
    Exception {
        exercise: "sah_split",
        altered: &[("a word", "10 % more", 1)],
        why: "of equal boxes any may be on the left",
    },
    Exception {
        exercise: "bvh_closest",
        altered: &[("a word", "10 % more", 69), ("a word", "0", 2)],
        why: "another order of the children may need half as many tests again, and who asks the root's box first needs none beside it",
    },
    Exception {
        exercise: "wide_closest",
        altered: &[("a word", "10 % more", 62), ("a word", "0", 3)],
        why: "another order of the children may need a quarter more tests, and who asks the root's box first needs none beside it, nor just where the interval ends",
    },
    Exception {
        exercise: "shadow_ray",
        altered: &[("a word", "10 % more", 10), ("a word", "1e38", 2)],
        why: "the ray may start anywhere off the surface that is five error bounds away at most; and 1e38 m is as far as a light at infinity",
    },
    Exception {
        exercise: "sample_rect",
        altered: &[
            ("a word", "0", 1),
            ("a word", "10 % more", 4),
            ("a word", "negative", 4),
            ("a column", "negative", 2),
        ],
        why: "any point of the light is right, such as the mirror image of one, if they are evenly spread",
    },
    Exception {
        exercise: "sample_sphere_light",
        altered: &[
            ("a word", "10 % more", 1),
            ("a word", "negative", 5),
            ("a column", "negative", 5),
        ],
        why: "any direction to the light is right, such as the mirror image of one, if they are evenly spread",
    },
    Exception {
        exercise: "visible_fraction",
        altered: &[
            ("a word", "0", 5),
            ("a word", "10 % more", 49),
            ("a column", "10 % more", 36),
            ("all", "10 % more", 65),
        ],
        why: "an estimate by 1024 samples may be off by 0.02 to 0.12",
    },
    Exception {
        exercise: "cosine_hemisphere",
        altered: &[
            ("a word", "0", 4),
            ("a word", "10 % more", 8),
            ("a word", "negative", 68),
            ("a column", "negative", 15),
        ],
        why: "any direction is right as long as all are distributed by the cosine, such as the mirror image of one, or of all in a plane through the normal",
    },
    Exception {
        exercise: "direction_to_latlong",
        altered: &[
            ("a word", "0", 3),
            ("a word", "10 % more", 5),
            ("all", "0", 5),
            ("all", "10 % more", 5),
        ],
        why: "at a pole all u are the same place",
    },
    Exception {
        exercise: "sample_environment",
        altered: &[
            ("a word", "0", 5),
            ("a word", "10 % more", 10),
            ("a word", "negative", 91),
            ("a column", "negative", 20),
            ("all", "negative", 8),
        ],
        why: "any direction is right as long as 256 together are distributed as the light of the map, which may be symmetric; ten may be astray",
    },
    Exception {
        exercise: "concentric_disk",
        altered: &[
            ("a word", "0", 100),
            ("a word", "10 % more", 91),
            ("a word", "negative", 100),
            ("a column", "10 % more", 3),
            ("a column", "negative", 100),
            ("all", "10 % more", 3),
            ("all", "negative", 100),
        ],
        why: "any map of equal areas is right, such as a mirrored one; one point of 200 is not missed, and four points tell little",
    },
    Exception {
        exercise: "geodesic_step",
        altered: &[("a word", "10 % more", 2)],
        why: "the bend may be off by a tenth: any method that is good enough is right",
    },
    Exception {
        exercise: "random_pattern",
        altered: &[
            ("a word", "0", 100),
            ("a word", "10 % more", 91),
            ("all", "0", 3),
        ],
        why: "a random point is anywhere, and an only one in the corner too",
    },
    Exception {
        exercise: "jittered",
        altered: &[
            ("a word", "0", 13),
            ("a word", "10 % more", 42),
            ("a column", "10 % more", 3),
            ("all", "0", 3),
            ("all", "10 % more", 5),
        ],
        why: "a point is anywhere in its cell, and an only one in the corner too",
    },
    Exception {
        exercise: "poisson_disk",
        altered: &[
            ("a word", "0", 16),
            ("a word", "10 % more", 31),
            ("a column", "0", 2),
            ("a column", "10 % more", 2),
            ("all", "0", 3),
        ],
        why: "any points are right that keep their distance and leave no room; where there is room for one, it is anywhere",
    },
    Exception {
        exercise: "trace",
        altered: &[
            ("a word", "0", 1),
            ("a word", "10 % more", 10),
            ("all", "10 % more", 4),
        ],
        why: "a radiance may be off by 0.005 and 1 %, for rays that count for little may be left out",
    },
];
