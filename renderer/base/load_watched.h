// Loads what may be large: with a line of progress, and so that it can be stopped.
#pragma once

#include <stop_token>

#include "renderer/base/progress.h"
#include "renderer/base/work_scope.h"

namespace foveola {

/// Returns what `load` returns. Shows the steps that it reports on standard error. Throws
/// WorkStopped soon after `stop` is requested.
template <typename Load>
auto load_watched(const std::stop_token& stop, const Load& load) {
  StepProgress progress("loading: ");
  const WorkScope scope(
      stop, [&](const char* step, double fraction_done) { progress.update(step, fraction_done); });
  return load();
}

}  // namespace foveola
