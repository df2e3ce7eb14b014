#!/bin/sh
# After all parts: merges their journals, grades what no part could, and writes the grades.
#SBATCH --job-name=raybook-merge
#SBATCH --open-mode=append
set -e
mkdir -p @OUT
cd @OUT
touch run.jsonl
# A journal is a set of lines: their order means nothing, and a line that is there twice says nothing more.
LC_ALL=C sort -u run.jsonl part-*/run.jsonl > run.jsonl.merged
mv run.jsonl.merged run.jsonl
exec @RAYBOOK grade @HAND_INS --course @COURSE --key-file @KEY --out @OUT --jobs "${SLURM_CPUS_PER_TASK:-1}"
