#include "renderer/cluster/submission.h"

#include <algorithm>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/print.h"
#include "renderer/base/programs.h"
#include "renderer/base/progress.h"
#include "renderer/cluster/job_scripts.h"
#include "renderer/cluster/job_status.h"
#include "renderer/cluster/local_run.h"
#include "renderer/cluster/slurm.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

ScriptSetting setting_of(const ClusterPlan& plan, const SubmitSettings& settings) {
  ScriptSetting setting{.program = own_program(),
                        .plan_folder = plan.folder(),
                        .plan_name = plan.file.filename().string(),
                        .slurm_options = plan.slurm_options,
                        .at_once = settings.at_once};
  if (!settings.partition.empty()) {
    setting.slurm_options.push_back("--partition=" + settings.partition);
  }
  return setting;
}

std::vector<Stage> stages_of(const ClusterJob& job) {
  return job.prepare_shards > 0 ? std::vector<Stage>{Stage::prepare, Stage::shards, Stage::merge}
                                : std::vector<Stage>{Stage::shards, Stage::merge};
}

/// The stages that have something left to do, with the parts of each. Caches are filled for shards
/// only.
std::map<Stage, std::vector<std::int64_t>> left_to_do(const ClusterJob& job,
                                                      const JobFolder& folder) {
  std::map<Stage, std::vector<std::int64_t>> left;
  if (folder.missing(Stage::merge).empty()) {
    return left;
  }
  for (const Stage stage : stages_of(job)) {
    std::vector<std::int64_t> missing = folder.missing(stage);
    if (!missing.empty()) {
      left[stage] = std::move(missing);
    }
  }
  if (!left.contains(Stage::shards)) {
    left.erase(Stage::prepare);
  }
  return left;
}

void write_scripts(const ClusterJob& job, const JobFolder& folder, const ScriptSetting& setting) {
  folder.make();
  for (const Stage stage : stages_of(job)) {
    // What was edited is not written again.
    if (!fs::exists(folder.script(stage))) {
      write_file(folder.script(stage), job_script(stage, setting, job, folder));
    }
  }
}

/// sbatch's options, which come before those in the script: that may be of an earlier submission.
std::vector<std::string> options_of(Stage stage, const std::vector<std::int64_t>& parts,
                                    const SubmitSettings& settings, const std::string& after) {
  std::vector<std::string> options;
  if (!settings.partition.empty()) {
    options.push_back("--partition=" + settings.partition);
  }
  if (stage != Stage::merge) {
    const std::string limit = settings.at_once > 0 ? fmt::format("%{}", settings.at_once) : "";
    options.push_back(fmt::format("--array={}{}", number_ranges(parts), limit));
  }
  if (!after.empty()) {
    options.push_back("--dependency=afterok:" + after);
    options.emplace_back("--kill-on-invalid-dep=yes");
  }
  return options;
}

void require_not_queued(const ClusterJob& job, const JobFolder& folder,
                        const std::vector<QueuedTask>& tasks) {
  for (const auto& [stage, number] : folder.slurm_jobs()) {
    if (std::ranges::find(tasks, number, &QueuedTask::job) != tasks.end()) {
      throw Error(job.name, fmt::format("is still in Slurm's queue as job {}", number),
                  fmt::format("wait for it, or take it out with scancel {}", number));
    }
  }
}

/// Submits stage after stage. If one is refused, those before are taken back.
std::string submit_job(const ClusterJob& job, const JobFolder& folder,
                       const SubmitSettings& settings) {
  const std::map<Stage, std::vector<std::int64_t>> left = left_to_do(job, folder);
  if (left.empty()) {
    return fmt::format("{}: merged already: {}\n", job.name, folder.output().string());
  }
  std::map<Stage, std::uint64_t> submitted;
  std::string after;
  try {
    for (const auto& [stage, parts] : left) {
      submitted[stage] =
          submit_to_slurm(folder.script(stage), options_of(stage, parts, settings, after));
      after = fmt::format("{}", submitted[stage]);
    }
    folder.keep_slurm_jobs(submitted);
  } catch (...) {
    for (const auto& [stage, number] : submitted) {
      cancel_in_slurm(number);
    }
    throw;
  }
  std::string line = job.name + ":";
  for (const auto& [stage, number] : submitted) {
    line += fmt::format(" {} as job {}{}", parts_in_words(stage, left.at(stage).size()), number,
                        stage == Stage::merge ? "\n" : ",");
  }
  return line;
}

std::vector<ScriptEnd> run_stage_here(const ClusterJob& job, const JobFolder& folder, Stage stage,
                                      const std::vector<std::int64_t>& parts, std::int64_t at_once,
                                      const std::stop_token& stop) {
  Progress progress(fmt::format("{}: {}", job.name, parts_in_words(stage, parts.size())));
  const auto ended = [&](std::size_t count) {
    progress.update(static_cast<double>(count) / static_cast<double>(parts.size()));
  };
  return run_here(folder, stage, parts, at_once, ended, stop);
}

/// Runs what is left of a job; returns whether it is merged.
bool run_job_here(const ClusterJob& job, const JobFolder& folder, std::int64_t at_once,
                  const std::stop_token& stop) {
  for (const auto& [stage, parts] : left_to_do(job, folder)) {
    const std::vector<ScriptEnd> failed = run_stage_here(job, folder, stage, parts, at_once, stop);
    for (const ScriptEnd& end : failed) {
      const fs::path log = folder.log(stage, end.number);
      print_text(stderr, "foveola: {}: {} {} failed ({}): {}; see {}\n", job.name, name_of(stage),
                 end.number, failure_named(end.status), last_line(log), log.string());
    }
    if (!failed.empty() || stop.stop_requested()) {
      return false;
    }
  }
  print_text("{}: {}\n", job.name, folder.output().string());
  return true;
}

}  // namespace

std::string dry_run(const ClusterPlan& plan, const SubmitSettings& settings) {
  const ScriptSetting setting = setting_of(plan, settings);
  std::string text;
  for (const ClusterJob& job : plan.jobs) {
    const JobFolder folder(settings.results, job);
    std::string after;
    for (const auto& [stage, parts] : left_to_do(job, folder)) {
      text += fmt::format("# {}\n{}\n", folder.script(stage).string(),
                          job_script(stage, setting, job, folder));
      text += "# sbatch";
      for (const std::string& option : options_of(stage, parts, settings, after)) {
        text += " " + option;
      }
      text += fmt::format(" {}\n\n", shell_quoted(folder.script(stage).string()));
      after = fmt::format("<number of {}.sh>", name_of(stage));
    }
  }
  return text;
}

std::string submit(const ClusterPlan& plan, const SubmitSettings& settings) {
  const std::vector<QueuedTask> tasks = queued_in_slurm();
  begin_results(settings.results, plan);
  const ResultsLock lock(settings.results);
  std::string text;
  for (const ClusterJob& job : plan.jobs) {
    const JobFolder folder(settings.results, job);
    require_not_queued(job, folder, tasks);
    write_scripts(job, folder, setting_of(plan, settings));
    text += submit_job(job, folder, settings);
  }
  return text;
}

void run_plan_here(const ClusterPlan& plan, const SubmitSettings& settings,
                   const std::stop_token& stop) {
  begin_results(settings.results, plan);
  const ResultsLock lock(settings.results);
  std::string failed;
  for (const ClusterJob& job : plan.jobs) {
    const JobFolder folder(settings.results, job);
    write_scripts(job, folder, setting_of(plan, settings));
    if (!run_job_here(job, folder, std::max<std::int64_t>(1, settings.at_once), stop)) {
      failed += (failed.empty() ? "" : ", ") + job.name;
    }
  }
  if (stop.stop_requested()) {
    print_text("Stopped. The same command goes on.\n");
  } else if (!failed.empty()) {
    throw Error(plan.file.string(), "not done: " + failed,
                "mend it, and give the same command, which runs what is not done");
  }
}

}  // namespace foveola
