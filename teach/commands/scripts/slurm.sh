#!/bin/bash
# SPDX-License-Identifier: MIT
# A class on a Slurm cluster whose machines draw the same pictures: sbatch --array=1-16 slurm.sh CLASS OUT LABS SEED_FILE
# Each task grades its part into OUT/partN. A task that was killed and is requeued continues its part.
#SBATCH --cpus-per-task=4
#SBATCH --requeue
texel=${TEXEL:-build/release/bin/texel}
exec "$texel" grade "$1" --out "$2/part$SLURM_ARRAY_TASK_ID" --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" \
  --labs "$3" --seed-file "$4" --cache "${TEXEL_CACHE:-/tmp/texel-grade}" --jobs "$SLURM_CPUS_PER_TASK" --resume
