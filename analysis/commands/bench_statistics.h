// `foveola bench statistics`: whether intervals and tests keep what they promise.
#pragma once

#include <stop_token>

namespace CLI {
class App;
}

namespace foveola::analysis {

/// Adds `statistics` to the command `bench`. It throws Error if a figure that is asked is not met;
/// `stop` ends it without figures.
void add_bench_statistics(CLI::App& bench, const std::stop_token& stop);

}  // namespace foveola::analysis
