#include "tools/sweep/sweep_options.hpp"

#include <algorithm>
#include <thread>

#include <sched.h>

#include "programs/usage.hpp"
#include "scene/study/study.hpp"
#include "tools/common/gnuplot.hpp"

namespace rigid_body_sim {
namespace {

/// The cores that this process may use: of those of the machine, the ones that taskset or a job's
/// launcher left to it.
int usualThreads() {
  cpu_set_t cores;
  if (sched_getaffinity(0, sizeof cores, &cores) == 0) return CPU_COUNT(&cores);
  // a machine of more cores than the set can hold
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

SweepOptions parseMerge(int argc, char** argv) {
  SweepOptions options;
  const OptionActions actions{
      {"out", [&](const char* s) { options.out = pictureDirectory("--out", s); }}};
  const auto directories =
      readCommandLine(argc, argv, actions, "at least one directory is", kAtLeastOne, {});
  options.help = !directories;
  options.merge = directories.value_or(std::vector<std::string>());
  for (const std::string& directory : options.merge)
    pictureDirectory("a directory to merge", directory);
  return options;
}

}  // namespace

SweepOptions parseSweepOptions(int argc, char** argv, const Environment& environment) {
  if (argc > 1 && std::string(argv[1]) == "merge") return parseMerge(argc - 1, argv + 1);
  constexpr int kMaxThreads = 1024;
  SweepOptions options;
  options.threads = usualThreads();
  std::optional<Shard> shard;
  const OptionActions actions{
      {"runs",
       [&](const char* s) {
         options.runs = std::int64_t(wholeNumber("runs", s, 1, kMaxSweepRuns));
       }},
      {"seed", [&](const char* s) { options.seed = wholeNumber("seed", s, 0, UINT64_MAX); }},
      {"run",
       [&](const char* s) {
         options.run = std::int64_t(wholeNumber("run", s, 0, kMaxSweepRuns - 1));
       }},
      {"threads",
       [&](const char* s) { options.threads = int(wholeNumber("threads", s, 1, kMaxThreads)); }},
      {"shard", [&](const char* s) { shard = parseShard(s); }},
      {"out", [&](const char* s) { options.out = pictureDirectory("--out", s); }}};
  const auto files = readCommandLine(argc, argv, actions, "a scene file and a study file are", 2,
                                     {{"resume", &options.resume}});
  options.help = !files;
  if (options.help) return options;
  options.scene = files->front();
  options.study = files->back();
  if (shard)
    options.launched = {*shard, ""};
  else if (!options.run)
    options.launched = launchedShard(environment);
  return options;
}

std::string sweepHelp() {
  return R"(usage: sweep SCENE STUDY [options]
       sweep merge DIR ... [--out DIR]
       sweep --run K SCENE STUDY [options]
Runs a scene many times, its values varied as the study says: what happens where masses, pushes and
motors are not known exactly. Writes a row per run, a summary of the distributions, and a plot.
doc/sweep.md explains the keys of a study and has a job file for each launcher.

  --runs N      in place of the study's, without its grids
  --seed S      in place of the study's
  --threads T   default: the cores that this process may use
  --shard I/N   every N-th run from the I-th on; default: what Slurm's job arrays, srun, mpirun, or
                GNU parallel (with RIGID_BODY_SIM_SHARDS=N) have set, else all runs. The same
                variable repeats tasks of an array: each then is the shard of its number
  --out DIR     where the results go, made if absent; default: here, or of merge the first DIR
  --resume      goes on after the last row of an interrupted sweep; without it such a table is
                refused, and a finished one replaced
  --run K       writes the scene of run K as run_K.yaml, and runs nothing
  --help        this text

Files: runs.csv with a row per run: its number, every varied value, the end state of every body that
moves, what is recorded, the estimated errors [rad], [m], and its status: done, or why not. summary.csv:
mean, standard deviation, percentiles, correlations. sweep.svg: distributions, scatter, fan; needs
gnuplot. A shard writes runs.2of4.csv; `sweep merge` makes the whole of the shards, byte for byte.
A value depends on seed, number of the run and path alone: threads and shards change nothing.
Exit status: 0 done, 1 the input is at fault, 2 wrong usage. A run that diverges is a row.
)";
}

}  // namespace rigid_body_sim
