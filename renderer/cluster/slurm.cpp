#include "renderer/cluster/slurm.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "renderer/base/error.h"
#include "renderer/base/programs.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

/// What the program printed. Throws Error if it failed.
std::string printed_by(const std::vector<std::string>& words, const std::string& remedy) {
  try {
    const ProgramEnd end = run_to_end({.words = words});
    if (end.status != 0) {
      throw Error(words.front(),
                  end.errors.empty() ? failure_named(end.status) : "says: " + end.errors, remedy);
    }
    return end.output;
  } catch (const std::system_error& failure) {
    throw Error(words.front(), std::string("cannot be run: ") + failure.code().message(),
                "install Slurm's commands, or run the plan on this machine with --local");
  }
}

/// 0 for what is no number.
template <typename Number>
Number number_in(const std::string& text) {
  Number number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

}  // namespace

std::uint64_t submit_to_slurm(const fs::path& script, const std::vector<std::string>& further) {
  std::vector<std::string> words = {"sbatch", "--parsable"};
  words.insert(words.end(), further.begin(), further.end());
  words.push_back(script.string());
  // "123", or "123;cluster".
  const std::string printed = printed_by(words, "mend it in the plan or with the options");
  const auto job = number_in<std::uint64_t>(printed);
  if (job == 0) {
    throw Error("sbatch", "printed no number of a job: " + printed);
  }
  return job;
}

void cancel_in_slurm(std::uint64_t job) {
  run_to_end({.words = {"scancel", fmt::format("{}", job)}});
}

std::vector<QueuedTask> queued_in_slurm() {
  const std::string printed =
      printed_by({"squeue", "--noheader", "--array", fmt::format("--user={}", ::getuid()),
                  "--format=%F %K %T %r"},
                 "ask again when Slurm answers");
  std::vector<QueuedTask> tasks;
  std::istringstream lines(printed);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::string job;
    std::string number;
    QueuedTask task;
    fields >> job >> number >> task.state;
    std::getline(fields >> std::ws, task.reason);
    task.job = number_in<std::uint64_t>(job);
    task.number = number_in<std::int64_t>(number);
    tasks.push_back(std::move(task));
  }
  return tasks;
}

}  // namespace foveola
