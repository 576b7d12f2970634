// `foveola bench merge`: the parts of a benchmark put together.
#pragma once

namespace CLI {
class App;
}

namespace foveola::analysis {

/// Adds `merge` to the command `bench`. It prints and writes what the benchmark would have without
/// parts, and throws Error where that would have.
void add_bench_merge(CLI::App& bench);

}  // namespace foveola::analysis
