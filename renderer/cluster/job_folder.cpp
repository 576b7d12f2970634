#include "renderer/cluster/job_folder.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "renderer/base/build_info.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

constexpr std::array stages = {Stage::prepare, Stage::shards, Stage::merge};

fs::path jobs_of(const fs::path& results) { return results / folder_of_jobs; }

fs::path lock_of(const fs::path& results) { return jobs_of(results) / ".lock"; }

void make_folder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) {
    throw Error(folder.string(), "cannot be made: " + failure.message(),
                "choose another folder with --output");
  }
}

}  // namespace

const char* name_of(Stage stage) {
  switch (stage) {
    case Stage::prepare:
      return "prepare";
    case Stage::shards:
      return "shard";
    case Stage::merge:
      break;
  }
  return "merge";
}

std::string parts_in_words(Stage stage, std::size_t count) {
  const char* const plural = count == 1 ? "" : "s";
  switch (stage) {
    case Stage::prepare:
      return fmt::format("{} part{} of preparing", count, plural);
    case Stage::shards:
      return fmt::format("{} shard{}", count, plural);
    case Stage::merge:
      break;
  }
  return "the merge";
}

JobFolder::JobFolder(const fs::path& results, const ClusterJob& job)
    : path_(jobs_of(results) / job.name),
      output_(results / job.output),
      part_extension_(job.command.part_extension),
      shards_(job.shards),
      prepare_shards_(job.prepare_shards) {}

fs::path JobFolder::script(Stage stage) const {
  return path_ / fmt::format("{}.sh", name_of(stage));
}

fs::path JobFolder::log(Stage stage, std::int64_t number) const {
  const std::string of_part = stage == Stage::merge ? "" : fmt::format("-{}", number);
  return path_ / "logs" / fmt::format("{}{}.log", name_of(stage), of_part);
}

fs::path JobFolder::done(Stage stage, std::int64_t number) const {
  switch (stage) {
    case Stage::prepare:
      return path_ / "prepared" / fmt::format("{}", number);
    case Stage::shards:
      return path_ / "parts" / fmt::format("{}{}", number, part_extension_);
    case Stage::merge:
      break;
  }
  return output_;
}

std::int64_t JobFolder::count(Stage stage) const {
  switch (stage) {
    case Stage::prepare:
      return prepare_shards_;
    case Stage::shards:
      return shards_;
    case Stage::merge:
      break;
  }
  return 1;
}

std::vector<std::int64_t> JobFolder::missing(Stage stage) const {
  std::vector<std::int64_t> numbers;
  for (std::int64_t number = 1; number <= count(stage); ++number) {
    if (!fs::exists(done(stage, number))) {
      numbers.push_back(number);
    }
  }
  return numbers;
}

void JobFolder::make() const {
  for (const char* inner : {"parts", "prepared", "unfinished", "logs"}) {
    make_folder(path_ / inner);
  }
}

std::map<Stage, std::uint64_t> JobFolder::slurm_jobs() const {
  std::map<Stage, std::uint64_t> jobs;
  std::ifstream file(path_ / "slurm.txt");
  std::string name;
  std::uint64_t number = 0;
  while (file >> name >> number) {
    for (const Stage stage : stages) {
      if (name == name_of(stage)) {
        jobs[stage] = number;
      }
    }
  }
  return jobs;
}

void JobFolder::keep_slurm_jobs(const std::map<Stage, std::uint64_t>& jobs) const {
  std::string text;
  for (const auto& [stage, number] : jobs) {
    text += fmt::format("{} {}\n", name_of(stage), number);
  }
  write_file(path_ / "slurm.txt", text);
}

std::string last_line(const fs::path& log) {
  constexpr std::streamoff most_bytes = 4096;
  std::ifstream file(log, std::ios::binary | std::ios::ate);
  if (!file) {
    return "";
  }
  file.seekg(std::max<std::streamoff>(0, file.tellg() - most_bytes));
  std::string last;
  for (std::string line; std::getline(file, line);) {
    if (line.find_first_not_of(" \t\r") != line.npos) {
      last = line;
    }
  }
  return last;
}

void begin_results(const fs::path& results, const ClusterPlan& plan) {
  make_folder(jobs_of(results));
  const std::string program = exact_name(build_info());
  const auto begin_or_compare = [&](const char* name, const std::string& now,
                                    const std::string& what) {
    const fs::path file = jobs_of(results) / name;
    if (!fs::exists(file)) {
      write_file(file, now);
    } else if (read_file(file) != now) {
      throw Error(results.string(), "was begun with another " + what,
                  "name another folder with --output, or remove this one");
    }
  };
  begin_or_compare("plan.toml", plan.text, "plan");
  begin_or_compare("program.txt", program, "program than this, " + program);
}

ResultsLock::ResultsLock(const fs::path& results)
    : descriptor_(::open(lock_of(results).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
  if (descriptor_ < 0) {
    throw Error(results.string(), "cannot be written", "choose another folder with --output");
  }
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    ::close(descriptor_);
    throw Error(results.string(), "another process runs or submits this plan",
                "wait until it has ended");
  }
}

ResultsLock::~ResultsLock() { ::close(descriptor_); }

bool is_locked(const fs::path& results) {
  const int descriptor = ::open(lock_of(results).c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    return false;
  }
  const bool is_held = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0;
  ::close(descriptor);
  return is_held;
}

}  // namespace foveola
