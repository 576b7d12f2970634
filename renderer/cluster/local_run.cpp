#include "renderer/cluster/local_run.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "renderer/cluster/job_scripts.h"

namespace foveola {
namespace {

constexpr std::chrono::milliseconds between_looks(20);
constexpr mode_t readable_by_all = 0644;

/// Starts `bash SCRIPT NUMBER` in a process group of its own, so that Ctrl-C in the terminal
/// reaches this program alone, which then ends what it has started. Its signals are not blocked.
pid_t start(const std::filesystem::path& script, std::int64_t number,
            const std::filesystem::path& log) {
  std::array<std::string, 3> words = {"bash", script.string(), fmt::format("{}", number)};
  std::array<char*, 4> arguments = {words[0].data(), words[1].data(), words[2].data(), nullptr};
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_addopen(&streams, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&streams, STDOUT_FILENO, log.c_str(),
                                   O_WRONLY | O_CREAT | O_APPEND, readable_by_all);
  posix_spawn_file_actions_adddup2(&streams, STDOUT_FILENO, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  ::sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
  pid_t process = 0;
  const int failure =
      ::posix_spawnp(&process, arguments[0], &streams, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&streams);
  if (failure != 0) {
    throw std::system_error(failure, std::generic_category(), "bash");
  }
  return process;
}

bool asks_for_another_try(int status) {
  return WIFEXITED(status) && WEXITSTATUS(status) == run_again_exit_code;
}

/// The scripts that run, and those that wait for their turn.
class Scripts {
 public:
  Scripts(const JobFolder& folder, Stage stage, const std::vector<std::int64_t>& numbers)
      : folder_(folder), stage_(stage), waiting_(numbers.begin(), numbers.end()) {}
  ~Scripts() { end_all(); }
  Scripts(const Scripts&) = delete;
  Scripts& operator=(const Scripts&) = delete;

  bool are_over() const { return waiting_.empty() && running_.empty(); }

  void begin(std::int64_t at_once) {
    while (!waiting_.empty() && static_cast<std::int64_t>(running_.size()) < at_once) {
      const std::int64_t number = waiting_.front();
      waiting_.pop_front();
      running_[start(folder_.script(stage_), number, folder_.log(stage_, number))] = number;
    }
  }

  std::size_t left() const { return waiting_.size() + running_.size(); }

  /// Takes notice of those that have ended; returns whether any has.
  bool collect() {
    const std::size_t before = running_.size();
    for (auto running = running_.begin(); running != running_.end();) {
      int status = 0;
      if (::waitpid(running->first, &status, WNOHANG) != running->first) {
        ++running;
        continue;
      }
      if (asks_for_another_try(status)) {
        waiting_.push_back(running->second);
      } else if (status != 0) {
        failed_.push_back({.number = running->second, .status = status});
      }
      running = running_.erase(running);
    }
    return running_.size() < before;
  }

  /// Asks those that run to end, and waits until they have kept what they have.
  void end_all() {
    waiting_.clear();
    for (const auto& [process, number] : running_) {
      ::kill(process, SIGTERM);
    }
    for (const auto& [process, number] : running_) {
      int status = 0;
      while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
      }
    }
    running_.clear();
  }

  std::vector<ScriptEnd> failed() && {
    std::ranges::sort(failed_, {}, &ScriptEnd::number);
    return std::move(failed_);
  }

 private:
  const JobFolder& folder_;
  Stage stage_;
  std::deque<std::int64_t> waiting_;
  std::map<pid_t, std::int64_t> running_;
  std::vector<ScriptEnd> failed_;
};

}  // namespace

std::vector<ScriptEnd> run_here(const JobFolder& folder, Stage stage,
                                const std::vector<std::int64_t>& numbers, std::int64_t at_once,
                                const std::function<void(std::size_t)>& ended,
                                const std::stop_token& stop) {
  Scripts scripts(folder, stage, numbers);
  while (!scripts.are_over() && !stop.stop_requested()) {
    scripts.begin(at_once);
    std::this_thread::sleep_for(between_looks);
    if (scripts.collect()) {
      ended(numbers.size() - scripts.left());
    }
  }
  return std::move(scripts).failed();
}

}  // namespace foveola
