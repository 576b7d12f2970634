// `foveola bench statistics`: whether intervals cover and tests reject as often as they should.
#pragma once

#include <stop_token>
#include <vector>

#include "renderer/commands/bench_part.h"

namespace CLI {
class App;
}

namespace foveola::analysis {

/// Adds `statistics` to the command `bench`. It throws Error if a figure lies outside its required
/// range; `stop` ends it without figures.
void add_bench_statistics(CLI::App& bench, const std::stop_token& stop);

/// Prints of all parts of one `bench statistics` what it would have printed without parts, and
/// throws Error where it would have.
void merge_statistics(const std::vector<BenchPart>& parts, bool json);

}  // namespace foveola::analysis
