// Loads what may be large: with a line of progress, and so that it can be stopped.
#pragma once

#include <stop_token>
#include <thread>

#include "renderer/base/progress.h"
#include "renderer/base/work_scope.h"

namespace foveola {

/// Exit code of a program that a signal stopped, as a shell gives for SIGINT.
inline constexpr int stopped_exit_code = 130;

/// Says on standard error that a load was stopped.
void print_load_stopped();

/// Returns what `load` returns. Shows the steps that it reports on standard error. Throws
/// WorkStopped soon after `stop` is requested.
template <typename Load>
auto load_watched(const std::stop_token& stop, const Load& load) {
  StepProgress progress("loading: ");
  const WorkScope scope(
      stop, [&](const char* step, double fraction_done) { progress.update(step, fraction_done); });
  return load();
}

/// While it lives: ends the program with stopped_exit_code and print_load_stopped, at once, if it
/// still lives 0.2 s after `stop` was requested. Parsers and decoders of libraries cannot be
/// stopped. For commands that have written nothing yet.
class StuckLoadExit {
 public:
  explicit StuckLoadExit(const std::stop_token& stop);

 private:
  std::jthread watcher_;  ///< asked to stop, and waited for, by its destructor
};

/// load_watched of a command that has written nothing yet: see StuckLoadExit.
template <typename Load>
auto load_or_exit(const std::stop_token& stop, const Load& load) {
  const StuckLoadExit exit(stop);
  return load_watched(stop, load);
}

}  // namespace foveola
