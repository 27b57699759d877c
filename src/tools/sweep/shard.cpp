#include "tools/sweep/shard.hpp"

#include <optional>
#include <string_view>

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

/// The number in a variable that must be set, beside another that is.
std::int64_t numberIn(const Environment& environment, const char* name, const char* beside) {
  const char* text = environment(name);
  const auto number = text ? numberOf(text) : std::nullopt;
  if (!number)
    throw UsageError("environment: " + std::string(name) + " must be a whole number up to " +
                     std::to_string(kMaxSweepRuns) + " beside " + beside + ", got " +
                     (text ? "'" + printable(std::string(text)) + "'" : "nothing"));
  return *number;
}

LaunchedShard checked(std::int64_t index, std::int64_t count, const std::string& by) {
  if (count < 1 || index < 1 || index > count)
    throw UsageError("environment: " + by + " makes this shard " + std::to_string(index) + " of " +
                     std::to_string(count) + "; --shard I/N says which it is");
  return {{index, count}, by};
}

LaunchedShard slurmShard(const Environment& environment) {
  const char* const kId = "SLURM_ARRAY_TASK_ID";
  const std::int64_t id = numberIn(environment, kId, kId);
  const std::int64_t count = numberIn(environment, "SLURM_ARRAY_TASK_COUNT", kId);
  const std::int64_t first = numberIn(environment, "SLURM_ARRAY_TASK_MIN", kId);
  const std::int64_t step = environment("SLURM_ARRAY_TASK_STEP")
                                ? numberIn(environment, "SLURM_ARRAY_TASK_STEP", kId)
                                : 1;
  if (step < 1 || (id - first) % step != 0)
    throw UsageError(
        "environment: SLURM_ARRAY_TASK_STEP does not lead from the first to this task");
  return checked((id - first) / step + 1, count, kId);
}

}  // namespace

std::string Shard::fileName(const std::string& stem, const std::string& extension) const {
  if (count == 1) return stem + extension;
  return stem + "." + std::to_string(index) + "of" + std::to_string(count) + extension;
}

Shard parseShard(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const auto index = numberOf(std::string_view(text).substr(0, slash));
    const auto count = numberOf(std::string_view(text).substr(slash + 1));
    if (index && count && *index >= 1 && *index <= *count) return {*index, *count};
  }
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
  if (environment("PARALLEL_SEQ") && environment("RIGID_BODY_SIM_SHARDS"))
    return checked(numberIn(environment, "PARALLEL_SEQ", "RIGID_BODY_SIM_SHARDS"),
                   numberIn(environment, "RIGID_BODY_SIM_SHARDS", "PARALLEL_SEQ"), "PARALLEL_SEQ");
  return {};
}

}  // namespace rigid_body_sim
