#include "renderer/cluster/cluster_command.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/print.h"
#include "renderer/base/shard.h"
#include "renderer/cluster/cluster_plan.h"
#include "renderer/cluster/job_status.h"
#include "renderer/cluster/submission.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

struct ClusterArguments {
  std::string plan;
  std::string output;  ///< empty: beside the plan
  std::string partition;
  std::int64_t at_once = 0;
  bool dry_run = false;
  bool local = false;
  bool wait = false;
  bool json = false;
};

fs::path results_of(const ClusterArguments& arguments, const ClusterPlan& plan) {
  const fs::path folder = arguments.output.empty()
                              ? plan.folder() / plan.file.stem()
                              : fs::absolute(arguments.output).lexically_normal();
  return folder.has_filename() ? folder : folder.parent_path();
}

void run_submit(const ClusterArguments& arguments, const std::stop_token& stop) {
  const ClusterPlan plan = read_cluster_plan(arguments.plan);
  const SubmitSettings settings{.results = results_of(arguments, plan),
                                .partition = arguments.partition,
                                .at_once = arguments.at_once};
  if (arguments.dry_run) {
    print_text("{}", dry_run(plan, settings));
  } else if (arguments.local) {
    run_plan_here(plan, settings, stop);
  } else {
    print_text("{}", submit(plan, settings));
  }
}

std::vector<JobStatus> statuses(const ClusterPlan& plan, const fs::path& results) {
  const bool runs_here = is_locked(results);
  const bool is_in_slurm = std::ranges::any_of(plan.jobs, [&](const ClusterJob& job) {
    return !JobFolder(results, job).slurm_jobs().empty();
  });
  // The queue is asked first: what leaves it meanwhile is then found done.
  const std::vector<QueuedTask> tasks = is_in_slurm ? queued_in_slurm() : std::vector<QueuedTask>();
  std::vector<JobStatus> of_jobs;
  for (const ClusterJob& job : plan.jobs) {
    of_jobs.push_back(status_of(job, JobFolder(results, job), tasks, runs_here));
  }
  return of_jobs;
}

nlohmann::ordered_json json_of(const JobStatus& status) {
  nlohmann::ordered_json stages = nlohmann::ordered_json::array();
  for (const StageStatus& stage : status.stages) {
    nlohmann::ordered_json parts = nlohmann::ordered_json::array();
    for (const PartStatus& part : stage.parts) {
      parts.push_back(
          {{"number", part.number}, {"state", name_of(part.state)}, {"last_line", part.last_line}});
    }
    stages.push_back({{"stage", name_of(stage.stage)}, {"parts", std::move(parts)}});
  }
  return {{"job", status.name}, {"output", status.output.string()}, {"stages", std::move(stages)}};
}

void print(const std::vector<JobStatus>& of_jobs, bool as_json) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const JobStatus& status : of_jobs) {
    if (as_json) {
      list.push_back(json_of(status));
    } else {
      print_text("{}", in_words(status));
    }
  }
  if (as_json) {
    print_text("{}\n", list.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  }
}

void run_status(const ClusterArguments& arguments, const std::stop_token& stop) {
  constexpr std::chrono::seconds between_looks(2);
  const ClusterPlan plan = read_cluster_plan(arguments.plan);
  const fs::path results = results_of(arguments, plan);
  if (!fs::is_directory(results / folder_of_jobs)) {
    throw Error(results.string(), "has no results of this plan", "submit it first");
  }
  std::vector<JobStatus> of_jobs = statuses(plan, results);
  while (arguments.wait && std::ranges::any_of(of_jobs, is_under_way) && !stop.stop_requested()) {
    std::this_thread::sleep_for(between_looks);
    of_jobs = statuses(plan, results);
  }
  print(of_jobs, arguments.json);
  if (arguments.wait && std::ranges::any_of(of_jobs, has_failed)) {
    throw Error(plan.file.string(), "something failed", "mend it, and submit the plan again");
  }
}

void add_plan(CLI::App& command, ClusterArguments& arguments) {
  command.add_option("PLAN", arguments.plan, "The plan: a .toml file; see docs/CLUSTER.md")
      ->required();
  command.add_option("-o,--output", arguments.output,
                     "The folder of results, which all machines see (default: named as the plan, "
                     "beside it)");
}

void add_submit(CLI::App& cluster, const std::stop_token& stop) {
  const auto arguments = std::make_shared<ClusterArguments>();
  CLI::App* command = cluster.add_subcommand(
      "submit", "Submit what is not done of a plan to Slurm, or run it on this machine");
  add_plan(*command, *arguments);
  command->add_option("--partition", arguments->partition,
                      "Slurm's partition (default: Slurm's own)");
  command
      ->add_option(
          "--nodes", arguments->at_once,
          "How many shards run at a time, each on a node by itself unless the plan says of "
          "how many cores; with --local processes here (default: as many as Slurm has room "
          "for; with --local one)")
      ->check(CLI::Range(std::int64_t{1}, most_shards));
  CLI::Option* const dry =
      command->add_flag("--dry-run", arguments->dry_run, "Print the scripts, and submit nothing");
  command
      ->add_flag("--local", arguments->local,
                 "Run the same scripts on this machine, without Slurm: with the same result")
      ->excludes(dry);
  command->footer("Example: foveola cluster submit night.toml --partition compute --nodes 8");
  command->callback([arguments, stop] { run_submit(*arguments, stop); });
}

void add_status(CLI::App& cluster, const std::stop_token& stop) {
  const auto arguments = std::make_shared<ClusterArguments>();
  CLI::App* command =
      cluster.add_subcommand("status", "Say how far the jobs of a plan have come, and what failed");
  add_plan(*command, *arguments);
  command->add_flag("--wait", arguments->wait,
                    "Wait until nothing runs or waits any more; fail if something has failed");
  command->add_flag("--json", arguments->json, "Print it as JSON");
  command->footer("Example: foveola cluster status night.toml");
  command->callback([arguments, stop] { run_status(*arguments, stop); });
}

}  // namespace

void add_cluster(CLI::App& app, const std::stop_token& stop) {
  CLI::App* cluster = app.add_subcommand(
      "cluster", "Run long work in shards, on a cluster with Slurm or on this machine");
  cluster->require_subcommand(1);
  add_submit(*cluster, stop);
  add_status(*cluster, stop);
}

}  // namespace foveola
