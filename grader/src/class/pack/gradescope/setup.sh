#!/bin/sh
# Gradescope runs this once, when it builds the container: what hand-ins in Python and C++ need. For Rust, add rustup and, as the user
# that grades, `raybook new` and `raybook check` of a workbook, which download its packages.
set -e
apt-get update
apt-get install -y --no-install-recommends python3 g++
