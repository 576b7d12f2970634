// `foveola bench compare`: the figures of two runs of a benchmark, side by side.
#pragma once

namespace CLI {
class App;
}

namespace foveola::analysis {

/// Adds `compare` to the command `bench`.
void add_bench_compare(CLI::App& bench);

}  // namespace foveola::analysis
