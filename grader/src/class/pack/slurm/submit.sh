#!/bin/sh
# Submits the array, and what comes after it: run this once. Words for `sbatch` may follow: ./submit.sh --partition=short
set -e
cd "$(dirname "$0")"
mkdir -p @OUT
parts=$(sbatch --parsable --output=@OUT/part-%a.log "$@" part.sh)
merge=$(sbatch --parsable --output=@OUT/merge.log --dependency="afterany:$parts" "$@" merge.sh)
echo "the parts are job $parts, and job $merge comes after them; look at" @OUT/index.html "when it is done"
