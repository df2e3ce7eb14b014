//! What wrong samples of a light have in common, by the complaints of their judges.

use crate::Flaw;

/// What is wrong where a judge complains of the number of samples.
pub(super) const COUNT: Flaw = Flaw {
    complaint: "samples, and should be",
    name: "makes another number of samples than n times n",
    hint: "How many samples are n along each of two sides?",
};

/// What is wrong where a judge complains of a direction's length.
pub(super) const LENGTH: Flaw = Flaw {
    complaint: "the direction has length",
    name: "returns directions whose length is not 1",
    hint: "How long must a direction be? And do the fields of your answer stand in the order of the task?",
};

/// What is wrong where a judge complains of the density.
pub(super) const DENSITY: Flaw = Flaw {
    complaint: "the density",
    name: "has the density wrong",
    hint: "The density per steradian of a direction: one over the solid angle, if all directions are equally likely; else the density per area, turned into one per solid angle by the distance and the cosine at the light.",
};

/// What is wrong where a judge complains of radiance over density.
pub(super) const RATIO: Flaw = Flaw {
    complaint: "radiance/density",
    name: "does not divide the radiance by the density that it returns",
    hint: "What does one sample stand for that is chosen half as often as another?",
};

/// What is wrong where a judge complains that samples are not uniform.
pub(super) const UNEVEN: Flaw = Flaw {
    complaint: "not uniform",
    name: "does not spread the samples evenly",
    hint: "Which places does a number from 0 to 1 choose, and how much of the light belongs to each? Are your numbers those of the lattice, or random ones?",
};
