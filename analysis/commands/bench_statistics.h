// `foveola bench statistics`: whether intervals cover and tests reject as often as they should.
#pragma once

#include <stop_token>

namespace CLI {
class App;
}

namespace foveola::analysis {

/// Adds `statistics` to the command `bench`. It throws Error if a figure lies outside its required
/// range; `stop` ends it without figures.
void add_bench_statistics(CLI::App& bench, const std::stop_token& stop);

}  // namespace foveola::analysis
