#include "tools/sweep/shard.hpp"

#include <utility>

#include "programs/usage.hpp"
#include "scene/message_text.hpp"
#include "scene/study/study.hpp"

namespace rigid_body_sim {
namespace {

/// More shards than runs have nothing to do.
std::optional<std::int64_t> numberOf(std::string_view text) {
  const std::optional<std::uint64_t> number = wholeNumberIn(text, kMaxSweepRuns);
  return number ? std::optional(static_cast<std::int64_t>(*number)) : std::nullopt;
}

/// The two numbers of a shard with a text between.
std::optional<Shard> shardIn(std::string_view text, std::string_view between) {
  const std::size_t at = text.find(between);
  if (at == std::string_view::npos) return std::nullopt;
  const auto index = numberOf(text.substr(0, at));
  const auto count = numberOf(text.substr(at + between.size()));
  if (!index || !count || *index < 1 || *index > *count) return std::nullopt;
  return Shard{*index, *count};
}

/// The number in a variable that must be set since another is.
std::int64_t numberIn(const Environment& environment, const std::string& name,
                      const std::string& other) {
  const char* text = environment(name.c_str());
  const auto number = text ? numberOf(text) : std::nullopt;
  if (!number)
    throw UsageError("environment: " + name + " must be a whole number up to " +
                     std::to_string(kMaxSweepRuns) +
                     (name == other ? "" : ", since " + other + " is set") + ", got " +
                     (text ? "'" + printable(std::string(text)) + "'" : "nothing") +
                     "; or --shard I/N says which runs are made");
  return *number;
}

LaunchedShard checked(std::int64_t index, std::int64_t count, const std::string& by) {
  if (count < 1 || index < 1 || index > count)
    throw UsageError("environment: " + by + " makes this shard " + std::to_string(index) + " of " +
                     std::to_string(count) + "; --shard I/N says which it is");
  return {{index, count}, by};
}

constexpr const char* kShards = "RIGID_BODY_SIM_SHARDS";

LaunchedShard slurmShard(const Environment& environment) {
  const std::string array = "SLURM_ARRAY_TASK_", id_name = array + "ID";
  const auto number = [&](const std::string& name) { return numberIn(environment, name, id_name); };
  const std::int64_t id = number(id_name);
  // a part of an array, too, such as a task that is repeated
  if (environment(kShards)) return checked(id, number(kShards), id_name);
  const std::int64_t count = number(array + "COUNT"), first = number(array + "MIN");
  const bool has_step = environment((array + "STEP").c_str()) != nullptr;
  const std::int64_t step = has_step ? number(array + "STEP") : 1;
  const bool has_last = environment((array + "MAX").c_str()) != nullptr;
  if (step < 1 || (id - first) % step != 0 ||
      (has_last && first + (count - 1) * step != number(array + "MAX")))
    throw UsageError("environment: the tasks of this array of Slurm are not FIRST-LAST:STEP; " +
                     std::string(kShards) +
                     "=N makes the task of number I, 1 to N, shard I of N; --shard I/N does, too");
  return checked((id - first) / step + 1, count, id_name);
}

}  // namespace

std::string Shard::fileName(const std::string& stem, const std::string& extension) const {
  if (count == 1) return stem + extension;
  return stem + "." + std::to_string(index) + "of" + std::to_string(count) + extension;
}

std::optional<Shard> shardOfTable(std::string_view name) {
  constexpr std::string_view kHead = "runs.", kTail = ".csv";
  if (name.size() <= kHead.size() + kTail.size() || name.substr(0, kHead.size()) != kHead ||
      name.substr(name.size() - kTail.size()) != kTail)
    return std::nullopt;
  const auto shard =
      shardIn(name.substr(kHead.size(), name.size() - kHead.size() - kTail.size()), "of");
  return shard && shard->fileName("runs", ".csv") == name ? shard : std::nullopt;
}

Shard parseShard(const std::string& text) {
  if (const std::optional<Shard> shard = shardIn(text, "/")) return *shard;
  throw UsageError("--shard: must be I/N with 1 <= I <= N <= " + std::to_string(kMaxSweepRuns) +
                   ", got '" + printable(text) + "'");
}

LaunchedShard launchedShard(const Environment& environment) {
  if (environment("SLURM_ARRAY_TASK_ID")) return slurmShard(environment);
  for (const auto& [rank, size] : {std::pair{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                   std::pair{"PMI_RANK", "PMI_SIZE"}})
    if (environment(rank))
      return checked(numberIn(environment, rank, rank) + 1, numberIn(environment, size, rank),
                     rank);
  // a batch script has a SLURM_PROCID, too, but is no task of a step
  const char *const task = "SLURM_PROCID", *const tasks = "SLURM_STEP_NUM_TASKS";
  if (environment(task) && environment(tasks))
    return checked(numberIn(environment, task, tasks) + 1, numberIn(environment, tasks, task),
                   task);
  // says how many processes there are to a library of PMIx alone
  if (environment("PMIX_RANK"))
    return checked(numberIn(environment, "PMIX_RANK", "PMIX_RANK") + 1,
                   numberIn(environment, kShards, "PMIX_RANK"), "PMIX_RANK");
  if (environment("PARALLEL_SEQ") && environment(kShards))
    return checked(numberIn(environment, "PARALLEL_SEQ", kShards),
                   numberIn(environment, kShards, "PARALLEL_SEQ"), "PARALLEL_SEQ");
  return {};
}

}  // namespace rigid_body_sim
