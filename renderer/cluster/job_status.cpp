#include "renderer/cluster/job_status.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace foveola {
namespace {

constexpr std::array states = {PartState::done, PartState::running, PartState::waiting,
                               PartState::ended, PartState::not_run};

std::optional<PartState> state_in_queue(std::uint64_t job, std::int64_t number,
                                        const std::vector<QueuedTask>& tasks) {
  const auto task = std::ranges::find_if(
      tasks, [&](const QueuedTask& each) { return each.job == job && each.number == number; });
  if (task == tasks.end()) {
    return std::nullopt;
  }
  return task->state == "PENDING" ? PartState::waiting : PartState::running;
}

/// What a stage's part is where Slurm's queue does not know it.
PartState state_by_log(bool has_log, bool runs_here) {
  if (!has_log) {
    return PartState::not_run;
  }
  return runs_here ? PartState::running : PartState::ended;
}

StageStatus status_of_stage(Stage stage, const JobFolder& folder,
                            const std::vector<QueuedTask>& tasks, bool runs_here) {
  StageStatus status{.stage = stage, .parts = {}};
  const std::map<Stage, std::uint64_t> jobs = folder.slurm_jobs();
  const auto job = jobs.find(stage);
  for (std::int64_t number = 1; number <= folder.count(stage); ++number) {
    const std::filesystem::path log = folder.log(stage, number);
    PartStatus part{.number = number, .state = PartState::done, .last_line = last_line(log)};
    if (!std::filesystem::exists(folder.done(stage, number))) {
      const std::optional<PartState> queued =
          job == jobs.end()
              ? std::nullopt
              : state_in_queue(job->second, stage == Stage::merge ? 0 : number, tasks);
      part.state = queued.value_or(state_by_log(!part.last_line.empty(), runs_here));
    }
    status.parts.push_back(std::move(part));
  }
  return status;
}

bool any(const JobStatus& status, std::initializer_list<PartState> wanted) {
  return std::ranges::any_of(status.stages, [&](const StageStatus& stage) {
    return std::ranges::any_of(wanted, [&](PartState state) { return stage.count(state) > 0; });
  });
}

std::string counts_in_words(const StageStatus& stage) {
  std::vector<std::string> counts;
  for (const PartState state : states) {
    if (const std::int64_t count = stage.count(state); count > 0) {
      counts.push_back(fmt::format("{} {}", count, name_of(state)));
    }
  }
  return fmt::format("{}: {}", parts_in_words(stage.stage, stage.parts.size()),
                     fmt::join(counts, ", "));
}

/// A line for each part that runs or has ended without being done.
std::string unfinished_in_words(const StageStatus& stage) {
  std::string text;
  for (const PartStatus& part : stage.parts) {
    if (part.state == PartState::running || part.state == PartState::ended) {
      text += fmt::format("    {} {} {}: {}\n", name_of(stage.stage), part.number,
                          name_of(part.state), part.last_line);
    }
  }
  return text;
}

std::string merge_in_words(const JobStatus& status, const PartStatus& merge) {
  switch (merge.state) {
    case PartState::done:
      return fmt::format("  merged: {}\n", status.output.string());
    case PartState::running:
      return "  merging\n";
    case PartState::waiting:
      return "  merging waits for the shards\n";
    case PartState::ended:
      return fmt::format("  merging failed: {}\n", merge.last_line);
    case PartState::not_run:
      break;
  }
  return has_failed(status) && !is_under_way(status)
             ? "  not merged, since something failed: mend it, and submit the plan again, which "
               "runs what is not done\n"
             : "  not merged\n";
}

}  // namespace

std::int64_t StageStatus::count(PartState state) const {
  return std::ranges::count(parts, state, &PartStatus::state);
}

JobStatus status_of(const ClusterJob& job, const JobFolder& folder,
                    const std::vector<QueuedTask>& tasks, bool runs_here) {
  JobStatus status{.name = job.name, .output = folder.output(), .stages = {}};
  if (job.prepare_shards > 0) {
    status.stages.push_back(status_of_stage(Stage::prepare, folder, tasks, runs_here));
  }
  status.stages.push_back(status_of_stage(Stage::shards, folder, tasks, runs_here));
  status.stages.push_back(status_of_stage(Stage::merge, folder, tasks, runs_here));
  return status;
}

bool is_under_way(const JobStatus& status) {
  return any(status, {PartState::running, PartState::waiting});
}

bool has_failed(const JobStatus& status) { return any(status, {PartState::ended}); }

std::string in_words(const JobStatus& status) {
  std::string text = status.name + "\n";
  for (const StageStatus& stage : status.stages) {
    text += stage.stage == Stage::merge
                ? merge_in_words(status, stage.parts.front())
                : fmt::format("  {}\n{}", counts_in_words(stage), unfinished_in_words(stage));
  }
  return text;
}

const char* name_of(PartState state) {
  switch (state) {
    case PartState::done:
      return "done";
    case PartState::running:
      return "running";
    case PartState::waiting:
      return "waiting";
    case PartState::ended:
      return "failed";
    case PartState::not_run:
      break;
  }
  return "not run";
}

}  // namespace foveola
