//! A dark room with a bright window: radiances over five orders of magnitude.
