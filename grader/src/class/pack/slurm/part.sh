#!/bin/sh
# A part of the class, a task of the array. A task that is started again goes on where its journal ends.
#SBATCH --job-name=raybook-grade
#SBATCH --array=1-@PARTS
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
exec @RAYBOOK grade @HAND_INS --course @COURSE --key-file @KEY \
    --out @OUT/"part-$SLURM_ARRAY_TASK_ID" --shard "$SLURM_ARRAY_TASK_ID/@PARTS" --jobs "${SLURM_CPUS_PER_TASK:-1}"
