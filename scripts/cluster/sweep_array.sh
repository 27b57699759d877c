#!/bin/bash
#SBATCH --job-name=sweep
#SBATCH --array=1-4
#SBATCH --cpus-per-task=1
#SBATCH --open-mode=append --requeue
#SBATCH --output=%x-%a.log
# One shard of a sweep for each task of the array. A task that is requeued goes on where it was.
# usage: sbatch scripts/cluster/sweep_array.sh SCENE STUDY DIRECTORY [OPTION ...]
exec "${SWEEP:-sweep}" "$1" "$2" --out "$3" --resume --threads "${SLURM_CPUS_PER_TASK:-1}" "${@:4}"
